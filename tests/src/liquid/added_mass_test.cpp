// SPDX-License-Identifier: BSD-3-Clause
#include "liquid/added_mass.h"

#include <gtest/gtest.h>

#include <limits>

#include "refuses.h"

namespace cohesion::liquid {

TEST(AddedMass, IsHalfOfTheDisplacedFluidUnlessGiven) {
  EXPECT_EQ(AddedMass().mass(1000.0, 2.0), 1000.0);
  EXPECT_EQ(AddedMass(0.75).mass(1000.0, 2.0), 1500.0);
}

TEST(AddedMass, RefusesWhatIsNotPositive) {
  for (const double c : {0.0, -0.5, std::numeric_limits<double>::quiet_NaN()})
    expect_refused([&] { AddedMass{c}; }, "addedMass = ");
}

}  // namespace cohesion::liquid
