// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/turning.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cohesion::contact_solver {

TEST(Turning, TheLargestRangeChangesTheCentrifugalAccelerationByATenth) {
  // (1 + 1/30)^3 = 1.1033
  EXPECT_NEAR(std::pow(1.0 + largest_range_over_distance, 3), 1.10, 0.005);
}

TEST(Turning, AnAdhesionOfWiderRangeIsRefused) {
  contact::Adhesion adhesion{};
  adhesion.force = 1e-6;
  const double largest = 6e-4 / 30.0;
  adhesion.cutoff = largest;
  EXPECT_NO_THROW(require_turns_as_touching(adhesion, 6e-4));
  adhesion.cutoff = 1.00001 * largest;
  EXPECT_THROW(require_turns_as_touching(adhesion, 6e-4), InvalidParameter);
  adhesion.force = 0.0;
  EXPECT_NO_THROW(require_turns_as_touching(adhesion, 6e-4));
}

}  // namespace cohesion::contact_solver
