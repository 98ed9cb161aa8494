// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "void_fraction/cell.h"

namespace cohesion::void_fraction {

/// The sphere as 29 parts of equal volume, each given whole to the cell of its point: one at the
/// centre, 14 in each of two shells around it, in the directions of the faces and corners of a
/// cube. The shells reach from (1/29)^(1/3) over (15/29)^(1/3) to the surface; a part's point lies
/// at the mean distance from the centre in its shell, 3/4 (b^4 - a^4)/(b^3 - a^3) from a to b.
///
/// A cell's share has steps of 1/29. On any mesh.
///
/// Source of the idea: C. Kloss et al., Prog. Comput. Fluid Dyn. 12 (2012) 140 ("divided").
struct DividedVolume {
  static constexpr const char* name = "dividedVolume";
  static constexpr double reach = 1.0;
  static constexpr std::size_t parts = 29;

  /// The points of a unit sphere around the origin [1].
  static const std::array<Vector3, parts>& points() {
    static const std::array<Vector3, parts> made = make_points();
    return made;
  }

  /// Share of the sphere's volume that is the cell's [1].
  static double share(const Sphere& sphere, const Cell& cell) {
    int inside = 0;
    for (const Vector3& point : points())
      inside += cell.contains(sphere.centre + sphere.radius * point);
    return static_cast<double>(inside) / parts;
  }

 private:
  static std::array<Vector3, parts> make_points() {
    std::array<Vector3, parts> made{};
    std::size_t n = 1;  // The first is the centre.
    const double bounds[] = {std::cbrt(1.0 / 29.0), std::cbrt(15.0 / 29.0), 1.0};
    for (int shell = 0; shell < 2; shell++) {
      const double a = bounds[shell], b = bounds[shell + 1];
      const double distance = 0.75 * (std::pow(b, 4) - std::pow(a, 4)) / (b * b * b - a * a * a);
      for (int x = -1; x <= 1; x++)
        for (int y = -1; y <= 1; y++)
          for (int z = -1; z <= 1; z++) {
            const int squared = x * x + y * y + z * z;
            if (squared != 1 && squared != 3) continue;
            const double scale = distance / std::sqrt(squared);
            made[n++] = {scale * x, scale * y, scale * z};
          }
    }
    return made;
  }
};

}  // namespace cohesion::void_fraction
