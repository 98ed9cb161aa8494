// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "powder/plan.h"
#include "powder/sizes.h"

namespace cohesion::tools {

/// A coupled case of a powder in a box: the files of powder-case beside this program, with what is
/// the powder's in constant/powder, constant/grains and grains.data. SI units.
struct PowderCase {
  powder::Sizes sizes;
  double density;       ///< of the grains
  std::string contact;  ///< words of pair_coeff
  double particle_step, gas_step, cell;
  double gas_density, gas_viscosity, gravity;
  double velocity;  ///< superficial

  /// A box of whole cells with a settled bed in it.
  struct Box {
    int cells[3];
    double grains;

    double edge(int k, double cell) const { return cells[k] * cell; }
  };

  /// Of the bed asked for, or, where that has more than so many grains, one of its shape that has
  /// not. The box is three times as high as the bed.
  Box box(double width, double depth, const powder::Bed& bed, double most) const {
    const double all = powder::number_of_grains(bed, sizes);
    const double scale = std::min(1.0, std::cbrt(most / all));
    const auto whole = [&](double length) {
      return std::max(2, static_cast<int>(std::floor(scale * length / cell)));
    };
    Box box{{whole(width), whole(depth), 0}, 0.0};
    const double height = scale * bed.height;
    box.cells[2] = 3 * std::max(2, static_cast<int>(std::ceil(height / cell)));
    box.grains = std::round(powder::number_of_grains(
        {box.edge(0, cell) * box.edge(1, cell), height, bed.void_fraction}, sizes));
    return box;
  }

  /// Throws std::runtime_error where the folder is there and not empty, or cannot be written.
  void write(const std::filesystem::path& folder, const Box& box) const {
    namespace fs = std::filesystem;
    if (fs::exists(folder) && !fs::is_empty(folder))
      throw std::runtime_error("--write " + folder.string() +
                               ": the folder is there and not empty; name a new one");
    fs::create_directories(folder);
    fs::copy(template_folder(), folder, fs::copy_options::recursive);
    std::ofstream(folder / "constant/powder") << gas_entries(box);
    std::ofstream(folder / "constant/grains") << script_variables(box);
    write_grains(folder / "grains.data", box);
  }

 private:
  static std::filesystem::path template_folder() {
    namespace fs = std::filesystem;
    const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
    for (const fs::path& place : {here / "powder-case", here / "../share/cohesion/powder-case"})
      if (fs::exists(place)) return place;
    throw std::runtime_error(
        "the files of powder-case are neither beside this program nor in ../share/cohesion");
  }

  static std::string entry(const char* name, double value) {
    char text[120];
    std::snprintf(text, sizeof text, "%-24s%.9g;\n", name, value);
    return text;
  }

  std::string gas_entries(const Box& b) const {
    return "// Of the powder and its bed, SI units.\n" + entry("width", b.edge(0, cell)) +
           entry("depth", b.edge(1, cell)) + entry("top", b.edge(2, cell)) +
           "cells                   (" + std::to_string(b.cells[0]) + " " +
           std::to_string(b.cells[1]) + " " + std::to_string(b.cells[2]) + ");\n" +
           entry("rows", b.cells[2]) + entry("velocity", velocity) + entry("gasStep", gas_step) +
           entry("gasDensity", gas_density) +
           entry("gasKinematicViscosity", gas_viscosity / gas_density);
  }

  std::string script_variables(const Box& b) const {
    // A fifth of the skin is for the flights of two grains in a step: 3 m/s each.
    const double skin = std::max(0.2 * sizes.largest(), 30.0 * particle_step);
    return "// Variables of grains.lmp, SI units.\n" + entry("dt", particle_step) +
           entry("width", b.edge(0, cell)) + entry("depth", b.edge(1, cell)) +
           entry("top", b.edge(2, cell)) + entry("gravity", gravity) + entry("skin", skin) +
           "contact                 \"" + contact + "\";\n";
  }

  /// Diameters in the numbers of the distribution, at random on a loose lattice.
  void write_grains(const std::filesystem::path& file, const Box& b) const {
    const auto count = static_cast<int>(b.grains);
    std::mt19937 random(4711);
    const std::vector<double> diameters = shuffled_diameters(count, random);
    const double spacing = 1.05 * sizes.largest();
    const int nx = std::max(1, static_cast<int>(b.edge(0, cell) / spacing));
    const int ny = std::max(1, static_cast<int>(b.edge(1, cell) / spacing));
    const double dx = b.edge(0, cell) / nx, dy = b.edge(1, cell) / ny;
    if ((count / (nx * ny) + 1) * spacing > b.edge(2, cell))
      throw std::runtime_error(
          "the grains do not fit loosely into a box three times as high as the bed: their sizes "
          "differ too much");
    std::ofstream out(file);
    out.precision(9);
    out << "Grains\n\n"
        << count << " atoms\n1 atom types\n\n0 " << b.edge(0, cell) << " xlo xhi\n0 "
        << b.edge(1, cell) << " ylo yhi\n0 " << b.edge(2, cell) << " zlo zhi\n\nAtoms # sphere\n\n";
    std::uniform_real_distribution<double> jitter(-0.02 * sizes.largest(), 0.02 * sizes.largest());
    for (int n = 0; n < count; n++)
      out << n + 1 << " 1 " << diameters[n] << ' ' << density << ' '
          << (n % nx + 0.5) * dx + jitter(random) << ' '
          << (n / nx % ny + 0.5) * dy + jitter(random) << ' ' << (n / (nx * ny) + 0.5) * spacing
          << '\n';
  }

  std::vector<double> shuffled_diameters(int count, std::mt19937& random) const {
    std::vector<double> diameters;
    double due = 0.0;
    for (const powder::Size& size : sizes.all()) {
      due += count * sizes.number_share(size);
      while (static_cast<double>(diameters.size()) + 0.5 < due) diameters.push_back(size.diameter);
    }
    diameters.resize(count, sizes.all().back().diameter);
    std::shuffle(diameters.begin(), diameters.end(), random);
    return diameters;
  }
};

}  // namespace cohesion::tools
