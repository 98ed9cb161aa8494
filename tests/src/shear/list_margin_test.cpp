// SPDX-License-Identifier: BSD-3-Clause
#include "shear/list_margin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cohesion::shear {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The farthest that two particles can have been from each other, by trying directions: they are
/// `distance` apart now, after a shear, and each has moved `own` beyond it.
double farthest_before(double distance, double own, double strain) {
  double farthest = 0.0;
  for (int n = 0; n < 20000; n++) {
    const double angle = 3.14159265358979 * n / 20000;
    const double r = distance + 2.0 * own;
    const double y = r * std::sin(angle), x = r * std::cos(angle) - strain * y;
    farthest = std::max(farthest, std::hypot(x, y));
  }
  return farthest;
}

}  // namespace

TEST(ListMargin, WithoutShearIsHalfTheSkin) {
  EXPECT_NEAR(list_margin(1.3, 1.0, 0.0), 0.15, 4 * eps);
  EXPECT_NEAR(largest_stretch(0.0), 1.0, eps);
}

TEST(ListMargin, IsTheBoundAndIsAttained) {
  for (const double strain : {-2.0, -0.1, 1e-3, 0.05, 0.3, 1.0}) {
    const double reach = 3.5, force = 1.0;
    const double margin = list_margin(reach, force, strain);
    ASSERT_GT(margin, 0.0);
    // Directions 1.6e-4 apart: the maximum is missed by its square at most.
    EXPECT_NEAR(farthest_before(force, margin, strain), reach, 1e-6) << strain;
  }
}

TEST(ListMargin, IsNegativeOnceTheShearAloneBringsPairsIn) {
  // s - 1/s = strain: s = 1.5 at 1.5 - 1/1.5.
  const double strain = 1.5 - 1.0 / 1.5;
  EXPECT_GT(list_margin(1.5, 1.0, 0.999 * strain), 0.0);
  EXPECT_LT(list_margin(1.5, 1.0, 1.001 * strain), 0.0);
}

}  // namespace cohesion::shear
