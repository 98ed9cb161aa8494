// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "constants.h"
#include "powder/plan.h"
#include "powder/sizes.h"

namespace cohesion::tools {

/// A box, or a round column about the z axis, of whole cells, and grains in a loose lattice in it.
/// Any consistent set of units.
class PowderVessel {
 public:
  /// Cross-section of a bed: a box from the origin on, or a column of a diameter.
  struct Section {
    double width = 0.0, depth = 0.0, column = 0.0;  // [length]

    bool is_round() const { return column > 0.0; }
    double area() const { return is_round() ? 0.25 * pi * column * column : width * depth; }
  };

  /// Fewest cells across a box, and a column, whose mesh has a square in its middle.
  static constexpr int least_across = 2, least_across_column = 6;

  /// For a settled bed of this section, height and void fraction, or, where that has more than so
  /// many grains, for one of its shape that has not. It is three times as high as the bed, or as
  /// the lattice. Where the fewest cells hold more grains than asked for, so does it: see grains().
  /// spread: over the distance of the grains in the lattice, which are out of the reach of others'
  /// wells of this ratio r_out/r then.
  PowderVessel(const powder::PowderSizes& sizes, const Section& section, double height,
               double void_fraction, double cell, double most, unsigned seed, double spread = 1.0)
      : sizes_(&sizes),
        round_(section.is_round()),
        cell_(cell),
        seed_(seed),
        spacing_(1.05 * spread),
        clear_of_wall_(0.53 * spread) {
    const double all = powder::number_of_grains({section.area(), height, void_fraction}, sizes);
    const double scale = std::min(1.0, std::cbrt(most / all));
    const auto whole = [&](double length) {
      // A whole number of cells stays one. Of a column it is even, so that its mesh is as wide as
      // its corners are apart.
      const int cells = static_cast<int>(std::floor(scale * length / cell * (1.0 + 1e-9)));
      return round_ ? std::max(least_across_column, cells / 2 * 2) : std::max(least_across, cells);
    };
    cells_ = {whole(round_ ? section.column : section.width),
              whole(round_ ? section.column : section.depth), 0};
    const double high = scale * height;
    cells_[2] = 3 * std::max(2, static_cast<int>(std::ceil(high / cell)));
    grains_ = static_cast<int>(
        std::round(powder::number_of_grains({area(), high, void_fraction}, sizes)));
    layers_ = layers();
    cells_[2] = std::max(cells_[2], static_cast<int>(std::ceil(height_of_lattice() / cell)));
  }

  bool is_round() const { return round_; }
  int grains() const { return grains_; }
  int cells(int k) const { return cells_[k]; }
  /// [length]
  double cell() const { return cell_; }
  double edge(int k) const { return cells_[k] * cell_; }
  double radius() const { return 0.5 * edge(0); }
  /// Bounds of the mesh.
  double lower(int k) const { return round_ && k < 2 ? -reach() : 0.0; }
  double upper(int k) const { return round_ && k < 2 ? reach() : edge(k); }
  double area() const { return round_ ? pi * radius() * radius() : edge(0) * edge(1); }

  /// The mesh of a column: a square of cells in the middle, some three fifths of the diameter,
  /// rings around it, and how far from the axis its outer corners are.
  int rings() const { return static_cast<int>(std::lround(0.2 * cells_[0])); }
  int across_square() const { return cells_[0] - 2 * rings(); }
  double reach() const { return powder::corners_of_equal_area(radius(), 4 * across_square()); }

  double height_of_lattice() const {
    double height = 0.0;
    for (const Layer& layer : layers_) height += thickness(layer);
    return height;
  }

  /// Calls with the index of the size and the place of each grain, the same in every call.
  template <class Take>
  void for_each_grain(const Take& take) const {
    std::mt19937 random(seed_);
    double below = 0.0;
    for (const Layer& layer : layers_) {
      const double d = layer.diameter;
      // No closer to others than they can be and not touch.
      std::uniform_real_distribution<double> jitter(-0.02 * d, 0.02 * d);
      const std::vector<std::array<double, 2>> sites = sites_of(d);
      for (int n = 0; n < layer.grains; n++)
        take(layer.size,
             std::array<double, 3>{sites[n][0] + jitter(random), sites[n][1] + jitter(random),
                                   below + 0.5 * thickness(layer)});
      below += thickness(layer);
    }
  }

 private:
  /// Grains of one size, a layer of the lattice.
  struct Layer {
    std::size_t size;
    double diameter;
    int grains;
  };

  double thickness(const Layer& layer) const { return spacing_ * layer.diameter; }

  /// Where a layer has grains: all over the cross-section, clear of walls.
  std::vector<std::array<double, 2>> sites_of(double d) const {
    std::array<int, 2> across;
    for (int k = 0; k < 2; k++) across[k] = std::max(1, static_cast<int>(edge(k) / (spacing_ * d)));
    const double origin = round_ ? -radius() : 0.0;
    std::vector<std::array<double, 2>> sites;
    for (int j = 0; j < across[1]; j++)
      for (int i = 0; i < across[0]; i++) {
        const std::array<double, 2> site{origin + (i + 0.5) * edge(0) / across[0],
                                         origin + (j + 0.5) * edge(1) / across[1]};
        if (!round_ || std::hypot(site[0], site[1]) < radius() - clear_of_wall_ * d)
          sites.push_back(site);
      }
    return sites;
  }

  /// The layers of all sizes, in any order.
  std::vector<Layer> layers() const {
    std::vector<Layer> all;
    int left = grains_;
    for (std::size_t k = 0; k < sizes_->all().size(); k++) {
      const powder::PowderSize& size = sizes_->all()[k];
      const int room = static_cast<int>(sites_of(size.diameter).size());
      const bool last = k + 1 == sizes_->all().size();
      int of_size =
          last ? left : static_cast<int>(std::round(grains_ * sizes_->number_share(size)));
      for (left -= of_size; of_size > 0; of_size -= all.back().grains)
        all.push_back({k, size.diameter, std::min(of_size, room)});
    }
    std::mt19937 random(seed_);
    std::shuffle(all.begin(), all.end(), random);
    return all;
  }

  const powder::PowderSizes* sizes_;
  bool round_;
  double cell_;
  unsigned seed_;
  double spacing_, clear_of_wall_;  // of the lattice, over the diameter
  std::array<int, 3> cells_;
  int grains_;
  std::vector<Layer> layers_;
};

}  // namespace cohesion::tools
