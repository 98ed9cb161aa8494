// SPDX-License-Identifier: BSD-3-Clause
#include "sampled_contact/sampled_contact.h"

#include <gtest/gtest.h>

#include "contact_solver/exact_contact.h"
#include "contact_solver/thesis_contact.h"
#include "sampled_contact/sampled_bridge.h"

namespace cohesion::sampled_contact {
namespace {

constexpr int size = ContactHistory::with_rolling;
constexpr double core = 2.0 * thesis::radius, dt = 1e-5;
const Body particle{thesis::radius, 0.5 / thesis::reduced_mass};

using Contact = SampledContact<SampledBridge>;

Contact contact_of(const contact::ContactParameters& p) {
  return {p, {1e-4, 0.05 * core, 0.0, true, {}, 0.0}, particle, particle, {0.5 * dt, 0.5 * dt}};
}

contact::ContactParameters with_friction() {
  contact::ContactParameters p = thesis::contact();
  p.friction = 0.3;
  p.rolling_friction = 0.1;
  return p;
}

/// As advance_persistent() reads a PairMotion.
struct Motion {
  PairMotion now;
  Vector3 separation() const { return now.separation; }
  Vector3 velocity() const { return now.velocity; }
  Vector3 spin_i() const { return now.spin_i; }
  Vector3 spin_j() const { return now.spin_j; }
};

Motion at_overlap(double overlap, double sideways) {
  return {{{core - overlap, 0.0, 0.0}, {-0.01, sideways, 0.0}, {0.0, 1.0, 2.0}, {3.0, 0.0, 1.0}}};
}

ContactHistory inside() {
  ContactHistory history;
  history.normal.phase = ContactState::inside;
  history.sliding = {{0.0, 2e-8, 1e-8}, {0.0, 1e-10, 0.0}};
  history.rolling = {{0.0, 1e-8, 0.0}, {0.0, 0.0, 1e-11}};
  return history;
}

bool persists(const Contact& c, const Motion& motion, double* values) {
  FrictionalStep step;
  return c.advance_persistent<size, ContactMotion>(motion, values, step, nullptr);
}

}  // namespace

TEST(SampledContact, AdvancesATouchingPairOnTheShortPathAsOnTheOther) {
  const Contact c = contact_of(with_friction());
  for (const double sideways : {1e-4, 0.5}) {  // sticks, slips
    const Motion motion = at_overlap(1e-6, sideways);
    ContactHistory history = inside();
    double before[size], values[size], expected[size];
    history.store(before, size);
    history.store(values, size);
    FrictionalStep step;
    ContactEnergies energies, other;
    ASSERT_TRUE((c.advance_persistent<size, ContactMotion>(motion, values, step, &energies)));
    const FrictionalStep whole = c.advance<size>(motion.now, {}, false, history, &other);
    history.store(expected, size);
    for (int k = 0; k < size; k++) EXPECT_DOUBLE_EQ(values[k], expected[k]) << k;
    EXPECT_NEAR(norm(step.impulse - whole.impulse), 0.0, 1e-15 * norm(whole.impulse));
    EXPECT_NEAR(norm(step.torque_i - whole.torque_i), 0.0, 1e-15 * norm(whole.torque_i));
    EXPECT_NEAR(norm(step.friction - whole.friction), 0.0, 1e-15 * norm(whole.friction));
    EXPECT_DOUBLE_EQ(step.repulsion, whole.repulsion);
    EXPECT_DOUBLE_EQ(energies.before.normal_damping, other.before.normal_damping);
    EXPECT_DOUBLE_EQ(energies.before.tangential_damping, other.before.tangential_damping);
    EXPECT_DOUBLE_EQ(energies.before.rolling, other.before.rolling);
    EXPECT_DOUBLE_EQ(energies.after.normal_damping, other.after.normal_damping);
    const StoredEnergies stored = c.stored_persistent<size>(motion.now, before, values);
    EXPECT_DOUBLE_EQ(stored.spring, other.stored.spring);
    EXPECT_DOUBLE_EQ(stored.tangential_spring, other.stored.tangential_spring);
    EXPECT_DOUBLE_EQ(stored.rolling_spring, other.stored.rolling_spring);
    EXPECT_DOUBLE_EQ(stored.adhesion, other.stored.adhesion);
  }
}

TEST(SampledContact, TheShortPathLeavesAllOtherPairsUnchanged) {
  const Contact c = contact_of(with_friction());
  contact::ContactParameters hertz = with_friction();
  hertz.stiffness = 0.0;
  contact::set_hertz(hertz, 7.1e7, 0.25);
  const auto unchanged = [](const Contact& law, double overlap, ContactState::Phase phase) {
    ContactHistory history = inside();
    history.normal.phase = phase;
    double values[size], before[size];
    history.store(values, size);
    history.store(before, size);
    EXPECT_FALSE(persists(law, at_overlap(overlap, 0.01), values));
    for (int k = 0; k < size; k++) EXPECT_EQ(values[k], before[k]) << k;
  };
  unchanged(c, -1e-6, ContactState::inside);
  unchanged(c, 1e-6, ContactState::outside);
  unchanged(c, 1e-6, ContactState::unknown);
  unchanged(contact_of(hertz), 1e-6, ContactState::inside);
}

}  // namespace cohesion::sampled_contact
