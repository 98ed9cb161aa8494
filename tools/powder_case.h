// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "powder/fluidisation.h"
#include "powder/plan.h"
#include "powder/sizes.h"
#include "powder_contacts.h"
#include "powder_vessel.h"

namespace cohesion::tools {

/// A coupled case of a powder: the files of powder-case beside this program, with what is the
/// powder's in constant/powder, grains, coupling, gravity and contacts, in grains.data, and for
/// LAMMPS in constant/walls. SI units.
struct PowderCase {
  bool liggghts;              ///< the engine, or else LAMMPS
  powder::PowderSizes sizes;  ///< of the spheres, which may be parcels
  double parcel;              ///< their diameter over that of grains
  PowderContacts contacts;
  powder::TimeSteps steps;
  powder::Gas gas;
  double gravity;
  std::string drag;
  double velocity;  ///< superficial
  double speed;     ///< with which grains settle at most, and which their springs bear

  /// Between two outputs; those of the files, and the end of the run, are multiples.
  static constexpr double output_interval = 0.01;

  /// endTime of powder-case/system/controlDict.
  static constexpr double run_time = 0.1;

  /// Steps of the particles until the end, those in which they settle included.
  double particle_steps(const PowderVessel& vessel) const {
    return (settling_time(vessel) + run_time) / steps.particle;
  }

  /// Throws std::runtime_error where the folder is there and not empty, or cannot be written.
  void write(const std::filesystem::path& folder, const PowderVessel& vessel) const {
    namespace fs = std::filesystem;
    if (fs::exists(folder) && !fs::is_empty(folder))
      throw std::runtime_error("--write " + folder.string() +
                               ": the folder is there and not empty; name a new one");
    const fs::path from = template_folder();
    fs::create_directories(folder);
    fs::copy(from, folder, fs::copy_options::recursive);
    // One mesh and one script of two.
    const fs::path system = folder / "system";
    const char* shapes[] = {"box", "column"};
    fs::rename(system / ("blockMeshDict." + std::string(shapes[vessel.is_round()])),
               system / "blockMeshDict");
    fs::remove(system / ("blockMeshDict." + std::string(shapes[!vessel.is_round()])));
    fs::remove(folder / (liggghts ? "grains.lmp" : "grains.liggghts"));
    write_powder(folder / "constant/powder", vessel);
    write_variables(folder / "constant/grains", vessel);
    write_coupling(folder / "constant/coupling", vessel);
    std::ofstream(folder / "constant/gravity") << "gravityOfPowder (0 0 " << -gravity << ");\n";
    write_contacts(folder / "constant/contacts");
    if (!liggghts) write_walls(folder / "constant/walls", vessel.is_round());
    write_grains(folder / "grains.data", vessel);
  }

 private:
  static std::filesystem::path template_folder() {
    const auto folder =
        std::filesystem::read_symlink("/proc/self/exe").parent_path() / "powder-case";
    if (!std::filesystem::exists(folder))
      throw std::runtime_error("the files of the case are not where they were installed, in " +
                               folder.string());
    return folder;
  }

  /// An OpenFOAM file of entries.
  class Entries {
   public:
    Entries(const std::filesystem::path& file, const char* title) : out_(file) {
      out_ << "// " << title << '\n';
      out_.precision(12);
    }
    template <class Value>
    Entries& operator()(const char* name, const Value& value) {
      const std::string text(name);
      out_ << text << std::string(text.size() < 24 ? 24 - text.size() : 1, ' ') << value << ";\n";
      return *this;
    }

   private:
    std::ofstream out_;
  };

  void write_powder(const std::filesystem::path& file, const PowderVessel& v) const {
    Entries entries(file, "Of the powder and its bed, SI units.");
    if (v.is_round()) {
      // The square's sides bulge.
      const double side = v.radius() * v.across_square() / v.cells(0), cosine = std::sqrt(0.5);
      entries("outer", cosine * v.reach())("outerArc", v.reach())("innerArc", side)(
          "inner", cosine * 7.0 / 6.0 * side)("acrossSquare", v.across_square())("rings",
                                                                                 v.rings());
    } else {
      entries("width", v.edge(0))("depth", v.edge(1))(
          "cells", "(" + std::to_string(v.cells(0)) + " " + std::to_string(v.cells(1)) + " " +
                       std::to_string(v.cells(2)) + ")");
    }
    entries("top", v.edge(2))("rows", v.cells(2))("velocity", velocity)("gasStep", steps.gas)(
        "gasDensity", gas.density)("gasKinematicViscosity", gas.viscosity / gas.density);
  }

