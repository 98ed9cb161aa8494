// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "contact_solver/exact_contact.h"
#include "contact_solver/spheres.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const Body small = thesis::particle(), large{0.8e-3, 1.0 / (4.1 * thesis::mass)};
constexpr double step_length = thesis::contact_time / 10.0;
constexpr double pull = 1e-4;  // [N]: adhesion that holds the pairs at rest
constexpr double stiffness = 2.0 / 7.0 * 800.0, damping = 0.5 * 0.79e-3;  // of the rolling spring
// A force is known to some roundings of the distance of 1e-3 m in a step: 10 1e-19 m mu/dt^2 =
// 1e-14 N of `pull`.
constexpr double force_error = 1e-10;

contact::ContactParameters rolling(double coefficient) {
  contact::ContactParameters p = thesis::contact();
  p.rolling_friction = coefficient;
  return p;
}

/// A pair at rest under the adhesion `pull`, long enough for its contact to be persistent; only its
/// spins change. x is the line of centres.
struct Pressed : Spheres<ContactSolver, ContactHistory::with_rolling> {
  Pressed(const contact::ContactParameters& p, const Body& i, const Body& j)
      : Spheres(p, {pull, thesis::range, pull * thesis::range}, step_length) {
    const double overlap = pull / p.stiffness;
    add(i, {}, {});
    if (j.inverse_mass > 0.0)
      add(j, {i.radius + j.radius - overlap, 0.0, 0.0}, {});
    else
      add_wall({{i.radius - overlap, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {}});
    steps(3);
  }
  Contact& contact() { return contacts[0]; }
  const ContactBodies& bodies() { return law(contact()).bodies(); }
  DiscreteSpring::State& spring() { return contact().history.rolling; }
  bool is_persistent() const {
    return contacts[0].history.normal.phase == ContactState::persistent;
  }
  Vector3 rolling_velocity() {
    const PairMotion now = motion(contact());
    return bodies().rolling_radius() * (now.spin_i - now.spin_j);
  }
};

/// Rate of decay and frequency of a rolling spring.
struct Swing {
  double alpha, q;
  explicit Swing(double inverse_mass)
      : alpha(0.5 * damping * inverse_mass),
        q(std::sqrt(stiffness * inverse_mass - alpha * alpha)) {}
};

}  // namespace

TEST(ContactRolling, APersistentContactSwingsAndDecaysExactlyAtAnyStep) {
  // m_r v' = -K_r s - eta_r v, s' = v: s = (v0/q) exp(-alpha t) sin(q t) at time levels, the
  // staggered velocity its difference over a step.
  for (const bool short_path : {false, true}) {
    Pressed pair(rolling(0.1), small, large);
    pair.short_path = short_path;
    ASSERT_TRUE(pair.is_persistent());
    const Swing swing(pair.bodies().inverse_rolling_mass());
    const Vector3 v0 = pair.bodies().rolling_radius() * Vector3{0.0, 1e-3, -2e-3};
    const auto part = [&](double n) {
      return std::exp(-swing.alpha * n * step_length) * std::sin(swing.q * n * step_length) /
             swing.q;
    };
    const double start = -part(-1.0) / step_length;
    pair.spheres[0].spin = {7.0, 2e-3 * start, -1e-3 * start};  // about x nothing rolls
    pair.spheres[1].spin = {-3.0, 1e-3 * start, 1e-3 * start};
    pair.spring().stretch = part(-1.0) * v0;
    const int steps = 1000;
    for (int n = 1; n <= steps; n++) {
      pair.step();
      ASSERT_TRUE(pair.is_persistent());
      const Vector3 expected = ((part(n) - part(n - 1)) / step_length) * v0;
      // Some ten roundings of spins, and what they become in the swing.
      EXPECT_NEAR(pair.rolling_velocity().y, expected.y, 16 * eps * n * norm(v0));
      EXPECT_NEAR(pair.rolling_velocity().z, expected.z, 16 * eps * n * norm(v0));
    }
    EXPECT_LT(std::exp(-swing.alpha * steps * step_length), 0.3);
    EXPECT_EQ(pair.spheres[0].spin.x, 7.0);
    EXPECT_EQ(pair.spheres[1].spin.x, -3.0);
  }
}

