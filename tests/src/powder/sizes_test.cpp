// SPDX-License-Identifier: BSD-3-Clause
#include "powder/sizes.h"

#include <gtest/gtest.h>

namespace cohesion::powder {

// Equal masses of 1 and 4: the Sauter mean is 2/(1/1 + 1/4), and there are 64 small ones for a
// large.
TEST(PowderSizes, OfTwoSizesTheMeanIsThatBySurface) {
  const PowderSizes sizes({{1.0, 3.0}, {4.0, 3.0}});
  EXPECT_NEAR(sizes.sauter(), 1.6, 1e-15);
  EXPECT_EQ(sizes.smallest(), 1.0);
  EXPECT_EQ(sizes.largest(), 4.0);
  EXPECT_NEAR(sizes.number_per_solid_volume() * 2.0 * sphere_volume(2.0), 65.0, 1e-13);
  EXPECT_NEAR(sizes.number_share(sizes.all()[0]), 64.0 / 65.0, 1e-15);
}

TEST(PowderSizes, OneSizeIsItsOwnMean) {
  const PowderSizes sizes({{3e-4, 0.2}});
  EXPECT_NEAR(sizes.sauter(), 3e-4, 1e-19);
  EXPECT_NEAR(sizes.number_per_solid_volume() * sphere_volume(1.5e-4), 1.0, 1e-15);
}

// 1/(0.3/20 + 0.4/40 + 0.3/80) um
TEST(PowderSizes, PercentilesAreWeightedBySwansonsRule) {
  EXPECT_NEAR(PowderSizes::of_percentiles(20.0, 40.0, 80.0).sauter(), 1.0 / 0.02875, 1e-12);
}

TEST(PowderSizes, WhatIsNoPowderIsRefused) {
  EXPECT_THROW(PowderSizes({}), InvalidParameter);
  EXPECT_THROW(PowderSizes({{0.0, 1.0}}), InvalidParameter);
  EXPECT_THROW(PowderSizes({{1.0, -1.0}}), InvalidParameter);
  EXPECT_THROW(PowderSizes::of_percentiles(2.0, 1.0, 3.0), InvalidParameter);
  EXPECT_THROW(PowderSizes::of_percentiles(1.0, 3.0, 2.0), InvalidParameter);
}

}  // namespace cohesion::powder
