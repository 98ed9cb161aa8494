// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/contact_output.h"

#include <gtest/gtest.h>

namespace cohesion::contact_solver {
namespace {

constexpr double step = 0.01;
const Vector3 separation{1.2, -2.0, 1.5};

/// A contact of two unequal spheres that touch where they overlap.
struct Contact {
  ContactBodies of{{1.0, 0.5}, {2.0, 0.25}};
  const ContactBodies& bodies() const { return of; }
  StoredEnergies stored(const Vector3&, const ContactHistory&) const {
    return {3.0, 100.0, 100.0, -5.0, 100.0};
  }
  bool touches(double overlap, const ContactHistory&) const { return overlap > 0.0; }
  double friction_load(double, const ContactHistory&) const { return 0.75; }
};

ContactHistory history(double force) {
  ContactHistory h;
  h.normal.phase = ContactState::inside;
  h.normal.force = force;
  h.sliding.impulse = (1.0 / dot(separation, separation)) * cross(separation, {0.3, 0.1, -0.2});
  h.rolling.impulse = (1.0 / dot(separation, separation)) * cross(separation, {-0.1, 0.4, 0.2});
  return h;
}

}  // namespace

TEST(ContactOutput, FrictionAndRollingAreThoseOfTheForces) {
  const Contact contact;
  const ContactHistory h = history(4.0);
  const ContactOutput out = output_of(contact, separation, h, step);
  const PairAction forces = forces_of(contact, separation, h, step);
  EXPECT_EQ(out.place, ContactOutput::touching);
  EXPECT_EQ(out.force, 4.0);
  // On j: the normal force away from i, and the reverse of the friction on i.
  const Vector3 on_j = (out.force / norm(separation)) * separation - out.friction;
  EXPECT_NEAR(norm(forces.impulse - on_j), 0.0, 1e-14 * norm(on_j));
  EXPECT_NEAR(norm(out.friction + (1.0 / step) * h.sliding.impulse), 0.0, 1e-14);
  // The torque on i is that of friction at its lever, and of rolling.
  const double lever = 1.0 / 3.0;  // R_i/(R_i + R_j)
  const Vector3 by_friction = lever * cross(separation, out.friction);
  EXPECT_NEAR(norm(forces.torque_i - by_friction - out.rolling_torque), 0.0,
              1e-14 * norm(forces.torque_i));
  EXPECT_GT(norm(out.rolling_torque), 0.1 * norm(forces.torque_i));
}

TEST(ContactOutput, ForcesKeepTheAngularMomentum) {
  const PairAction f = forces_of(Contact{}, separation, history(4.0), step);
  EXPECT_NEAR(norm(f.torque_i + f.torque_j + cross(separation, f.impulse)), 0.0,
              1e-14 * norm(f.torque_i));
}

TEST(ContactOutput, CoulombsLimitIsNotNegative) {
  for (const double force : {4.0, -0.5, -2.0}) {
    const ContactOutput out = output_of(Contact{}, separation, history(force), step);
    EXPECT_EQ(out.limiting, force > -0.75 ? force + 0.75 : 0.0);
  }
}

TEST(ContactOutput, APairInItsRangeHasEnergyAndForceButNoFriction) {
  const Vector3 apart = 2.0 * separation;
  ContactHistory h = history(-2.0);
  ContactOutput out = output_of(Contact{}, apart, h, step);
  EXPECT_EQ(out.place, ContactOutput::in_range);
  EXPECT_DOUBLE_EQ(out.overlap, 3.0 - norm(apart));
  EXPECT_EQ(out.force, -2.0);
  EXPECT_EQ(out.energy, 3.0 - 5.0);
  EXPECT_EQ(norm(out.friction) + norm(out.rolling_torque) + out.limiting, 0.0);
  h.normal.phase = ContactState::outside;
  EXPECT_EQ(output_of(Contact{}, apart, h, step).place, ContactOutput::apart);
}

}  // namespace cohesion::contact_solver
