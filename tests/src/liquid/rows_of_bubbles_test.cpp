// SPDX-License-Identifier: BSD-3-Clause
#include "liquid/rows_of_bubbles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cohesion::liquid {

TEST(RowsOfBubbles, MergedKeepTheSumsOfForces) {
  drag::GasOnParticle a{2.0, {1.0, 2.0, 3.0}, {10.0, 20.0, 30.0}, {0.1, 0.2, 0.3}};
  const drag::GasOnParticle b{1.0, {0.0, -1.0, 1.0}, {-5.0, 0.0, 5.0}, {1.0, 1.0, -1.0}};
  merge_rows(a, b, 3.0, 1.0);
  EXPECT_NEAR(a.drag_coefficient, std::cbrt(9.0), 1e-15);
  EXPECT_NEAR(4.0 * a.pressure_gradient[0], 3.0 * 10.0 - 5.0, 1e-14);
  EXPECT_NEAR(a.drag_impulse[2], -0.7, 1e-16);
  EXPECT_NEAR(a.velocity[1], 1.25, 1e-15);
}

TEST(RowsOfBubbles, ARowThatWasGivenStaysMarked) {
  constexpr double tiny = std::numeric_limits<double>::min();
  drag::GasOnParticle a{tiny, {}, {}, {}};
  merge_rows(a, {}, 1.0, 1.0);
  EXPECT_EQ(a.drag_coefficient, tiny);
}

TEST(RowsOfBubbles, WhatIsBlownInChangesNoForceOfThePressure) {
  drag::GasOnParticle row{2.0, {1.0, 2.0, 3.0}, {10.0, -20.0, 30.0}, {0.1, 0.2, 0.3}};
  spread_row(row, 4.0, 1.0);
  EXPECT_EQ(4.0 * row.pressure_gradient[1], 3.0 * -20.0);
  EXPECT_EQ(row.drag_coefficient, 2.0);
  EXPECT_EQ(row.drag_impulse[2], 0.3);
}

TEST(RowsOfBubbles, TwoEqualMergedAndHalvedAreOneOfThem) {
  const LiquidOnParticle one{0.3, 2.0, {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  LiquidOnParticle both = one;
  merge_rows(both, one);
  EXPECT_NEAR(both.added_mass, 0.6, 1e-15);
  // The square of the diameter: 2^(2/3).
  EXPECT_NEAR(both.drag_per_slip, 2.0 * std::cbrt(4.0), 1e-14);
  halve_row(both);
  EXPECT_NEAR(both.added_mass, one.added_mass, 1e-15);
  EXPECT_NEAR(both.drag_per_slip, one.drag_per_slip, 1e-14);
  EXPECT_NEAR(both.lift[2], one.lift[2], 1e-14);
  EXPECT_EQ(both.acceleration[1], one.acceleration[1]);
}

}  // namespace cohesion::liquid
