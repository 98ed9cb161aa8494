// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/contact_bodies.h"

#include <gtest/gtest.h>

#include <limits>

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double mass = 1.4e-6;
const Body small{0.5e-3, 1.0 / mass}, large{0.8e-3, 1.0 / (4.1 * mass)}, wall{0.0, 0.0};
const Vector3 place{1.1e-3, -0.5e-3, 0.4e-3};

}  // namespace

TEST(ContactBodies, RollWithTheReducedRadiusAndTheInertiaOfBoth) {
  const ContactBodies pair(small, large);
  const double reduced = 0.5e-3 * 0.8e-3 / 1.3e-3;
  EXPECT_NEAR(pair.rolling_radius() / reduced, 1.0, 4 * eps);
  const double inertia = 0.4 * mass * 0.25e-6, other = 0.4 * 4.1 * mass * 0.64e-6;
  EXPECT_NEAR(pair.inverse_rolling_mass() / (reduced * reduced * (1.0 / inertia + 1.0 / other)),
              1.0, 16 * eps);
  const ContactBodies beside(small, wall);
  EXPECT_EQ(beside.rolling_radius(), 0.5e-3);
  EXPECT_NEAR(beside.inverse_rolling_mass() * mass, 2.5, 16 * eps);
}

TEST(ContactBodies, SolidSpheresAnswerSlidingWithTwoSeventhsOfTheReducedMass) {
  // Lever arms are the radii at touch: 1/m_t = 7/2 (1/m_i + 1/m_j).
  for (const Body& other : {small, large, wall}) {
    const ContactBodies c(small, other);
    EXPECT_NEAR(c.inverse_sliding_mass() * c.reduced_mass(), 3.5, 32 * eps);
  }
}

TEST(ContactBodies, AnImpulseAtTheSurfaceKeepsTheAngularMomentum) {
  const ContactBodies pair(small, large);
  const ContactBodies::Touch touch(pair, place);
  PairAction a;
  const Vector3 impulse{0.3, 0.2, -0.7};
  touch.add_sliding_impulse(impulse, a);
  touch.add_rolling_impulse(impulse, a);
  EXPECT_EQ(norm(a.impulse - impulse), 0.0);
  // J at j, -J at i: s x J, and the torques.
  const Vector3 left = cross(place, impulse) + a.torque_i + a.torque_j;
  EXPECT_LE(norm(left), 8 * eps * norm(place) * norm(impulse));
}

TEST(ContactBodies, NothingSlidesOrRollsOnAPairThatTurnsAsOneBody) {
  const Vector3 turn{30.0, -20.0, 50.0};
  const double size = 8 * eps * norm(turn) * norm(place);
  const ContactBodies pair(small, large);
  const ContactBodies::Touch touch(pair, place);
  EXPECT_LE(norm(touch.sliding_velocity(cross(turn, place), turn, turn)), size);
  EXPECT_EQ(norm(touch.rolling_velocity(turn, turn)), 0.0);
  // Nor does spin about the normal, but for the rounding of its part in the plane.
  EXPECT_LE(norm(touch.rolling_velocity(1e4 * place, {})), 8 * eps * 1e4 * norm(place) * 1e-3);
}

TEST(ContactBodies, TheArmBesideAWallIsTheRadiusAtAnyDistance) {
  const ContactBodies beside(small, wall);
  const Vector3 spin{0.0, 0.0, 40.0};
  for (const double distance : {0.45e-3, 0.5e-3, 0.6e-3}) {
    const ContactBodies::Touch touch(beside, {distance, 0.0, 0.0});
    EXPECT_NEAR(norm(touch.sliding_velocity({}, spin, {})) / (40.0 * 0.5e-3), 1.0, 4 * eps);
  }
}

}  // namespace cohesion::contact_solver
