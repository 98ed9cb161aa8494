// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/exact_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "constants.h"
#include "contact/adhesive_contact.h"
#include "contact_solver/spheres.h"
#include "contact_solver/square_well_solver.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double core = 2.0 * thesis::radius;
constexpr int phases = 8;  // positions of an event within its step
const Body large{0.8e-3, 1.0 / (4.1 * thesis::mass)};

contact::ContactParameters rough() {
  contact::ContactParameters p = thesis::contact();
  p.friction = 0.3;
  p.rolling_friction = 0.05;
  return p;
}

/// Until all contacts are over; false: not within `time`.
template <class Pair>
bool part_within(Pair& pair, double time) {
  bool met = false;
  for (int n = 0; n < time / pair.dt(); n++) {
    pair.step();
    met = met || pair.any_in_range();
    if (met && pair.are_apart()) return true;
  }
  return false;
}

/// The rate at which a pair parts, along its line of centres.
template <class Pair>
double parting(const Pair& pair) {
  const PairMotion now = pair.motion(pair.contacts[0]);
  return dot(now.separation, now.velocity) / norm(now.separation);
}

}  // namespace

TEST(ExactContact, RestitutionIsExactForAnyStepAndPhaseByEitherPath) {
  const double speed = 0.02;
  for (const bool short_path : {false, true})
    for (const double part : {4.0, 8.0, 50.0})
      for (int phase = 0; phase < phases; phase++) {
        const double dt = thesis::contact_time / part, wait = dt * (2.0 + (phase + 0.37) / phases);
        auto pair = meeting<ContactSolver, ContactHistory::normal_only>(thesis::contact(), {}, dt,
                                                                        core, speed, 0.0, wait);
        pair.short_path = short_path;
        ASSERT_TRUE(part_within(pair, 5.0 * thesis::contact_time));
        const double e =
            contact::normal_contact(thesis::contact(), thesis::reduced_mass).restitution();
        // The distance is rounded by eps core/2 in some part + 5 steps, each felt in the velocity
        // over dt at the most.
        EXPECT_NEAR(parting(pair), e * speed, (part + 5.0) * eps * core / dt) << part << phase;
      }
}

TEST(ExactContact, KeepsMomentumAndAngularMomentum) {
  // Spheres of two sizes that fly together, turning, and stick or part, also where i and j change
  // places in each step.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto any = [&](double size) {
    return Vector3{size * uniform(random), size * uniform(random), size * uniform(random)};
  };
  int met = 0;
  for (int n = 0; n < 24; n++) {
    contact::ContactParameters p = rough();
    if (n % 3 == 0) p.damping = 0.0;
    const double dt = thesis::contact_time / (4.0 + n);
    Spheres<ContactSolver, ContactHistory::with_rolling> some(
        p, thesis::adhesion(n % 2 ? 2e-18 : 2e-16), dt);
    some.short_path = n % 4 < 2;
    some.exchanges = n % 8 < 4;
    const double size = 0.8e-3 + 0.5e-3;
    for (int k = 0; k < 4; k++) {
      const Vector3 place =
          size * Vector3{k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
      some.add(k % 2 ? large : thesis::particle(), place + any(1e-5),
               any(0.05) - (0.1 / size) * place, any(200.0));
    }
    some.step();
    const Vector3 momentum = some.momentum(), turning = some.angular_momentum();
    const int steps = 200;
    bool any_met = false;
    for (int k = 1; k < steps; k++) {
      some.step();
      any_met = any_met || some.any_in_range();
    }
    met += any_met;
    // A few roundings of the largest momentum, also at the distance that flight leads to, in each
    // step and contact.
    const double most = 4.1 * thesis::mass * 0.3;
    EXPECT_LT(norm(some.momentum() - momentum), 16 * eps * steps * 6.0 * most) << n;
    EXPECT_LT(norm(some.angular_momentum() - turning),
              16 * eps * steps * 6.0 * most * (2e-3 + 0.3 * steps * dt))
        << n;
  }
  EXPECT_GT(met, 20);
}

