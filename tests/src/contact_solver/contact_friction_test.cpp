// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "constants.h"
#include "contact_solver/exact_contact.h"
#include "contact_solver/spheres.h"
#include "contact_solver/two_spheres_reference.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double core = 2.0 * thesis::radius;
constexpr int phases = 8;
const Body small = thesis::particle(), large{0.8e-3, 1.0 / (4.1 * thesis::mass)};
const double distance = small.radius + large.radius;

using Pair = Spheres<ContactSolver, ContactHistory::with_friction>;

/// An impact with speeds along and across the line of centres, and spins.
struct Impact {
  contact::ContactParameters parameters;
  double speed, angle;
  Vector3 spin_i{20.0, -30.0, 50.0}, spin_j{-10.0, 15.0, 40.0};

  double contact_time() const {
    return contact::normal_contact(parameters, 1.0 / (small.inverse_mass + large.inverse_mass))
        .contact_time();
  }
  Vector3 velocity() const {
    const double across = speed * std::sin(angle);
    return {-speed * std::cos(angle), 0.8 * across, 0.6 * across};
  }
  Pair pair(double dt, double wait) const {
    Pair pair(parameters, {}, dt);
    pair.add(small, {}, {}, spin_i);
    pair.add(large, Vector3{distance, 0.0, 0.0} - wait * velocity(), velocity(), spin_j);
    return pair;
  }
  TwoSpheresReference::State reference() const {
    const TwoSpheresReference reference(parameters, small, large);
    return reference.through_contact({{distance, 0.0, 0.0}, velocity(), spin_i, spin_j},
                                     contact_time() / 4000.0);
  }
};

template <class Any>
void let_part(Any& pair) {
  bool met = norm(pair.contacts[0].last.impulse) > 0.0;
  for (int n = 0; n < 10000 && !(met && pair.are_apart()); n++) {
    pair.step();
    met = met || pair.any_in_range();
  }
  ASSERT_TRUE(met && pair.are_apart());
}

/// Of velocity and of the surfaces' by the spins, over the speed of the impact.
double difference(const Pair& pair, const TwoSpheresReference::State& expected, double speed) {
  const PairMotion now = pair.motion(pair.contacts[0]);
  return std::max({norm(now.velocity - expected.velocity),
                   0.5 * small.radius * norm(now.spin_i - expected.spin_i),
                   0.5 * large.radius * norm(now.spin_j - expected.spin_j)}) /
         speed;
}

contact::ContactParameters elastic(double friction) {
  contact::ContactParameters p = thesis::elastic();
  p.friction = friction;
  return p;
}

}  // namespace

TEST(ContactFriction, ObliqueImpactsTendToThoseOfTheEquationsOfMotion) {
  // Friction changes the speed across by 4/7 of it at the most (stiffness ratio 2/7). It is wrong
  // where sliding begins or ends, K_t u later or earlier by up to a step: dt^2/8 of the slope w^2
  // of the force, w t_c = pi, (4/7) pi^2/16 (dt/t_c)^2. The centrifugal force of touching spheres
  // leaves 1.5 (x/D)^2 at any step.
  for (const double friction : {0.05, 0.3, 5.0})
    for (const double angle : {0.3, 0.8, 1.3}) {
      const Impact impact{elastic(friction), 0.1, angle};
      const TwoSpheresReference::State expected = impact.reference();
      const double overlap = impact.speed * std::cos(angle) * impact.contact_time() / pi / distance;
      const double turning = 1.5 * overlap * overlap;
      double errors[3] = {};
      const double parts[] = {4.0, 10.0, 40.0};
      for (int k = 0; k < 3; k++)
        for (int phase = 0; phase < 2 * phases; phase++) {
          const double dt = impact.contact_time() / parts[k];
          Pair pair = impact.pair(dt, dt * (2.0 + (phase / 2 + 0.37) / phases));
          pair.short_path = phase % 2;
          let_part(pair);
          errors[k] = std::max(errors[k], difference(pair, expected, impact.speed));
        }
      for (int k = 0; k < 3; k++)
        EXPECT_LT(errors[k], 4.0 / 7.0 * pi * pi / 16.0 / (parts[k] * parts[k]) + turning)
            << friction << " " << angle << " " << parts[k];
      // Of second order at least.
      EXPECT_LT(errors[1], errors[0] / 6.25 + turning) << friction << " " << angle;
      EXPECT_LT(errors[2], errors[1] / 16.0 + turning) << friction << " " << angle;
    }
}

