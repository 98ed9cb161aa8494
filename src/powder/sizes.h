// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "sphere.h"
#include "validation.h"

namespace cohesion::powder {

/// Spheres of one size in a powder.
struct PowderSize {
  double diameter;    ///< [length]
  double mass_share;  ///< of the powder, of any unit
};

/// Sizes of a powder of one density.
class PowderSizes {
 public:
  /// Throws InvalidParameter where there is none, and unless diameters and shares are positive.
  explicit PowderSizes(std::vector<PowderSize> sizes) : sizes_(std::move(sizes)) {
    require(!sizes_.empty(), "number of sizes", 0.0, "give at least one diameter");
    for (const PowderSize& size : sizes_) {
      require_positive("diameter", size.diameter);
      require_positive("mass share", size.mass_share);
      all_ += size.mass_share;
    }
    const auto [least, most] = std::minmax_element(
        sizes_.begin(), sizes_.end(),
        [](const PowderSize& a, const PowderSize& b) { return a.diameter < b.diameter; });
    smallest_ = least->diameter;
    largest_ = most->diameter;
  }

  /// From the diameters below which 10, 50 and 90 % of the mass is, taken for 30, 40 and 30 % of
  /// it: the mean of a log-normal distribution so weighted is right to some per cent (Swanson's
  /// rule: A. Hurst, G. C. Brown, R. I. Swanson, AAPG Bulletin 84 (2000) 1883). Throws
  /// InvalidParameter unless they rise.
  static PowderSizes of_percentiles(double d10, double d50, double d90) {
    require(d10 < d50, "d10", d10, "must be below d50");
    require(d50 < d90, "d50", d50, "must be below d90");
    return PowderSizes({{d10, 0.3}, {d50, 0.4}, {d90, 0.3}});
  }

  const std::vector<PowderSize>& all() const { return sizes_; }
  double smallest() const { return smallest_; }
  double largest() const { return largest_; }

  /// Share of a size in the mass, [1].
  double share(const PowderSize& size) const { return size.mass_share / all_; }

  /// Sum d^3/sum d^2, the mean by surface per volume, [length].
  double sauter() const {
    double sum = 0.0;
    for (const PowderSize& size : sizes_) sum += share(size) / size.diameter;
    return 1.0 / sum;
  }

  /// Share of a size in the number of spheres, [1].
  double number_share(const PowderSize& size) const {
    return share(size) / sphere_volume(0.5 * size.diameter) / number_per_solid_volume();
  }

  /// Spheres in a volume of solid, [1/length^3].
  double number_per_solid_volume() const {
    double sum = 0.0;
    for (const PowderSize& size : sizes_) sum += share(size) / sphere_volume(0.5 * size.diameter);
    return sum;
  }

 private:
  std::vector<PowderSize> sizes_;
  double all_ = 0.0, smallest_, largest_;
};

}  // namespace cohesion::powder
