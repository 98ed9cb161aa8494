// SPDX-License-Identifier: BSD-3-Clause
#include "contact/sampled_energies.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cohesion::contact {
namespace {

TEST(SampledEnergies, SpringIsTheWorkOfItsForce) {
  for (const double p : {1.0, 1.5}) {
    ContactSample c;
    c.overlap = 2e-6;
    c.exponent = p;
    c.stiffness = 800.0;
    // c x^(p+1)/(p+1), c = K x^(1-p).
    EXPECT_DOUBLE_EQ(c.spring_energy(), 800.0 * 2e-6 * 2e-6 / (p + 1.0));
    c.overlap = -2e-6;
    EXPECT_EQ(c.spring_energy(), 0.0);
  }
}

TEST(SampledEnergies, NormalDashpotIsWhatTheSpringIsNot) {
  ContactSample c;
  c.normal = {0.6, 0.0, 0.8};
  c.overlap = 1e-6;
  c.stiffness = 800.0;
  c.repulsion = 900e-6;
  EXPECT_NEAR(dot(c.normal_dashpot(), c.normal), 100e-6, 1e-15);
  c.overlap = -1e-6;  // of a pair at a gap
  c.repulsion = 0.0;
  EXPECT_EQ(dot(c.normal_dashpot(), c.normal), 0.0);
}

TEST(SampledEnergies, TangentialDashpotActsWhereTheContactSticks) {
  ContactSample c;
  c.normal = {1.0, 0.0, 0.0};
  c.slip = {0.0, 0.02, -0.01};
  c.displacement = {0.0, 1e-7, 2e-7};
  c.tangential_stiffness = 300.0;
  c.tangential_damping = 4e-4;
  c.tangential = -300.0 * c.displacement - 4e-4 * c.slip;
  EXPECT_TRUE(c.sticks());
  EXPECT_EQ(norm(c.tangential_dashpot() + 4e-4 * c.slip), 0.0);
  EXPECT_DOUBLE_EQ(c.tangential_spring_energy(), 150.0 * 5e-14);
  c.tangential = -300.0 * c.displacement;  // at the Coulomb limit
  EXPECT_FALSE(c.sticks());
}

TEST(SampledEnergies, RollingSpring) {
  EXPECT_DOUBLE_EQ(rolling_spring_energy({0.0, 3e-8, 4e-8}, 200.0, 2.5e-4),
                   0.5 * 25e-16 / (200.0 * 6.25e-8));
  EXPECT_EQ(rolling_spring_energy({0.0, 3e-8, 4e-8}, 0.0, 2.5e-4), 0.0);
}

}  // namespace
}  // namespace cohesion::contact