TEST(ContactRolling, ARollerIsBrakedByTheCoulombTorqueAndStops) {
  // Equal spheres with opposite spins: I w' = -R mu_R N, R = r/2, as long as they roll.
  const double coefficient = 0.05, spin = 20.0;
  Pressed pair(rolling(coefficient), small, small);
  pair.spheres[0].spin = {0.0, spin, 0.0};
  pair.spheres[1].spin = {0.0, -spin, 0.0};
  const double start = pair.kinetic_energy();
  const double friction = coefficient * pull;
  const double rate = inverse_inertia(small) * 0.5 * thesis::radius * friction;
  const int stops = static_cast<int>(spin / rate / step_length);
  ASSERT_GT(stops, 200);
  pair.step();
  const double energy = pair.energy;
  for (int n = 2; n < stops; n++) {
    const double before = pair.spheres[0].spin.y;
    pair.step();
    // The first step stretches the spring to mu_R N/K_r at R 2 w.
    EXPECT_NEAR((before - pair.spheres[0].spin.y) / (rate * step_length), 1.0, force_error);
    EXPECT_NEAR(pair.spheres[0].spin.y, -pair.spheres[1].spin.y, 4 * eps * spin);
  }
  ASSERT_TRUE(pair.is_persistent());
  pair.steps(4000);
  // At rest, but for what the spring swings with, which decays at alpha.
  const Swing swing(pair.bodies().inverse_rolling_mass());
  const double decay = std::exp(-swing.alpha * 4000 * step_length);
  EXPECT_LT(decay, 1e-2);
  EXPECT_LE(pair.kinetic_energy(), friction * friction / stiffness * decay * decay);
  // What is lost is known to the impulse of one step, J^2/(8 m_r): the mean force of a step works
  // on the mean of the true velocities at its ends, the staggered one up to (J' - J)/(4 m_r).
  const double impulse = friction * step_length;
  EXPECT_NEAR(pair.energy, energy,
              64 * eps * (stops + 4000) * start +
                  impulse * impulse * pair.bodies().inverse_rolling_mass() / 8.0);
  EXPECT_GT(pair.lost, 0.999 * start);
}

TEST(ContactRolling, HoldsBelowTheCoulombTorqueAndYieldsAboveIt) {
  // A steady torque on a sphere at a wall, as another contact's: below R mu_R N it comes to rest,
  // above it the spin grows by what is left over.
  const double coefficient = 0.05;
  for (const double part : {0.4, 1.2}) {
    Pressed pair(rolling(coefficient), small, {0.0, 0.0});
    const double most = thesis::radius * coefficient * pull;
    const double others = inverse_inertia(small) * part * most * step_length;
    double before = 0.0;
    for (int n = 0; n < 4000; n++) {
      before = pair.spheres[0].spin.z;
      pair.step();
      pair.spheres[0].spin.z += others;
    }
    ASSERT_TRUE(pair.is_persistent());
    if (part < 1.0) {
      // The swing about the stretch at rest has decayed.
      const Swing swing(pair.bodies().inverse_rolling_mass());
      const double decay = std::exp(-swing.alpha * 4000 * step_length);
      ASSERT_LT(decay, 1e-5);
      EXPECT_LT(std::abs(pair.spheres[0].spin.z), 2.0 * decay * others / (swing.q * step_length));
    } else {
      EXPECT_NEAR((pair.spheres[0].spin.z - before) / (others * (1.0 - 1.0 / part)), 1.0,
                  force_error / (part - 1.0));
    }
  }
}

TEST(ContactRolling, NothingResistsPairsThatTurnAsOneBodyOrSpin) {
  Pressed pair(rolling(0.1), small, large);
  pair.spheres[0].spin = pair.spheres[1].spin = {1.0, 2.0, 3.0};
  pair.step();
  EXPECT_EQ(norm(pair.spring().impulse), 0.0);
  // About the normal it spins, which is not resisted; but for the rounding of its part in the
  // plane.
  pair.spheres[0].spin = {5.0, 2.0, 3.0};
  pair.step();
  EXPECT_LT(norm(pair.spring().impulse),
            8 * eps * 5.0 * pair.bodies().rolling_radius() / pair.bodies().inverse_rolling_mass());
}

TEST(ContactRolling, WhatTheSpringHeldIsLostWhereTheContactEnds) {
  Pressed pair(rolling(0.1), small, large);
  const double stretch = 1e-9;
  pair.spring().stretch = {0.0, stretch, 0.0};
  pair.spheres[1].v.x = 0.1;
  const double lost = pair.lost;
  for (int n = 0; n < 10 && !pair.are_apart(); n++) pair.step();
  ASSERT_TRUE(pair.are_apart());
  EXPECT_EQ(norm(pair.spring().stretch), 0.0);
  EXPECT_GT(pair.lost, lost);
  EXPECT_EQ(norm(pair.spring().impulse), 0.0);
}

TEST(ContactRolling, AWallIsTheLimitOfALargeSphere) {
  Pressed beside(rolling(0.02), small, {0.0, 0.0});
  Pressed sphere(rolling(0.02), small, {1e5 * thesis::radius, 1e-15 / thesis::mass});
  beside.spheres[0].spin = sphere.spheres[0].spin = {0.0, 3.0, -4.0};
  for (int n = 0; n < 200; n++) {
    beside.step();
    sphere.step();
    // 1/ratio from R. The place of the huge sphere, 50 m away, is rounded by 7e-15 m: a force of
    // m 7e-15 m/step_length^2 = 1e-6 of the pull, some of them in a step.
    EXPECT_LT(norm(beside.spheres[0].spin - sphere.spheres[0].spin), 5.0 * (1e-5 + 1e-5));
  }
  EXPECT_LT(norm(beside.spheres[0].spin), 4.0);
}

}  // namespace cohesion::contact_solver
