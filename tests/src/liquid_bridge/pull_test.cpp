// SPDX-License-Identifier: BSD-3-Clause
#include "liquid_bridge/pull.h"

#include <gtest/gtest.h>

#include <cmath>

#include "constants.h"

namespace cohesion::liquid_bridge {
namespace {

constexpr double force = 3e-5, fall = 2e-5;
const Pull falling{force, fall};

/// As Willett et al. print it, of half of the gap.
double printed(double gap) {
  const double half = 0.5 * gap / fall;
  return force / (1.0 + 2.1 * half + 10.0 * half * half);
}

/// Simpson's rule; its error is below the fourth power of the step over that in which the pull
/// changes, (1/2000)^4 here.
double integral(double from, double to) {
  constexpr int parts = 2000;
  const double h = (to - from) / parts;
  double sum = printed(from) + printed(to);
  for (int k = 1; k < parts; k++) sum += (k % 2 ? 4.0 : 2.0) * printed(from + k * h);
  return sum * h / 3.0;
}

}  // namespace

TEST(LiquidBridgePull, IsThePublishedForm) {
  for (const double gap : {0.0, 0.1 * fall, fall, 3.0 * fall, 10.0 * fall})
    EXPECT_NEAR(falling.at(gap) / printed(gap), 1.0, 1e-15) << gap;  // four roundings
  EXPECT_EQ(falling.at(-1e-6), force);
  // 1/(1 + 1.05 + 2.5)
  EXPECT_NEAR(falling.at(fall) / force, 0.21978021978021978, 1e-15);
}

// The gorge of Derjaguin's approximation: F = F_0 (1 - S/(2 d)), d -> sqrt(V/(2 pi R)), so that the
// pull begins to fall with sqrt(pi/2) = 1.25 s. The fit is 16 % off; with all of the gap in the
// printed form it would be 68 % off.
TEST(LiquidBridgePull, BeginsToFallAsThinBridgesDo) {
  const double slope = (1.0 - falling.at(1e-4 * fall) / force) / 1e-4;
  EXPECT_NEAR(slope / std::sqrt(0.5 * pi), 1.0, 0.2);
}

TEST(LiquidBridgePull, MeanAndWorkAreTheIntegral) {
  for (const double from : {0.0, 0.3 * fall, 2.0 * fall})
    for (const double to : {0.1 * fall, fall, 5.0 * fall}) {
      EXPECT_NEAR(falling.mean(from, to) * (to - from) / integral(from, to), 1.0, 1e-11);
      EXPECT_NEAR(falling.mean(from, to) / falling.mean(to, from), 1.0, 2e-15);  // ten roundings
    }
  EXPECT_NEAR(falling.work(5.0 * fall) / integral(0.0, 5.0 * fall), 1.0, 1e-11);
  EXPECT_EQ(falling.work(-1e-6), -1e-6 * force);
  EXPECT_EQ(falling.work(0.0), 0.0);
}

TEST(LiquidBridgePull, MeanOfAShortWayIsTheForceThere) {
  // Half of the way times the slope, below 3/fall, and some ten roundings.
  for (const double way : {1e-20, 1e-15, 1e-10})
    EXPECT_NEAR(falling.mean(fall, fall + way) / falling.at(fall), 1.0, 1.5 * way / fall + 2e-15);
}

TEST(LiquidBridgePull, WithoutAFallIsConstant) {
  const Pull constant{force, 0.0};
  EXPECT_EQ(constant.at(1.0), force);
  EXPECT_EQ(constant.mean(0.0, 1e-5), force);
  EXPECT_EQ(constant.work(1e-5), 1e-5 * force);
}

}  // namespace cohesion::liquid_bridge
