// SPDX-License-Identifier: BSD-3-Clause
#include "liquid_bridge/parameters.h"

#include <gtest/gtest.h>

#include <limits>

#include "refuses.h"

namespace cohesion::liquid_bridge {

TEST(LiquidBridge, RefusesWhatNoBridgeCanBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Parameters p :
       {Parameters{-1e-6, 1e-5}, Parameters{nan, 1e-5}, Parameters{infinity, 1e-5},
        Parameters{1e-6, -1e-5}, Parameters{1e-6, nan}, Parameters{1e-6, infinity},
        Parameters{1e-6, 0.0}, Parameters{0.0, -1e-5}})
    EXPECT_THROW(require_valid(p), InvalidParameter) << p.force << " " << p.rupture_gap;
  EXPECT_NO_THROW(require_valid({1e-6, 1e-5}));
  EXPECT_NO_THROW(require_valid({0.0, 0.0}));
}

TEST(LiquidBridge, IsMixedByGeometricMeans) {
  const Parameters m = mixed({1e-6, 4e-5}, {4e-6, 1e-5});
  EXPECT_DOUBLE_EQ(m.force, 2e-6);
  EXPECT_DOUBLE_EQ(m.rupture_gap, 2e-5);
  const Parameters dry = mixed({1e-6, 4e-5}, {});
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

}  // namespace cohesion::liquid_bridge