TEST(ExactContact, EscapesFromAWellAtTheVelocityOfTheClosedFormAtAnyAngle) {
  // With the speed u across at the edge R, the conserved angular momentum leaves of the normal
  // speed at the contact c: v_c^2 = v^2 + 2 D/mu - u^2 (R^2/c^2 - 1), of which e v_c is left. So
  //
  //   v_esc^2 = (1/e^2 - 1) (2 D/mu - u^2 (R^2/c^2 - 1))
  //
  // but for the centrifugal load in the contact, u^2/c over w0 v_c: 1e-3 at the most here, of
  // which the dashpot feels its share, 1 - e = 0.05.
  const double depth = 5e-11, gained = 2.0 * depth / thesis::reduced_mass;
  const double e = contact::normal_contact(thesis::contact(), thesis::reduced_mass).restitution();
  const double share = 1.0 / (e * e) - 1.0;
  for (const double ratio : {1.001, 1.01})
    for (const double degrees : {0.0, 45.0, 70.0}) {
      const double slope = std::tan(degrees * pi / 180.0);
      const double turning = slope * slope * (ratio * ratio - 1.0);
      const double escape = std::sqrt(share * gained / (1.0 + share * turning));
      for (const double part : {4.0, 10.0, 50.0})
        for (int phase = 0; phase < phases; phase++)
          for (const double factor : {0.999, 1.001}) {
            const double dt = thesis::contact_time / part, v = factor * escape;
            auto pair = meeting<SquareWellSolver, ContactHistory::normal_only>(
                thesis::contact(), {0.0, (ratio - 1.0) * core, depth}, dt, ratio * core, v,
                slope * v, dt * (2.0 + (phase + 0.37) / phases));
            pair.recorded = false;
            const double time = 3.0 * (ratio - 1.0) * core / escape + 8.0 * thesis::contact_time;
            EXPECT_EQ(part_within(pair, time), factor > 1.0)
                << ratio << " " << degrees << " " << part << " " << phase;
          }
    }
}

TEST(ExactContact, EscapesFromAdhesionAtTheVelocityOfTheClosedFormAtAnyAngle) {
  // The centrifugal force L = mu u^2/c pays on the way out for U - B, of the barrier
  // B = F_ad H_cut (1 - sqrt(L/F_ad))^2 of the tail, which is without an end here: v_esc^2 is that
  // of a tail B less 2 (U - B)/mu. In contact it is felt as above.
  const auto law = contact::normal_contact(thesis::contact(), thesis::reduced_mass);
  for (const double hamaker : {1e-19, 7.49e-19})
    for (const double degrees : {0.0, 30.0, 60.0}) {
      const contact::Adhesion a = thesis::adhesion(hamaker);
      const double slope = std::tan(degrees * pi / 180.0);
      double escape = contact::AdhesiveContact(law, a).escape_velocity();
      for (int k = 0; k < 60; k++) {  // u depends on v
        const double load = thesis::reduced_mass * slope * slope * escape * escape / core;
        const double left = 1.0 - std::sqrt(load / a.force);
        contact::Adhesion lowered = a;
        lowered.tail_energy *= left * left;
        const double v = contact::AdhesiveContact(law, lowered).escape_velocity();
        const double paid = 2.0 * (a.tail_energy - lowered.tail_energy) / thesis::reduced_mass;
        escape = 0.5 * (escape + std::sqrt(v * v - paid));
      }
      for (const double part : {4.0, 10.0, 50.0})
        for (int phase = 0; phase < phases; phase++)
          for (const double factor : {0.999, 1.001}) {
            const double dt = thesis::contact_time / part, v = factor * escape;
            auto pair = meeting<ContactSolver, ContactHistory::normal_only>(
                thesis::contact(), a, dt, core + a.cutoff, v, slope * v,
                dt * (2.0 + (phase + 0.37) / phases));
            pair.recorded = false;
            EXPECT_EQ(part_within(pair, 30.0 * thesis::contact_time), factor > 1.0)
                << hamaker << " " << degrees << " " << part << " " << phase;
          }
    }
}

TEST(ExactContact, ExchangeOfTheParticlesChangesNothing) {
  for (const bool short_path : {false, true})
    for (const double part : {4.0, 10.0})
      for (const double hamaker : {7.49e-19, 2e-16}) {  // parts, sticks
        const double dt = thesis::contact_time / part;
        const auto run = [&](bool exchanges) {
          Spheres<ContactSolver, ContactHistory::with_rolling> pair(rough(),
                                                                    thesis::adhesion(hamaker), dt);
          pair.short_path = short_path;
          pair.exchanges = exchanges;
          pair.add(thesis::particle(), {}, {0.05, 0.01, 0.0}, {30.0, -200.0, 100.0});
          pair.add(large, {1.3001e-3, 0.0, 0.0}, {-0.05, 0.03, -0.02}, {100.0, 150.0, -200.0});
          pair.steps(static_cast<int>(5.0 * part) + 20);
          return pair;
        };
        const auto one = run(false), other = run(true);
        ASSERT_NE(norm(one.contacts[0].friction), 0.0);
        EXPECT_EQ(one.contacts[0].history.normal.in_range(), hamaker > 1e-18);
        for (const int k : {0, 1}) {
          // Rounding of the distance over a step, in each step, which contacts do not amplify, and
          // that of velocities.
          const double few = 20.0 * (5.0 * part + 20.0) * eps;
          const double of_speed = few * (core / dt + 0.1);
          EXPECT_LT(norm(one.spheres[k].v - other.spheres[k].v), of_speed);
          EXPECT_LT(norm(one.spheres[k].spin - other.spheres[k].spin),
                    2.5 * of_speed / thesis::radius);
        }
      }
}

}  // namespace cohesion::contact_solver
