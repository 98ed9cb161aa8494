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
  const Vector3 sticking = -4e-4 * slip;
  EXPECT_TRUE(dashpot_acts(sticking, 4e-4, slip));
  EXPECT_TRUE(dashpot_acts(sticking + 2e-3 * normal, 4e-4, slip));
  EXPECT_FALSE(dashpot_acts(0.9 * sticking, 4e-4, slip));  // at the Coulomb limit
}

TEST(SampledEnergies, RollingSpring) {
  EXPECT_DOUBLE_EQ(rolling_spring_energy({0.0, 3e-8, 4e-8}, 200.0, 2.5e-4),
                   0.5 * 25e-16 / (200.0 * 6.25e-8));
  EXPECT_EQ(rolling_spring_energy({0.0, 3e-8, 4e-8}, 0.0, 2.5e-4), 0.0);
}

constexpr double DAMPING = 4e-4;
const Vector3 SLIP{0.016, 0.01, -0.012};

/// The force on i of spring and dashpots of a contact, with no part that vanishes by symmetry.
SampledForces oblique_forces() {
  const Vector3 normal{0.6, 0.0, 0.8};
  const Vector3 tangential{-0.8e-3, 0.5e-3, 0.6e-3};
  return {normal, 2e-3 * normal + tangential, -DAMPING * SLIP - tangential, 5e-4, 3e-4, 7e-4};
}
const SphereMotion MOTION_I{{0.1, -0.2, 0.05}, {30.0, -20.0, 10.0}};
const SphereMotion MOTION_J{{-0.04, 0.01, 0.02}, {-5.0, 40.0, 15.0}};

/// The power of a force on one sphere at its point of contact, `arm` from its centre.
double power_at(const Vector3& force, const SphereMotion& m, const Vector3& arm) {
  return dot(force, m.velocity + cross(m.spin, arm));
}

TEST(SampledEnergies, PowersAreThoseOfTheForcesOnBothSpheres) {
  const SampledForces c = oblique_forces();
  const ContactPowers powers = contact_powers(c, MOTION_I, MOTION_J);
  const auto power_of = [&](const Vector3& force) {
    return power_at(force, MOTION_I, -c.lever_i * c.normal) -
           power_at(force, MOTION_J, c.lever_j * c.normal);
  };
  const Vector3 along = dot(c.force, c.normal) * c.normal;
  EXPECT_NEAR(powers.friction, power_of(c.force - along), 1e-12 * norm(c.force));
  EXPECT_NEAR(powers.tangential_dashpot, power_of(-DAMPING * SLIP), 1e-12 * norm(c.force));
  EXPECT_NEAR(powers.normal_dashpot, power_of(c.normal_dashpot * c.normal),
              1e-12 * c.normal_dashpot);
  EXPECT_EQ(powers.rolling, 0.0);
}

TEST(SampledEnergies, SphereAtAWallHasItsOwnShareOfThePowers) {
  const SampledForces c = oblique_forces();
  const ContactPowers alone = contact_powers(c, MOTION_I);
  const ContactPowers beside_rest = contact_powers(c, MOTION_I, SphereMotion{});
  EXPECT_DOUBLE_EQ(alone.friction, beside_rest.friction);
  EXPECT_DOUBLE_EQ(alone.tangential_dashpot, beside_rest.tangential_dashpot);
  EXPECT_DOUBLE_EQ(alone.normal_dashpot, beside_rest.normal_dashpot);
}

TEST(SampledEnergies, MovingWallAddsThePowersOfTheReverseForces) {
  const SampledForces c = oblique_forces();
  ContactPowers sum = contact_powers(c, MOTION_I);
  sum += wall_powers(c, MOTION_J.velocity);
  const ContactPowers both = contact_powers(c, MOTION_I, {MOTION_J.velocity, {}});
  EXPECT_NEAR(sum.friction, both.friction, 1e-12 * norm(c.force));
  EXPECT_NEAR(sum.tangential_dashpot, both.tangential_dashpot, 1e-12 * norm(c.force));
  EXPECT_NEAR(sum.normal_dashpot, both.normal_dashpot, 1e-12 * c.normal_dashpot);
}

TEST(SampledEnergies, RollingTorqueIsWhatTheTangentialForceHasNot) {
  const SampledForces c = oblique_forces();
  const Vector3 rolling{1e-7, -2e-7, 3e-7};
  const Vector3 by_force = cross(-c.lever_i * c.normal, c.force);
  EXPECT_NEAR(norm(rolling_torque(by_force + rolling, c.lever_i, c) - rolling), 0.0,
              1e-12 * norm(by_force));
  EXPECT_NEAR(norm(rolling_torque(by_force, c.lever_i, c)), 0.0, 1e-12 * norm(by_force));
}

}  // namespace
}  // namespace cohesion::contact
