// SPDX-License-Identifier: BSD-3-Clause
#include "powder/plan.h"

#include <gtest/gtest.h>

namespace cohesion::powder {

TEST(PowderPlan, TwoDigitsAreNeverAbove) {
  EXPECT_NEAR(two_digits_below(1.0), 1.0, 1e-15);
  EXPECT_NEAR(two_digits_below(0.00129), 0.0012, 1e-17);
  EXPECT_NEAR(two_digits_below(9.99e-6), 9.9e-6, 1e-20);
  EXPECT_NEAR(two_digits_below(2.3e-5), 2.3e-5, 1e-19);
  EXPECT_NEAR(two_digits_below(12345.0), 12000.0, 1e-10);
}

// (1 - 0.4) 0.02 m^2 0.1 m of solid, spheres of 1 mm
TEST(PowderPlan, GrainsFillTheSolidOfTheBed) {
  EXPECT_NEAR(number_of_grains({0.02, 0.1, 0.4}, Sizes({{1e-3, 1.0}})), 0.0012 / (pi / 6.0 * 1e-9),
              1e-6);
}

TEST(PowderPlan, TheGasStepIsAWholeNumberOfParticleSteps) {
  const double step = particle_step(8.8e-5);
  EXPECT_NEAR(step, 1.1e-5, 1e-19);
  // Half a cell at 1.5 m/s takes 1e-3 s.
  EXPECT_NEAR(gas_step(3e-3, 1.5, 9.81, step), 90.0 * step, 1e-12);
  EXPECT_EQ(gas_step(1e-6, 1.5, 9.81, step), step);
  // In slow gas: 0.1 sqrt(2 3e-3/6) s
  EXPECT_NEAR(gas_step(3e-3, 1e-3, 6.0, step), 287.0 * step, 1e-12);
}

TEST(PowderPlan, WhatIsNoBedIsRefused) {
  EXPECT_THROW(number_of_grains({0.0, 0.1, 0.4}, Sizes({{1e-3, 1.0}})), InvalidParameter);
  EXPECT_THROW(number_of_grains({1.0, 0.1, 1.0}, Sizes({{1e-3, 1.0}})), InvalidParameter);
}

}  // namespace cohesion::powder
