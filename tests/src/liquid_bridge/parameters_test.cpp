// SPDX-License-Identifier: BSD-3-Clause
#include "liquid_bridge/parameters.h"

#include "liquid_bridge/range_of_validity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "refuses.h"

namespace cohesion::liquid_bridge {

TEST(LiquidBridge, RefusesWhatNoBridgeCanBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const LiquidBridgeParameters p :
       {LiquidBridgeParameters{-1e-6, 1e-5}, LiquidBridgeParameters{nan, 1e-5},
        LiquidBridgeParameters{infinity, 1e-5}, LiquidBridgeParameters{1e-6, -1e-5},
        LiquidBridgeParameters{1e-6, nan}, LiquidBridgeParameters{1e-6, infinity},
        LiquidBridgeParameters{1e-6, 0.0}, LiquidBridgeParameters{0.0, -1e-5}})
    EXPECT_THROW(require_valid(p), InvalidParameter) << p.force << " " << p.rupture_gap;
  EXPECT_NO_THROW(require_valid({1e-6, 1e-5}));
  EXPECT_NO_THROW(require_valid({0.0, 0.0}));
}

TEST(LiquidBridge, IsMixedByGeometricMeans) {
  const LiquidBridgeParameters m = mixed({1e-6, 4e-5}, {4e-6, 1e-5});
  EXPECT_DOUBLE_EQ(m.force, 2e-6);
  EXPECT_DOUBLE_EQ(m.rupture_gap, 2e-5);
  const LiquidBridgeParameters dry = mixed({1e-6, 4e-5}, {});
  EXPECT_EQ(dry.force, 0.0);
  EXPECT_NO_THROW(require_valid(dry));
}

TEST(LiquidBridge, IsAnAdhesionThatFormsAtTouch) {
  const contact::Adhesion a = adhesion_of({2e-6, 3e-5}, 1e-3, 2e-3);
  EXPECT_TRUE(a.forms_at_touch);
  EXPECT_EQ(a.force, 2e-6);
  EXPECT_EQ(a.cutoff, 3e-5);
  EXPECT_EQ(a.approach_energy(), 0.0);
  EXPECT_EQ(a.well_energy(), 2e-6 * 3e-5);
  EXPECT_EQ(adhesion_of({0.0, 3e-5}, 1e-3, 2e-3).cutoff, 0.0);
}

TEST(LiquidBridge, OfALiquidHasTheForceOfDerjaguinAndTheRuptureOfLian) {
  const double gamma = 0.072, theta = 0.5, volume = 1e-13, radius = 5e-4;
  const contact::Adhesion pair = adhesion_of(capillary(gamma, theta, volume), radius, radius);
  // Some five roundings each.
  EXPECT_NEAR(pair.force / (2.0 * pi * radius * gamma * std::cos(theta)), 1.0, 1e-15);
  EXPECT_NEAR(pair.cutoff / (1.25 * std::pow(volume, 1.0 / 3.0)), 1.0, 1e-15);
  EXPECT_NEAR(pair.fall / std::sqrt(volume / radius), 1.0, 1e-15);
  EXPECT_TRUE(pair.forms_at_touch);
  EXPECT_EQ(pair.well_energy(), pair.pull().work(pair.cutoff));
  // A wall is a sphere without end; between them the mean radius is harmonic.
  const contact::Adhesion wall = adhesion_of(capillary(gamma, theta, volume), radius, 0.0);
  EXPECT_NEAR(wall.force / pair.force, 2.0, 1e-15);
  EXPECT_NEAR(wall.fall / pair.fall, std::sqrt(0.5), 1e-15);
  EXPECT_EQ(wall.cutoff, pair.cutoff);
  const contact::Adhesion huge =
      adhesion_of(capillary(gamma, theta, volume), radius, 1e15 * radius);
  EXPECT_NEAR(huge.force / wall.force, 1.0, 3e-15);
  const contact::Adhesion unlike = adhesion_of(capillary(gamma, theta, volume), radius, 3 * radius);
  EXPECT_NEAR(unlike.force / pair.force, 1.5, 1e-15);
  EXPECT_EQ(adhesion_of(capillary(0.0, theta, volume), radius, radius).cutoff, 0.0);
}

TEST(LiquidBridge, RefusesWhatNoLiquidCanBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(capillary(-0.07, 0.0, 1e-13), InvalidParameter);
  EXPECT_THROW(capillary(nan, 0.0, 1e-13), InvalidParameter);
  EXPECT_THROW(capillary(0.07, -0.1, 1e-13), InvalidParameter);
  EXPECT_THROW(capillary(0.07, 30.0, 1e-13), InvalidParameter);  // degrees
  EXPECT_THROW(capillary(0.07, nan, 1e-13), InvalidParameter);
  EXPECT_THROW(capillary(0.07, 0.0, 0.0), InvalidParameter);
  EXPECT_THROW(capillary(0.07, 0.0, -1e-13), InvalidParameter);
  EXPECT_NO_THROW(capillary(0.0, 0.0, 0.0));
}

TEST(LiquidBridge, BreaksBelowTheRadiusOfTheSmallestParticle) {
  const double radius = 5e-4;
  EXPECT_NO_THROW(require_short(capillary(0.07, 0.0, 1e-3), 0.1));
  EXPECT_THROW(require_short(capillary(0.07, 0.0, 1e-3), radius), InvalidParameter);
  EXPECT_THROW(require_short({1e-4, 1.01 * radius}, radius), InvalidParameter);
  EXPECT_NO_THROW(require_short({1e-4, radius}, radius));
  EXPECT_NO_THROW(require_short(capillary(0.0, 0.0, 1e-3), radius));
  EXPECT_EQ(doubt_of_volume(capillary(0.07, 0.0, 1.2e-11), radius), "");
  EXPECT_NE(doubt_of_volume(capillary(0.07, 0.0, 1.3e-11), radius), "");
  EXPECT_EQ(doubt_of_volume(capillary(0.0, 0.0, 1.3e-11), radius), "");
  EXPECT_EQ(doubt_of_volume({1e-4, radius}, radius), "");
}

TEST(LiquidBridge, OfLiquidsIsMixedByGeometricMeans) {
  const LiquidBridgeParameters m = mixed(capillary(0.02, 0.0, 1e-13), capillary(0.08, 0.0, 4e-13));
  const LiquidBridgeParameters expected = capillary(0.04, 0.0, 2e-13);
  EXPECT_DOUBLE_EQ(m.tension, expected.tension);
  EXPECT_DOUBLE_EQ(m.volume, expected.volume);
  EXPECT_DOUBLE_EQ(m.rupture_gap, expected.rupture_gap);
  // A bridge of a constant force and one of a liquid have none with each other.
  EXPECT_EQ(adhesion_of(mixed({1e-6, 1e-5}, capillary(0.02, 0.0, 1e-13)), 1e-3, 1e-3).cutoff, 0.0);
}

}  // namespace cohesion::liquid_bridge
