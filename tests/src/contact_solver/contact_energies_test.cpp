// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "constants.h"
#include "contact_solver/exact_contact.h"
#include "contact_solver/liquid_bridge_solver.h"
#include "contact_solver/spheres.h"
#include "contact_solver/square_well_solver.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double core = 2.0 * thesis::radius;
constexpr int phases = 8;

struct Balance {
  double worst;  ///< largest error of the energy at any time level, over that of the impact
  double after;  ///< the same when the pair has parted
  double lost;   ///< over the energy of the impact
};

/// Of an impact, until the pair has parted: kinetic energy of the true motion, what is stored and
/// what was lost, against the kinetic energy before.
template <class Solver, int SIZE>
Balance balance(const contact::ContactParameters& p, const contact::Adhesion& a, double edge,
                double part, double speed, double across) {
  Balance found{};
  for (int phase = 0; phase < phases; phase++) {
    const double dt = thesis::contact_time / part;
    auto pair =
        meeting<Solver, SIZE>(p, a, dt, edge, speed, across, dt * (2.0 + (phase + 0.37) / phases));
    const double before = pair.kinetic_energy();
    bool met = false;
    for (int n = 0; n < 100000 && !(met && pair.are_apart()); n++) {
      pair.step();
      met = met || pair.any_in_range();
      found.worst = std::max(found.worst, std::abs(pair.energy - before) / before);
    }
    EXPECT_TRUE(met && pair.are_apart());
    // What flies away is what is left.
    found.after =
        std::max(found.after, std::abs(pair.kinetic_energy() + pair.lost - before) / before);
    found.worst = std::max(found.worst, found.after);
    found.lost = pair.lost / before;
  }
  return found;
}

/// Rounding of the distance, eps core/2, over a step, against the speed: in each step with a force.
double rounding(double part, double speed, double forces) {
  return 2.0 * (forces + 5.0) * eps * core * part / thesis::contact_time / speed;
}

}  // namespace

TEST(ContactEnergies, OfHeadOnImpactsAreConstantAtEveryTimeLevel) {
  const double e = contact::normal_contact(thesis::contact(), thesis::reduced_mass).restitution();
  for (const double part : {4.0, 8.0, 16.0, 50.0}) {
    const double speed = 0.1, of_core = rounding(part, speed, part);
    const auto plain = balance<ContactSolver, ContactHistory::normal_only>(thesis::contact(), {},
                                                                           core, part, speed, 0.0);
    EXPECT_LT(plain.worst, of_core) << part;
    // Of the kinetic energy of one moving sphere, half is of the relative motion.
    EXPECT_NEAR(plain.lost, 0.5 * (1.0 - e * e), of_core) << part;
    const auto adhesive = balance<ContactSolver, ContactHistory::normal_only>(
        thesis::contact(), thesis::adhesion(7.49e-19), core + thesis::range, part, speed, 0.0);
    EXPECT_LT(adhesive.worst, of_core) << part;
    // Faster in contact by the energy of the well.
    const double well = thesis::adhesion(7.49e-19).well_energy();
    EXPECT_GT(adhesive.lost,
              0.5 * (1.0 - e * e) * (1.0 + 2.0 * well / thesis::reduced_mass / speed / speed));
    const auto in_well = balance<SquareWellSolver, ContactHistory::normal_only>(
        thesis::contact(), {0.0, 1e-5, 5e-11}, core + 1e-5, part, speed, 0.0);
    const double fall = 2.0 * 5e-11 / thesis::reduced_mass;
    EXPECT_LT(in_well.worst, of_core) << part;
    EXPECT_NEAR(in_well.lost, 0.5 * (1.0 - e * e) * (1.0 + fall / speed / speed), of_core) << part;
    // The bridge loses the work of its rupture; in its gap each step has a force.
    const double force = 1e-4, gap = 0.05 * core;
    const auto bridge = balance<LiquidBridgeSolver, ContactHistory::normal_only>(
        thesis::elastic(), {force, gap, 0.0, true}, core, part, 0.5, 0.0);
    EXPECT_LT(bridge.worst, rounding(part, 0.5, 3.0 * part)) << part;
    EXPECT_NEAR(bridge.lost, force * gap / (0.5 * thesis::mass * 0.25),
                rounding(part, 0.5, 3.0 * part))
        << part;
  }
}

