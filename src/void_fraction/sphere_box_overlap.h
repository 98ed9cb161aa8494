// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "constants.h"
#include "sphere.h"
#include "void_fraction/cell.h"

/// Volume that a sphere and a box along the axes have in common, in closed form.
///
/// With G(a, b, c) the volume of the part x > a, y > b, z > c of the unit sphere around the origin,
/// a box that has one side in the sphere in each direction has G of the three, those that are upper
/// sides mirrored; a direction whose both sides are in the sphere has the difference of two such,
/// one with none lets its argument be -1.
///
/// G for a, b, c >= 0, when the corner is inside the sphere. By the divergence theorem, with the
/// part's spherical face S and its plane faces A_a, A_b, A_c,
///
///   3 G = S - a A_a - b A_b - c A_c.
///
/// The circle x = a on the sphere contributes an arc of the angle
/// theta_a = atan2(s_ab, b) - atan2(c, s_ac), s_ab = sqrt(1 - a^2 - b^2), and
///
///   2 A_a = (1 - a^2) theta_a - b (s_ab - c) - c (s_ac - b),
///
/// and S follows from Gauss and Bonnet: arcs of geodesic curvature a/sqrt(1 - a^2) give a theta_a,
/// and two of them meet at the exterior angle pi - phi_ab, phi_ab = atan2(s_ab, a b):
///
///   S = sum over pairs phi_ab - pi - sum a theta_a.
///
/// Sums and differences of angles are taken as the angle of a product of complex numbers, one atan2
/// each; the sum of the phi less pi lies between 0, where S vanishes, and pi/2.
///
/// Negative arguments by reflection: G(-a, b, c) = G_2(b, c) - G(a, b, c), with the part between
/// two planes G_2(b, c) = 2 G(0, b, c),
///
///   3/2 G_2(a, b) = phi_ab + a b s_ab
///                   - a (3 - a^2)/2 atan2(s_ab, b) - b (3 - b^2)/2 atan2(s_ab, a),
///
/// the same with G_2(-b, c) = G_1(c) - G_2(b, c), and the cap G_1(c) = pi/3 (1 - c)^2 (2 + c).
///
/// The roots s are the same wherever they occur, so that their round-off cancels to second order
/// where they vanish: the error is round-off of the sphere's volume everywhere.
namespace cohesion::void_fraction {

namespace unit_sphere {

/// Volume [1] of the part x > a, -1 <= a <= 1.
inline double cap(double a) { return pi / 3.0 * (1.0 - a) * (1.0 - a) * (2.0 + a); }

/// Root of 1 - a^2 - b^2, 0 where round-off would make it imaginary.
inline double root(double a, double b) { return std::sqrt(std::max(0.0, 1.0 - a * a - b * b)); }

/// Volume [1] of the part x > a, y > b, z > c, all >= 0.
inline double corner_inside(double a, double b, double c) {
  if (a * a + b * b + c * c >= 1.0) return 0.0;
  const double ab = root(a, b), bc = root(b, c), ca = root(c, a);
  const auto arc = [](double y, double z, double xy, double xz) {
    return std::atan2(xy * xz - y * z, y * xz + xy * z);
  };
  const auto face = [](double x, double y, double z, double xy, double xz, double angle) {
    return 0.5 * ((1.0 - x * x) * angle - y * (xy - z) - z * (xz - y));
  };
  const double angle_a = arc(b, c, ab, ca), angle_b = arc(c, a, bc, ab),
               angle_c = arc(a, b, ca, bc);
  // (a b + i s_ab)(b c + i s_bc)
  const double real = a * b * b * c - ab * bc, imaginary = a * b * bc + ab * b * c;
  const double corners =
      std::atan2(-(real * ca + imaginary * c * a), imaginary * ca - real * c * a);
  const double spherical = corners - a * angle_a - b * angle_b - c * angle_c;
  return (spherical - a * face(a, b, c, ab, ca, angle_a) - b * face(b, c, a, bc, ab, angle_b) -
          c * face(c, a, b, ca, bc, angle_c)) /
         3.0;
}

/// Volume [1] of the part x > a, y > b, both >= 0.
inline double wedge_inside(double a, double b) {
  if (a * a + b * b >= 1.0) return 0.0;
  const double ab = root(a, b);
  return 2.0 / 3.0 *
         (std::atan2(ab, a * b) + a * b * ab - 0.5 * a * (3.0 - a * a) * std::atan2(ab, b) -
          0.5 * b * (3.0 - b * b) * std::atan2(ab, a));
}

/// Volume [1] of the part x > a, y > b, both from -1 to 1.
inline double wedge(double a, double b) {
  if (a == -1.0) return cap(b);
  if (b == -1.0) return cap(a);
  if (a < 0.0) return cap(b) - wedge(-a, b);
  if (b < 0.0) return cap(a) - wedge(a, -b);
  return wedge_inside(a, b);
}

/// Volume [1] of the part x > a, y > b, z > c, all from -1 to 1.
inline double corner(double a, double b, double c) {
  if (a == -1.0) return wedge(b, c);
  if (b == -1.0) return wedge(c, a);
  if (c == -1.0) return wedge(a, b);
  if (a < 0.0) return wedge(b, c) - corner(-a, b, c);
  if (b < 0.0) return wedge(c, a) - corner(a, -b, c);
  if (c < 0.0) return wedge(a, b) - corner(a, b, -c);
  return corner_inside(a, b, c);
}

}  // namespace unit_sphere

/// Share of the sphere's volume that lies in the box [1], 0 to 1.
inline double share_in_box(const Sphere& sphere, const Box& box) {
  // The planes that cut a direction, in radii from the centre, and what lies above each: all that
  // is above the first less what is above the second.
  struct Direction {
    std::array<double, 2> planes;
    int count;
  };
  bool apart = false, whole = true;
  const auto direction = [&](double low, double high, double centre) -> Direction {
    const double from = (low - centre) / sphere.radius, to = (high - centre) / sphere.radius;
    apart = apart || from >= 1.0 || to <= -1.0;
    whole = whole && from <= -1.0 && to >= 1.0;
    if (to >= 1.0) return {{std::max(from, -1.0), 1.0}, 1};
    if (from <= -1.0) return {{-to, 1.0}, 1};  // mirrored
    return {{from, to}, 2};
  };
  const Direction x = direction(box.low.x, box.high.x, sphere.centre.x);
  const Direction y = direction(box.low.y, box.high.y, sphere.centre.y);
  const Direction z = direction(box.low.z, box.high.z, sphere.centre.z);
  if (apart) return 0.0;
  if (whole) return 1.0;
  double volume = 0.0;
  for (int i = 0; i < x.count; i++)
    for (int j = 0; j < y.count; j++)
      for (int k = 0; k < z.count; k++) {
        const double part = unit_sphere::corner(x.planes[static_cast<std::size_t>(i)],
                                                y.planes[static_cast<std::size_t>(j)],
                                                z.planes[static_cast<std::size_t>(k)]);
        volume += (i + j + k) % 2 == 0 ? part : -part;
      }
  return std::clamp(volume / sphere_volume(1.0), 0.0, 1.0);
}

}  // namespace cohesion::void_fraction
