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
/// the powder's in constant/powder, grains, mixture and gravity and in grains.data. SI units.
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
  /// not. The box is three times as high as the bed, or as the lattice that the grains are poured
  /// from.
  Box box(double width, double depth, const powder::Bed& bed, double most) const {
    const double all = powder::number_of_grains(bed, sizes);
    const double scale = std::min(1.0, std::cbrt(most / all));
    const auto whole = [&](double length) {
      // A whole number of cells stays one.
      return std::max(2, static_cast<int>(std::floor(scale * length / cell * (1.0 + 1e-9))));
    };
    Box box{{whole(width), whole(depth), 0}, 0.0};
    const double height = scale * bed.height;
    box.cells[2] = 3 * std::max(2, static_cast<int>(std::ceil(height / cell)));
    box.grains = std::round(powder::number_of_grains(
        {box.edge(0, cell) * box.edge(1, cell), height, bed.void_fraction}, sizes));
    box.cells[2] =
        std::max(box.cells[2], static_cast<int>(std::ceil(height_of_lattice(box) / cell)));
    return box;
  }

  /// Throws std::runtime_error where the folder is there and not empty, or cannot be written.
  void write(const std::filesystem::path& folder, const Box& box) const {
    namespace fs = std::filesystem;
    if (fs::exists(folder) && !fs::is_empty(folder))
      throw std::runtime_error("--write " + folder.string() +
                               ": the folder is there and not empty; name a new one");
    const fs::path from = template_folder();
    fs::create_directories(folder);
    fs::copy(from, folder, fs::copy_options::recursive);
    std::ofstream(folder / "constant/powder") << gas_entries(box);
    std::ofstream(folder / "constant/grains") << script_variables(box);
    // Among equal grains the law would raise the drag by some per cent.
    std::ofstream(folder / "constant/mixture")
        << "dragMixture     " << (sizes.all().size() > 1 ? "vanDerHoef" : "none") << ";\n";
    std::ofstream(folder / "constant/gravity") << "gravityOfPowder (0 0 " << -gravity << ");\n";
    write_grains(folder / "grains.data", box);
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
           entry("settle", std::max(0.05, 1.5 * std::sqrt(2.0 * height_of_lattice(b) / gravity))) +
           "contact                 \"" + contact + "\";\n";
  }

  /// Grains of one size, a layer of the loose lattice that they are poured from.
  struct Layer {
    double diameter;
    int across[2];
    int grains;

    double thickness() const { return 1.05 * diameter; }
  };

  /// The grains of all sizes, layers of them in any order.
  std::vector<Layer> layers(const Box& box) const {
    std::vector<Layer> all;
    int left = static_cast<int>(box.grains);
    for (const powder::Size& size : sizes.all()) {
      Layer layer{size.diameter, {1, 1}, 0};
      for (int k = 0; k < 2; k++)
        layer.across[k] = std::max(1, static_cast<int>(box.edge(k, cell) / (1.05 * size.diameter)));
      const bool last = &size == &sizes.all().back();
      int of_size =
          last ? left : static_cast<int>(std::round(box.grains * sizes.number_share(size)));
      for (left -= of_size; of_size > 0; of_size -= layer.grains) {
        layer.grains = std::min(of_size, layer.across[0] * layer.across[1]);
        all.push_back(layer);
      }
    }
    std::mt19937 random(4711);
    std::shuffle(all.begin(), all.end(), random);
    return all;
  }

  double height_of_lattice(const Box& box) const {
    double height = 0.0;
    for (const Layer& layer : layers(box)) height += layer.thickness();
    return height;
  }

  void write_grains(const std::filesystem::path& file, const Box& b) const {
    std::ofstream out(file);
    out.precision(9);
    out << "Grains\n\n"
        << b.grains << " atoms\n1 atom types\n\n0 " << b.edge(0, cell) << " xlo xhi\n0 "
        << b.edge(1, cell) << " ylo yhi\n0 " << b.edge(2, cell) << " zlo zhi\n\nAtoms # sphere\n\n";
    std::mt19937 random(4711);
    int number = 0;
    double below = 0.0;
    for (const Layer& layer : layers(b)) {
      const double d = layer.diameter;
      // No closer to others than they can be and not touch.
      std::uniform_real_distribution<double> jitter(-0.02 * d, 0.02 * d);
      for (int n = 0; n < layer.grains; n++) {
        out << ++number << " 1 " << d << ' ' << density;
        const int site[] = {n % layer.across[0], n / layer.across[0]};
        for (int k = 0; k < 2; k++)
          out << ' ' << (site[k] + 0.5) * b.edge(k, cell) / layer.across[k] + jitter(random);
        out << ' ' << below + 0.5 * layer.thickness() << '\n';
      }
      below += layer.thickness();
    }
  }
};

}  // namespace cohesion::tools
