// SPDX-License-Identifier: BSD-3-Clause
#include "void_fraction/sphere_box_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "box_cell.h"

namespace cohesion::void_fraction {

namespace {

/// Some 30 roundings of numbers up to 2 pi, over three: below 1e-14 of the unit sphere's 4.2.
constexpr double round_off = 1e-14;

/// Area y > b, z > c of a disc of radius r around the origin, b, c >= 0 and the corner inside.
double corner_of_disc(double r, double b, double c) {
  const double angle = std::acos(b / r) - std::asin(c / r);
  return 0.5 *
         (r * r * angle - b * (std::sqrt(r * r - b * b) - c) - c * (std::sqrt(r * r - c * c) - b));
}

/// G of sphere_box_overlap.h by slices x = const, integrated by the double exponential rule. It
/// converges like exp(-C n/log n) whatever powers the integrand has at its ends; 200 points reach
/// round-off of the sum.
double corner_by_slices(double a, double b, double c) {
  const double end = std::sqrt(1.0 - b * b - c * c);
  const double step = 0.04;
  double sum = 0.0;
  for (int k = -100; k <= 100; k++) {
    const double t = step * k, u = 0.5 * pi * std::sinh(t);
    // The distance from the upper end, without cancellation
    const double from_end = (end - a) / (1.0 + std::exp(2.0 * u));
    const double x = end - from_end;
    const double weight = 0.5 * (end - a) * 0.5 * pi * std::cosh(t) / (std::cosh(u) * std::cosh(u));
    const double r = std::sqrt(1.0 - x * x);
    if (r * r <= b * b + c * c || weight < 1e-30) continue;
    sum += step * weight * corner_of_disc(r, b, c);
  }
  return sum;
}

/// Share of the unit sphere around the origin in the box, as the sum of the corner's part over the
/// box's eight corners, each with the sign of the number of upper sides: for any box, in whatever
/// way it cuts the sphere.
double share_by_eight_corners(const Box& box) {
  const auto in_sphere = [](double side) { return std::clamp(side, -1.0, 1.0); };
  double sum = 0.0;
  for (int corner = 0; corner < 8; corner++) {
    const bool x = corner & 1, y = corner & 2, z = corner & 4;
    const double part = unit_sphere::corner(in_sphere(x ? box.high.x : box.low.x),
                                            in_sphere(y ? box.high.y : box.low.y),
                                            in_sphere(z ? box.high.z : box.low.z));
    sum += (x + y + z) % 2 == 0 ? part : -part;
  }
  return sum / sphere_volume(1.0);
}

double share(const Vector3& centre, double radius, const Box& box) {
  return share_in_box(Sphere{centre, radius}, box);
}

}  // namespace

TEST(SphereBoxOverlap, CornerOfTheBoxInTheSphere) {
  EXPECT_NEAR(unit_sphere::corner(0.0, 0.0, 0.0), pi / 6.0, round_off);
  for (const double a : {0.0, 1e-9, 0.1, 0.3, 0.57})
    for (const double b : {0.0, 1e-7, 0.2, 0.5, 0.57})
      for (const double c : {0.0, 1e-3, 0.4, 0.57})
        EXPECT_NEAR(unit_sphere::corner(a, b, c), corner_by_slices(a, b, c), round_off)
            << a << " " << b << " " << c;
}

TEST(SphereBoxOverlap, CornerThatIsHardlyInside) {
  // Where the roots nearly vanish: round-off must not show as its square root, 1e-8.
  for (const double a : {1e-8, 1e-3, 0.3, 0.7, 0.99})
    for (const double gap : {1e-15, 1e-12, 1e-9, 1e-6}) {
      const double b = std::sqrt((1.0 - a * a) * (1.0 - gap));
      for (const double c : {0.0, 0.5 * std::sqrt((1.0 - a * a) * gap)})
        EXPECT_NEAR(unit_sphere::corner(a, b, c), corner_by_slices(a, b, c), round_off)
            << a << " " << gap << " " << c;
    }
}

TEST(SphereBoxOverlap, WedgeBetweenTwoPlanes) {
  // Twice the part on one side of the plane through the centre across both
  for (const double a : {0.0, 1e-9, 0.1, 0.3, 0.7, 0.99})
    for (const double b : {0.0, 1e-7, 0.14, 0.2, 0.5, 0.7})
      if (a * a + b * b < 1.0) {
        const double slices = 2.0 * corner_by_slices(0.0, a, b);
        EXPECT_NEAR(unit_sphere::wedge(a, b), slices, 2.0 * round_off) << a << " " << b;
        // The reflections take it from caps.
        EXPECT_NEAR(unit_sphere::wedge(-a, b), unit_sphere::cap(b) - slices, 2.0 * round_off);
        EXPECT_NEAR(unit_sphere::wedge(a, -b), unit_sphere::cap(a) - slices, 2.0 * round_off);
      }
}

TEST(SphereBoxOverlap, HoweverTheBoxCutsTheSphere) {
  // Each direction in each of the ways: not cut, from below, from above, both, beyond the sphere.
  const std::vector<std::array<double, 2>> ways{
      {-1.0, 1.0}, {-7.0, 1.3},  {-infinity, infinity}, {-0.4, 1.2}, {0.35, infinity},
      {-1.5, 0.3}, {-3.0, -0.6}, {-0.3, 0.55},          {0.1, 0.2},  {-1.0, 0.0},
      {1.0, 2.0},  {-2.0, -1.1}};
  for (const auto& x : ways)
    for (const auto& y : ways)
      for (const auto& z : ways) {
        const Box box{{x[0], y[0], z[0]}, {x[1], y[1], z[1]}};
        // Eight parts of at most the sphere, each to round-off, on either side
        EXPECT_NEAR(share({}, 1.0, box), share_by_eight_corners(box), 16.0 * round_off)
            << x[0] << " " << x[1] << ", " << y[0] << " " << y[1] << ", " << z[0] << " " << z[1];
      }
}

TEST(SphereBoxOverlap, CutByOneAndTwoPlanes) {
  const auto beyond = [](double a) {
    return share({1.0, 2.0, 3.0}, 2.0,
                 {{1.0 + 2.0 * a, -infinity, -infinity}, {infinity, infinity, infinity}});
  };
  for (const double a : {-1.5, -1.0, -0.3, 0.0, 0.6, 1.0, 7.0}) {
    const double inside = std::clamp(a, -1.0, 1.0);
    EXPECT_NEAR(beyond(a), 0.25 * (1.0 - inside) * (1.0 - inside) * (2.0 + inside), round_off);
  }
  // A quarter of the sphere, and what two planes through a point off the centre leave
  EXPECT_NEAR(share({}, 1.0, {{0.0, 0.0, -5.0}, {5.0, 5.0, 5.0}}), 0.25, round_off);
  const double corner = share({}, 1.0, {{0.3, -0.2, -5.0}, {5.0, 5.0, 5.0}});
  const double other = share({}, 1.0, {{0.3, -5.0, -5.0}, {5.0, -0.2, 5.0}});
  EXPECT_NEAR(corner + other, beyond(0.3), round_off);
  EXPECT_NEAR(other * sphere_volume(1.0), 2.0 * corner_by_slices(0.0, 0.3, 0.2), 2.0 * round_off);
}

TEST(SphereBoxOverlap, WholeSphereWholeBoxAndNothing) {
  EXPECT_EQ(share({0.5, 0.5, 0.5}, 0.5, {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}), 1.0);
  EXPECT_EQ(share({0.5, 0.5, 0.5}, 0.5, {{1.0, 0.0, 0.0}, {2.0, 1.0, 1.0}}), 0.0);
  EXPECT_EQ(share({9.0, 9.0, 9.0}, 0.5, {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}), 0.0);
  EXPECT_NEAR(share({0.4, 0.5, 0.6}, 3.0, {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}),
              1.0 / sphere_volume(3.0), round_off);
}

TEST(SphereBoxOverlap, BoxesThatFillSpaceShareTheWholeSphere) {
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int trial = 0; trial < 300; trial++) {
    // Radii from a twentieth of the boxes' mean side to ten times it
    const double radius = std::pow(10.0, 0.15 + 1.15 * uniform(random)) * 0.35;
    // Every third sphere touches a plane, an edge or a corner to round-off.
    std::vector<double> sides{-infinity, -1.1, -0.4, 0.0, 0.03, 0.9, infinity};
    Vector3 centre{uniform(random), uniform(random), uniform(random)};
    if (trial % 3 == 0) centre = {0.03 + radius, 0.0, trial % 2 ? centre.z : -1.1 - radius};
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < sides.size(); i++)
      for (std::size_t j = 0; j + 1 < sides.size(); j++)
        for (std::size_t k = 0; k + 1 < sides.size(); k++)
          sum +=
              share(centre, radius,
                    {{sides[i], sides[j], sides[k]}, {sides[i + 1], sides[j + 1], sides[k + 1]}});
    // 216 shares of eight corners each, the errors adding up at random
    EXPECT_NEAR(sum, 1.0, 10.0 * round_off) << radius;
  }
}

}  // namespace cohesion::void_fraction
