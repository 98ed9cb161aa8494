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
  EXPECT_NEAR(number_of_grains({0.02, 0.1, 0.4}, PowderSizes({{1e-3, 1.0}})),
              0.0012 / (pi / 6.0 * 1e-9), 1e-6);
}

// 0.6 0.02 m^2 0.1 m of 2500 kg/m3; the same, 9.8 m/s2, over the area
TEST(PowderPlan, TheBedWeighsWhatItsSolidDoes) {
  const Bed bed{0.02, 0.1, 0.4};
  EXPECT_NEAR(mass_of(bed, 2500.0), 3.0, 1e-14);
  EXPECT_NEAR(pressure_of(bed.height, bed.void_fraction, 2500.0 * 9.8), 3.0 * 9.8 / 0.02, 1e-11);
}

// n/2 r^2 sin(2 pi/n)
TEST(PowderPlan, ColumnsOfPlaneSidesHaveTheAreaOfTheirCylinder) {
  for (const int sides : {3, 12, 100}) {
    const double corner = corners_of_equal_area(0.3, sides);
    EXPECT_NEAR(0.5 * sides * corner * corner * std::sin(2.0 * pi / sides), pi * 0.09, 1e-15);
  }
}

TEST(PowderPlan, TheGasStepIsThatOfACellOrOfAFall) {
  // Half a cell at 1.5 m/s takes 1e-3 s; in slow gas 0.1 sqrt(2 3e-3/6) s.
  EXPECT_NEAR(longest_gas_step(3e-3, 1.5, 9.81), 1e-3, 1e-15);
  EXPECT_NEAR(longest_gas_step(3e-3, 1e-3, 6.0), 0.1 * std::sqrt(1e-3), 1e-15);
}

// Ends of runs and outputs are at multiples of the interval: each step is a whole part of it, no
// longer than asked for, and shorter by no more than one step in the interval.
TEST(PowderPlan, StepsAreWholePartsOfTheInterval) {
  const double interval = 0.01;
  for (const double particle : {1.1e-5, 3.14159e-6, 0.02})
    for (const double gas : {1e-3, 4.7e-4, 1e-6, 1.0}) {
      const TimeSteps steps = steps_within(interval, particle, gas);
      const double of_gas = steps.gas / steps.particle, of_interval = interval / steps.gas;
      EXPECT_NEAR(of_gas, std::round(of_gas), 1e-9);
      EXPECT_NEAR(of_interval, std::round(of_interval), 1e-9 * of_interval);
      EXPECT_LE(steps.particle, particle);
      EXPECT_LE(steps.gas, gas * (1.0 + 1e-12));
      const double longest = std::min({particle, gas, interval});
      EXPECT_GE(steps.particle, longest / (1.0 + 1.0 / (of_interval - 0.999999)) * (1.0 - 1e-9));
    }
}

TEST(PowderPlan, WhatIsNoBedIsRefused) {
  EXPECT_THROW(number_of_grains({0.0, 0.1, 0.4}, PowderSizes({{1e-3, 1.0}})), InvalidParameter);
  EXPECT_THROW(number_of_grains({1.0, 0.1, 1.0}, PowderSizes({{1e-3, 1.0}})), InvalidParameter);
}

}  // namespace cohesion::powder
