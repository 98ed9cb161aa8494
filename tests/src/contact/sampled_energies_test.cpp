// SPDX-License-Identifier: BSD-3-Clause
#include "contact/sampled_energies.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cohesion::contact {
namespace {

TEST(SampledEnergies, SpringIsTheWorkOfItsForce) {
  for (const double p : {1.0, 1.5}) {
    // c x^(p+1)/(p+1), c = K x^(1-p).
    EXPECT_DOUBLE_EQ(normal_spring_energy(2e-6, 800.0, p), 800.0 * 2e-6 * 2e-6 / (p + 1.0));
    EXPECT_EQ(normal_spring_energy(-2e-6, 800.0, p), 0.0);
  }
  EXPECT_DOUBLE_EQ(tangential_spring_energy({0.0, 1e-7, 2e-7}, 300.0), 150.0 * 5e-14);
}

TEST(SampledEnergies, NormalDashpotIsWhatTheSpringIsNot) {
  EXPECT_NEAR(normal_dashpot(900e-6, 1e-6, 800.0), 100e-6, 1e-15);
  EXPECT_EQ(normal_dashpot(0.0, -1e-6, 800.0), 0.0);  // of a pair at a gap
}

TEST(SampledEnergies, TangentialDashpotActsWhereTheContactSticks) {
  const Vector3 normal{1.0, 0.0, 0.0}, slip{0.0, 0.02, -0.01};
  const Vector3 spring = -300.0 * Vector3{0.0, 1e-7, 2e-7};
  const Vector3 sticking = spring - 4e-4 * slip;
  EXPECT_EQ(acting_damping(sticking, spring, 4e-4, slip), 4e-4);
  EXPECT_EQ(acting_damping(sticking + 2e-3 * normal, spring, 4e-4, slip), 4e-4);
  EXPECT_EQ(acting_damping(spring, spring, 4e-4, slip), 0.0);  // at the Coulomb limit
}

TEST(SampledEnergies, RollingSpring) {
  EXPECT_DOUBLE_EQ(rolling_spring_energy({0.0, 3e-8, 4e-8}, 200.0, 2.5e-4),
                   0.5 * 25e-16 / (200.0 * 6.25e-8));
  EXPECT_EQ(rolling_spring_energy({0.0, 3e-8, 4e-8}, 0.0, 2.5e-4), 0.0);
}

}  // namespace
}  // namespace cohesion::contact