TEST(ContactFriction, DampedObliqueImpactsAreThoseOfTheEquationsOfMotion) {
  // As above. In the last eta/K = t_c/94 the dashpot pulls, and friction ends, within a step: the
  // share (pi/94)^2 of its swing in both.
  for (const double friction : {0.05, 0.3, 5.0})
    for (const double angle : {0.3, 0.8, 1.3}) {
      contact::ContactParameters p = thesis::contact();
      p.friction = friction;
      const Impact impact{p, 0.1, angle};
      const TwoSpheresReference::State expected = impact.reference();
      const double ends = pi * p.damping / p.stiffness / impact.contact_time();
      for (const double part : {4.0, 10.0, 40.0})
        for (int phase = 0; phase < phases; phase++) {
          const double dt = impact.contact_time() / part;
          Pair pair = impact.pair(dt, dt * (2.0 + (phase + 0.37) / phases));
          let_part(pair);
          EXPECT_LT(difference(pair, expected, impact.speed),
                    4.0 / 7.0 * (pi * pi / 16.0 / (part * part) + ends * ends))
              << friction << " " << angle << " " << part;
        }
    }
}

TEST(ContactFriction, AnImpactOverAChangeOfStepIsStillOfSecondOrder) {
  // Velocities half a step before and after a time level differ by (dt + dt')/2 times the
  // acceleration a and by (dt'^2 - dt^2)/6 times its derivative, at most w^2 v. Half of each force
  // in the old and in the new step leaves out the latter. The rest as above, of the longer step.
  for (const double friction : {0.05, 0.3}) {
    const Impact impact{elastic(friction), 0.1, 0.8};
    const TwoSpheresReference::State expected = impact.reference();
    for (const double to : {0.5, 0.8, 1.25})
      for (const double part : {8.0, 20.0, 40.0})
        for (int when = 1; when <= static_cast<int>(part) + 5; when++) {
          const double dt = impact.contact_time() / part, longest = std::max(to, 1.0) / part;
          Pair pair = impact.pair(dt, 2.37 * dt);
          pair.short_path = when % 2;
          pair.steps(when);
          pair.change_step(to * dt);
          let_part(pair);
          const double left_out = pi * pi * std::abs(1.0 - to * to) / (6.0 * part * part);
          EXPECT_LT(difference(pair, expected, impact.speed),
                    left_out + 4.0 / 7.0 * pi * pi / 16.0 * longest * longest)
              << friction << " " << to << " " << part << " " << when;
        }
  }
}

TEST(ContactFriction, SlidingImpactsObeyTheHardSphereLaw) {
  // Walton: tangential impulse mu_f times the normal one, which is mu (1 + e) v_n.
  const double angle = 80.0 * pi / 180.0, speed = 0.01, friction = 0.1;
  contact::ContactParameters p = thesis::contact();
  p.friction = friction;
  const double e = contact::normal_contact(p, thesis::reduced_mass).restitution();
  const double across = speed * std::sin(angle), along = speed * std::cos(angle);
  for (const double part : {4.0, 10.0, 50.0})
    for (int phase = 0; phase < phases; phase++) {
      const double dt = thesis::contact_time / part;
      auto pair = meeting<ContactSolver, ContactHistory::with_friction>(
          p, {}, dt, core, along, across, dt * (2.0 + (phase + 0.37) / phases));
      let_part(pair);
      const double normal = thesis::reduced_mass * (1.0 + e) * along;
      // The stiff limit: the normal turns by u_t t_c/D = 1e-3 in contact, the centrifugal term
      // lowers the normal impulse by about u_t/v_n of that. The steps' angles add that of dt.
      const double turned = speed * thesis::contact_time / core;
      const auto& c = pair.contacts[0];
      EXPECT_NEAR(norm(c.normal_impulse) / normal, 1.0, 6.0 * turned);
      // With u_t = 5.7 v_n against mu_f (1 + e) 7/2 = 0.68 it slides all the time but for the
      // start, until K_t s reaches mu_f F: both grow linearly, and s faster.
      const double slid = norm(c.friction);
      EXPECT_NEAR(slid / (friction * normal), 1.0, 8.0 * turned);
      // Both spin up alike, J r/I.
      EXPECT_NEAR(pair.spheres[0].spin.z / (2.5 * slid / (thesis::mass * thesis::radius)), 1.0,
                  8.0 * turned);
      EXPECT_NEAR(pair.spheres[1].spin.z / pair.spheres[0].spin.z, 1.0, 1e-12);
    }
}