TEST(ContactEnergies, OfObliqueImpactsAreConstantToTheTurningOfAStep) {
  // What acts in a step acts along and across a line of centres that turns by u dt/D in it. So it
  // is with the energy that it exchanges: 1 - e^2 of the normal motion, 4/7 of that across. The
  // centrifugal energy is that of touching spheres. Slower impacts turn less.
  const double e = contact::normal_contact(thesis::contact(), thesis::reduced_mass).restitution();
  for (const double speed : {0.14, 0.014})
    for (const double angle : {0.3, 0.8, 1.3}) {
      const double u = speed * std::sin(angle), v = speed * std::cos(angle);
      const double share = u * u / (speed * speed);
      const double overlap = v * thesis::contact_time / pi / core;
      for (const double friction : {0.0, 0.05, 0.3, 5.0})
        for (const double part : {4.0, 8.0, 16.0, 50.0}) {
          contact::ContactParameters p = thesis::contact();
          p.friction = friction;
          const double turned = u * thesis::contact_time / part / core;
          const double exchanged = 1.0 - e * e + (friction > 0.0 ? 4.0 / 7.0 * share : 0.0);
          const Balance found =
              balance<ContactSolver, ContactHistory::with_friction>(p, {}, core, part, v, u);
          EXPECT_LT(found.worst,
                    turned * exchanged + 1.5 * overlap * overlap * share + rounding(part, v, part))
              << speed << " " << angle << " " << friction << " " << part;
          // Each force acts along the normal of its time level, which the account knows: what is
          // left of the balance is of second order in the turning.
          EXPECT_LT(found.after, turned * turned + rounding(part, v, part))
              << speed << " " << angle << " " << friction << " " << part;
          EXPECT_GT(found.lost, 0.0);
        }
    }
}

/// A pair that turns, slides and rolls. (1e-9: rounding of 100 steps, of sums that both paths form
/// in other ways.)
TEST(ContactEnergies, OfPersistentContactsAreThoseOfAnyStep) {
  contact::ContactParameters linear = thesis::contact(), hertz;
  contact::set_hertz(hertz, 5e6, 0.25);
  hertz.restitution = 0.8;
  for (contact::ContactParameters p : {linear, hertz})
    for (const double friction : {0.0, 0.1, 5.0}) {
      p.friction = friction;
      p.rolling_friction = 0.2 * friction;
      const auto start = [&] {
        return meeting<ContactSolver, ContactHistory::with_rolling>(
            p, {}, thesis::contact_time / 50.0, core, 0.1, 0.1, 0.0);
      };
      auto pair = start(), other = start();
      other.short_path = false;
      const double before = pair.kinetic_energy();
      for (int n = 0; n < 100; n++) {
        pair.step();
        other.step();
        EXPECT_NEAR(pair.energy, other.energy, 1e-9 * before) << n;
        EXPECT_NEAR(pair.lost, other.lost, 1e-9 * before) << n;
        EXPECT_NEAR(pair.damped, other.damped, 1e-9 * before) << n;
        EXPECT_NEAR(pair.exchanged, other.exchanged, 1e-9 * before) << n;
      }
      EXPECT_GT(pair.lost, 0.01 * before);
    }
}

