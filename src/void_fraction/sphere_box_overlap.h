// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "constants.h"
#include "sphere.h"
#include "void_fraction/cell.h"

/// Volume that a sphere and a box along the axes have in common, in closed form.
///
/// With G(a, b, c) the volume of the part x > a, y > b, z > c of the unit sphere around the origin,
/// the box has the sum of G over its eight corners, with the sign of the number of upper sides.
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
/// and two of them meet at the exterior angle atan2(s_ab, -a b):
///
///   S = 2 pi - sum over pairs atan2(s_ab, -a b) - sum a theta_a.
///
/// Negative arguments by reflection: G(-a, b, c) = G_2(b, c) - G(a, b, c), with the part between
/// two planes G_2(b, c) = 2 G(0, b, c), the same with G_2(-b, c) = G_1(c) - G_2(b, c), and the cap
/// G_1(c) = pi/3 (1 - c)^2 (2 + c).
///
/// The roots s are the same wherever they occur, so that their round-off cancels to second order
/// where they vanish: the error is round-off of the sphere's volume everywhere.
namespace cohesion::void_fraction {

namespace unit_sphere {

/// Volume [1] of the part x > a, -1 <= a <= 1.
inline double cap(double a) { return pi / 3.0 * (1.0 - a) * (1.0 - a) * (2.0 + a); }

/// Volume [1] of the part x > a, y > b, z > c, all >= 0.
inline double corner_inside(double a, double b, double c) {
  if (a * a + b * b + c * c >= 1.0) return 0.0;
  // Round-off may put the root's argument below zero though the sum above is below one.
  const auto root = [](double x, double y) {
    return std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
  };
  const double ab = root(a, b), bc = root(b, c), ca = root(c, a);
  const auto face = [](double x, double y, double z, double xy, double xz, double angle) {
    return 0.5 * ((1.0 - x * x) * angle - y * (xy - z) - z * (xz - y));
  };
  const double angle_a = std::atan2(ab, b) - std::atan2(c, ca);
  const double angle_b = std::atan2(bc, c) - std::atan2(a, ab);
  const double angle_c = std::atan2(ca, a) - std::atan2(b, bc);
  const double spherical = 2.0 * pi - std::atan2(ab, -a * b) - std::atan2(bc, -b * c) -
                           std::atan2(ca, -c * a) - a * angle_a - b * angle_b - c * angle_c;
  return (spherical - a * face(a, b, c, ab, ca, angle_a) - b * face(b, c, a, bc, ab, angle_b) -
          c * face(c, a, b, ca, bc, angle_c)) /
         3.0;
}

/// Volume [1] of the part x > a, y > b, both from -1 to 1.
inline double wedge(double a, double b) {
  if (a < 0.0) return cap(b) - wedge(-a, b);
  if (b < 0.0) return cap(a) - wedge(a, -b);
  return 2.0 * corner_inside(0.0, a, b);
}

/// Volume [1] of the part x > a, y > b, z > c, all from -1 to 1.
inline double corner(double a, double b, double c) {
  if (a < 0.0) return wedge(b, c) - corner(-a, b, c);
  if (b < 0.0) return wedge(c, a) - corner(a, -b, c);
  if (c < 0.0) return wedge(a, b) - corner(a, b, -c);
  return corner_inside(a, b, c);
}

}  // namespace unit_sphere

/// Share of the sphere's volume that lies in the box [1], 0 to 1.
inline double share_in_box(const Sphere& sphere, const Box& box) {
  // In radii, from the centre. Beyond the sphere a side does not matter.
  const auto side = [&sphere](double at, double centre) {
    return std::clamp((at - centre) / sphere.radius, -1.0, 1.0);
  };
  const std::array<std::array<double, 2>, 3> sides{
      {{side(box.low.x, sphere.centre.x), side(box.high.x, sphere.centre.x)},
       {side(box.low.y, sphere.centre.y), side(box.high.y, sphere.centre.y)},
       {side(box.low.z, sphere.centre.z), side(box.high.z, sphere.centre.z)}}};
  double volume = 0.0;
  for (int corner = 0; corner < 8; corner++) {
    const int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
    const double part = unit_sphere::corner(sides[0][static_cast<std::size_t>(x)],
                                            sides[1][static_cast<std::size_t>(y)],
                                            sides[2][static_cast<std::size_t>(z)]);
    volume += (x + y + z) % 2 == 0 ? part : -part;
  }
  return std::clamp(volume / sphere_volume(1.0), 0.0, 1.0);
}

}  // namespace cohesion::void_fraction