TEST(ContactFriction, StickingImpactsReverseTheSurfaceVelocity) {
  // K_t/K = 2/7, no damping, no slip: the tangential spring swings half a period in contact,
  // Walton's tangential restitution is 1: J_t = -2 m_t u_t with m_t = 2 mu/7.
  const double angle = 0.4, speed = 0.01, dt = thesis::contact_time / 200.0;
  auto pair = meeting<ContactSolver, ContactHistory::with_friction>(
      elastic(1e3), {}, dt, core, speed * std::cos(angle), speed * std::sin(angle), 2.37 * dt);
  const double before = pair.kinetic_energy();
  let_part(pair);
  const double expected = 2.0 * (2.0 / 7.0) * thesis::reduced_mass * speed * std::sin(angle);
  // The contact turns by u_t t_c/D = 4e-4. Its ends are resolved to (w dt)^2/2 of the swing.
  const double turned = speed * thesis::contact_time / core;
  const double ends = 0.5 * std::pow(pi / 200.0, 2);
  EXPECT_NEAR(norm(pair.contacts[0].friction) / expected, 1.0, 3.0 * turned + ends);
  EXPECT_NEAR(pair.kinetic_energy() / before, 1.0, 3.0 * turned + ends);
}

TEST(ContactFriction, WhatIsLeftOfAnImpulseActsInThePlaneOfContactThatHasTurned) {
  // Of a contact that ended in the last step half of the impulse is left, whose plane was that of
  // the normal x. The pair has turned by 0.3 about z since, and stands out of range.
  const double dt = thesis::contact_time / 10.0, turned = 0.3, given = 1e-9;
  const ExactContact<ContactSolver> law(elastic(0.3), {}, small, large, dt);
  ContactHistory history;
  history.normal.phase = ContactState::left;
  history.sliding.impulse = {0.0, given, 0.0};
  const Vector3 normal{std::cos(turned), std::sin(turned), 0.0};
  const PairMotion now{1.01 * distance * normal, 0.1 * normal, {}, {}};
  const FrictionalStep step =
      law.advance<ContactHistory::with_friction>(now, {}, false, history, nullptr);
  EXPECT_NEAR(dot(step.friction, normal), 0.0, 8.0 * eps * given);
  EXPECT_NEAR(norm(step.friction), 0.5 * given, 8.0 * eps * given);
  EXPECT_GT(step.friction.y, 0.0);
}

/// Friction does without the force and the external acceleration of the step before the last: a
/// later run without friction must find none of another time.
TEST(ContactFriction, APersistentContactStoresNothingOfTheStepBeforeTheLast) {
  const double dt = thesis::contact_time / 10.0, overlap = 0.01 * small.radius;
  const auto parameters = elastic(0.3);
  const ExactContact<ContactSolver> law(parameters, {}, small, large, dt);
  const PairMotion now{{distance - overlap, 0.0, 0.0}, {}, {}, {}};
  ContactHistory history;
  history.normal.phase = ContactState::persistent;
  history.normal.force = parameters.stiffness * overlap;
  history.normal.force_before = 0.3 * history.normal.force;
  history.normal.external_before = 0.2;
  law.advance<ContactHistory::with_friction>(now, {}, false, history, nullptr);
  EXPECT_TRUE(history.normal.is_persistent());
  EXPECT_EQ(history.normal.force_before, 0.0);
  EXPECT_EQ(history.normal.external_before, 0.0);
}

}  // namespace cohesion::contact_solver