TEST(ContactEnergies, AnImpactUnderWeightIsBalancedToTheLoadOfAStep) {
  // A sphere that bounces on a plane, rough, while it also slides along: weight, spring, friction,
  // to rest. The weight acts for a step on what moves otherwise then: g dt over the speed.
  contact::ContactParameters p = thesis::contact();
  p.friction = 0.3;
  const double height = 2e-5, gravity = 9.81;
  for (const double part : {4.0, 10.0, 50.0}) {
    const double dt = thesis::contact_time / part;
    Spheres<ContactSolver, ContactHistory::with_friction> sphere(p, {}, dt);
    sphere.add(thesis::particle(), {0.0, 0.0, thesis::radius + height}, {0.05, 0.0, 0.0});
    sphere.add_wall({{}, {0.0, 0.0, 1.0}, {}});
    sphere.gravity = {0.0, 0.0, -gravity};
    sphere.step();
    const double before = sphere.energy, fall = thesis::mass * gravity * height;
    double worst = 0.0;
    for (int n = 0; n < 400.0 * part; n++) {
      sphere.step();
      worst = std::max(worst, std::abs(sphere.energy - before));
    }
    EXPECT_LT(worst, gravity * dt / std::sqrt(2.0 * gravity * height) *
                         (fall + 0.5 * thesis::mass * 0.05 * 0.05))
        << part;
    EXPECT_GT(sphere.lost, 0.5 * fall);
  }
}

TEST(ContactEnergies, OfASphereThatALoadPressesToRestAreConstantToTheRounding) {
  // The load presses by F/K', its work is as much more than that of the spring. It begins when the
  // sphere does, which the contact sees a step later: the first step is not counted.
  for (const double hamaker : {0.0, 7.49e-19})
    for (const double part : {5.0, 10.0, 50.0}) {
      contact::ContactParameters p = thesis::contact();
      p.damping = -1.0;
      p.restitution = 0.5;
      const double dt = thesis::contact_time / part, gravity = 1000.0;
      Spheres<ContactSolver, ContactHistory::normal_only> sphere(p, thesis::adhesion(hamaker), dt);
      sphere.add(thesis::particle(), {0.0, 0.0, thesis::radius - 1e-7}, {});
      sphere.add_wall({{}, {0.0, 0.0, 1.0}, {}});
      sphere.gravity = {0.0, 0.0, -gravity};
      for (int n = 0; n < 3; n++) sphere.step();
      const double before = sphere.energy;
      double worst = 0.0;
      for (int n = 0; n < 40.0 * part; n++) {
        sphere.step();
        worst = std::max(worst, std::abs(sphere.energy - before));
      }
      const double fallen = 1.0 * gravity * thesis::mass * thesis::mass * gravity / 800.0;
      EXPECT_LT(std::abs(sphere.spheres[0].v.z), 1e-9) << part;
      EXPECT_GT(sphere.lost, 0.3 * fallen) << part;
      EXPECT_LT(worst, 1e-9 * fallen) << part;
    }
}

TEST(ContactEnergies, OfAPairFirstSeenAfterItTouchedInTheLastStepAreThoseOfOneThatFlewThere) {
  const ContactSolver solver(contact::normal_contact(thesis::contact(), thesis::reduced_mass),
                             thesis::adhesion(7.49e-19), core, thesis::contact_time / 4.0);
  const StaggeredMotion at{core - 1e-7, -0.1, 0.0};
  const auto stored = [&](ContactState::Phase phase) {
    const ContactState before{phase};
    ContactState after = before;
    const ContactStep step = solver.advance(at, 0.0, solver.step(), after);
    EXPECT_GT(step.force, 0.0);
    ContactEnergies energies;
    set_normal_stored(solver, {at, 0.0, false, before, after, step.force, step.dissipated}, core,
                      energies);
    return energies.stored;
  };
  const StoredEnergies seen = stored(ContactState::outside), unseen = stored(ContactState::unknown);
  EXPECT_EQ(unseen.spring, seen.spring);
  EXPECT_EQ(unseen.adhesion, seen.adhesion);
  EXPECT_EQ(unseen.load, seen.load);
}

}  // namespace cohesion::contact_solver