  void write_variables(const std::filesystem::path& file, const PowderVessel& v) const {
    // A fifth of the skin is for the flights of two grains in a step: 3 m/s each.
    // LIGGGHTS sees a well at a wall within half of it, and its own margin.
    const double skin =
        std::max({0.2 * sizes.largest(), 30.0 * steps.particle,
                  1.1 * std::max(0.0, contacts.well_ratio - 0.98) * sizes.largest()});
    Entries entries(file, "Variables of the script, SI units.");
    entries("dt", steps.particle)("round", v.is_round() ? 1 : 0)("radius", v.radius())(
        "width", v.edge(0))("depth", v.edge(1))("top", v.edge(2))("gravity", gravity)("skin", skin)(
        "settle", settling_time(v))("slow", '"' + resistance() + '"');
    if (liggghts)
      entries("model", '"' + contacts.liggghts_model() + '"')(
          "keywords", '"' + contacts.liggghts_keywords() + '"')("wall", sizes.all().size() + 1);
  }

  /// Words of the engines' fix viscous, -gamma v on each type, in which grains sink at `speed`:
  /// those that fall freely through the lattice press their springs more than the run's impacts.
  std::string resistance() const {
    const auto gamma = [&](const powder::PowderSize& size) {
      return contacts.density * sphere_volume(0.5 * size.diameter) * gravity / speed;
    };
    std::ostringstream words;
    const double first = gamma(sizes.all().front());
    words << first;
    for (std::size_t k = 1; k < sizes.all().size(); k++)
      words << " scale " << k + 1 << ' ' << gamma(sizes.all()[k]) / first;
    return words.str();
  }

  /// The lattice, of a void fraction of 0.55, shrinks by a third of its height at most, at `speed`
  /// or as fast as grains fall; half as long again, to come to rest.
  double settling_time(const PowderVessel& v) const {
    const double height = v.height_of_lattice();
    return std::max({0.05, 1.5 * std::sqrt(2.0 * height / gravity), 0.5 * height / speed});
  }

  void write_coupling(const std::filesystem::path& file, const PowderVessel& v) const {
    Entries entries(file,
                    "Of couplingProperties: engine, laws, and how spheres are shared by cells.");
    // Among equal grains the law of mixtures would raise the drag by some per cent.
    entries("demEngine", liggghts ? "liggghts" : "lammps")("drag", drag)(
        "dragMixture", sizes.all().size() > 1 ? "vanDerHoef" : "none")("coarseGraining", parcel);
    // In cells that are no boxes sphereOverlap takes 500 points of a sphere, and this 29.
    entries("voidFraction", v.is_round() ? "dividedVolume" : "sphereOverlap");
  }

  void write_contacts(const std::filesystem::path& file) const {
    std::ofstream out(file);
    if (liggghts) {
      out << "# Contacts of grains.liggghts: a type for each size, the last is that of the "
             "walls.\n";
      for (const std::string& line : contacts.liggghts()) out << line << '\n';
      return;
    }
    out << "# Contacts of grains.lmp: a type for each size.\n"
        << "pair_style " << contacts.lammps_style() << " scheme exact\n";
    for (const std::string& line : contacts.lammps_pairs()) out << line << '\n';
  }

  /// LAMMPS' walls, whose contact is in the command.
  void write_walls(const std::filesystem::path& file, bool round) const {
    std::ofstream out(file);
    out << "# Walls of grains.lmp.\n";
    for (const PowderContacts::LammpsWall& wall : contacts.lammps_walls()) {
      const std::string suffix = wall.of_group.empty() ? "" : '_' + wall.group;
      const auto fix = [&](const char* name, const std::string& of) {
        out << "fix " << name << suffix << ' ' << wall.group << " wall/" << contacts.lammps_style()
            << ' ' << wall.contact << ' ' << of << " scheme exact\n";
      };
      if (!wall.of_group.empty()) out << wall.of_group << '\n';
      if (round) {
        fix("sides", "zcylinder ${radius}");
      } else {
        fix("side_x", "xplane 0 ${width}");
        fix("side_y", "yplane 0 ${depth}");
      }
      out << "# The plate, and a screen over the outlet: a grain that is thrown this high falls "
             "back.\n";
      fix("plate", "zplane 0 ${top}");
    }
  }

  void write_grains(const std::filesystem::path& file, const PowderVessel& v) const {
    std::ofstream out(file);
    out.precision(9);
    const std::size_t types = sizes.all().size() + (liggghts ? 1 : 0);
    out << "Grains\n\n" << v.grains() << " atoms\n" << types << " atom types\n\n";
    const char* names[] = {"x", "y", "z"};
    for (int k = 0; k < 3; k++)
      out << v.lower(k) << ' ' << v.upper(k) << ' ' << names[k] << "lo " << names[k] << "hi\n";
    out << "\nAtoms\n\n";
    int number = 0;
    v.for_each_grain([&](std::size_t size, const std::array<double, 3>& place) {
      out << ++number << ' ' << size + 1 << ' ' << sizes.all()[size].diameter << ' '
          << contacts.density << ' ' << place[0] << ' ' << place[1] << ' ' << place[2] << '\n';
    });
  }
};

}  // namespace cohesion::tools
