// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/hard_contact_parameters.h"

#include <gtest/gtest.h>

#include "refuses.h"

namespace cohesion::hard_sphere {

TEST(HardContactParameters, UnlikeMaterialsHaveGeometricMeansAndTheirOwnRatios) {
  const HardContactParameters a{0.9, 0.3, square_well::well(2.0, 1.1)};
  const HardContactParameters b{0.4, 0.0, square_well::well(8.0, 1.5)};
  const HardContactParameters m = mixed(a, b);
  EXPECT_DOUBLE_EQ(m.restitution, 0.6);
  EXPECT_EQ(m.friction, 0.0);  // of a smooth and a rough material
  EXPECT_DOUBLE_EQ(m.well.depth, 4.0);
  EXPECT_EQ(m.well.ratio_i, 1.1);
  EXPECT_EQ(m.well.ratio_j, 1.5);
  EXPECT_DOUBLE_EQ(mixed(a, a).friction, 0.3);
}

TEST(HardContactParameters, LawHasTheCoreAndTheDepth) {
  const ImpactLaw law = HardContactParameters{0.9, 0.3, square_well::well(2.0, 1.1)}.law();
  EXPECT_EQ(law.restitution, 0.9);
  EXPECT_EQ(law.friction, 0.3);
  EXPECT_EQ(law.depth, 2.0);
}

TEST(HardContactParameters, RejectsInvalidParameters) {
  require_valid(HardContactParameters{});
  require_valid(HardContactParameters{0.0, 1.0, square_well::well(1.0, 1.001)});
  require_valid(HardContactParameters{1.0, 0.0, square_well::well(0.0, 1.0)});
  expect_refused([] { require_valid(HardContactParameters{1.1, 0.0, {}}); }, "restitution e");
  expect_refused([] { require_valid(HardContactParameters{1.0, -0.1, {}}); }, "friction mu");
  expect_refused(
      [] { require_valid(HardContactParameters{1.0, 0.0, square_well::well(-1.0, 1.1)}); },
      "depth D");
  expect_refused(
      [] { require_valid(HardContactParameters{1.0, 0.0, square_well::well(1.0, 1.0)}); },
      "must be above 1");
}

}  // namespace cohesion::hard_sphere
