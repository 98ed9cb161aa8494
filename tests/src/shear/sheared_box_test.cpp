// SPDX-License-Identifier: BSD-3-Clause
#include "shear/sheared_box.h"

#include <gtest/gtest.h>

#include <limits>

namespace cohesion::shear {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

}  // namespace

TEST(BoxStrain, OfManyStepsHasTheRoundingsOfOne) {
  BoxStrain strain{0.0, 0, 0.1, 1e-3};
  EXPECT_NEAR(strain.at(10000000), 1000.0, 2 * eps * 1000.0);
  // Asking again at every step changes nothing.
  for (int n = 0; n < 1000; n++) strain.continue_with(n, 0.1, 1e-3);
  EXPECT_EQ(strain.at(10000000), BoxStrain({0.0, 0, 0.1, 1e-3}).at(10000000));
}

TEST(BoxStrain, GoesOnFromWhereRateOrStepChanged) {
  BoxStrain strain{0.5, 10, 1.0, 0.25};
  strain.continue_with(14, -2.0, 0.25);
  EXPECT_EQ(strain.at(14), 1.5);
  EXPECT_EQ(strain.at(16), 0.5);
  strain.continue_with(16, -2.0, 0.5);
  EXPECT_EQ(strain.at(17), -0.5);
  EXPECT_EQ(strain.step_of_change, 16);
}

TEST(ImageShift, CountsBackWholeLengths) {
  const ImageShift shift{1.0, 8.0, 10.0};
  EXPECT_EQ(shift.whole(2.5), 21.0);
  EXPECT_EQ(shift.lengths_before(2.5, 1.0), 2.0);
  EXPECT_EQ(shift.tilt(2.5, 2.0), 1.0);
  EXPECT_EQ(shift.lengths_before(-2.5, 1.0), -2.0);
  EXPECT_EQ(shift.lengths_before(2.5, 1.0 + 1e-9), 2.0);
  EXPECT_EQ(shift.velocity(0.5), 4.0);
}

}  // namespace cohesion::shear
