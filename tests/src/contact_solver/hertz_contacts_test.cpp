// SPDX-License-Identifier: BSD-3-Clause
// Several contacts, weight and friction with Hertz's law.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "contact_solver/exact_contact.h"
#include "contact_solver/pair_in_plane.h"
#include "contact_solver/spheres.h"

namespace cohesion::contact_solver {
namespace {

using Frictionless = Spheres<ContactSolver, ContactHistory::normal_only>;
using Frictional = Spheres<ContactSolver, ContactHistory::with_friction>;

const Body ball = thesis::particle();

contact::ContactParameters hertz(double restitution, double friction = 0.0) {
  contact::ContactParameters p;
  contact::set_hertz(p, 5e6, 0.25);
  p.restitution = restitution;
  p.friction = friction;
  return p;
}
/// Of two of these balls, or of one and a plane, that meet at this speed [length/time].
double contact_time(double speed, bool plane = false) {
  const double mass = plane ? thesis::mass : thesis::reduced_mass;
  const double radius = plane ? thesis::radius : 0.5 * thesis::radius;
  const auto law =
      contact::HertzSpringDashpot::from_restitution(hertz(1.0).modulus, radius, 1.0, mass);
  return law.contact_time(speed);
}

}  // namespace

TEST(HertzContacts, AnElasticBallKeepsItsHeight) {
  const double height = 1e-3, g = 9.81, speed = std::sqrt(2.0 * g * height);
  for (const double part : {10.0, 20.0}) {
    Frictionless box(hertz(1.0), {}, contact_time(speed, true) / part);
    box.add(ball, {0.0, 0.0, thesis::radius + height}, {});
    box.add_wall({{}, {0.0, 0.0, 1.0}, {}});
    box.gravity = {0.0, 0.0, -g};
    box.recorded = false;
    double highest = 0.0;
    const int steps = static_cast<int>(1000.0 * 2.0 * std::sqrt(2.0 * height / g) / box.dt());
    for (int n = 0; n < steps; n++) {
      box.step();
      if (n > steps * 0.99) highest = std::max(highest, box.spheres[0].x.z - thesis::radius);
    }
    // Between two time levels it is up to g dt^2/8 higher.
    EXPECT_NEAR(highest, height, 1e-6 * height + 0.125 * g * box.dt() * box.dt()) << part;
  }
}

TEST(HertzContacts, ABallAtRestIsPressedInByItsWeight) {
  const double g = 9.81;
  Frictionless box(hertz(0.5), {}, contact_time(0.01, true) / 20.0);
  box.add(ball, {0.0, 0.0, thesis::radius}, {});
  box.add_wall({{}, {0.0, 0.0, 1.0}, {}});
  box.gravity = {0.0, 0.0, -g};
  box.recorded = false;
  box.steps(20000);
  const double k = 4.0 / 3.0 * hertz(1.0).modulus * std::sqrt(thesis::radius);
  const double overlap = std::pow(thesis::mass * g / k, 2.0 / 3.0);
  EXPECT_NEAR(thesis::radius - box.spheres[0].x.z, overlap, 1e-9 * overlap);
}

namespace {

/// The energy that is left after an elastic impact that sticks, over that before, by the angle to
/// the line of centres.
double left_after_sticking(double degrees, double part, double phase) {
  const double speed = 0.1, dt = contact_time(speed) / part, angle = degrees * pi / 180.0;
  contact::ContactParameters p = hertz(1.0, 1e6);
  p.tangential_damping_ratio = 0.0;
  Frictional pair(p, {}, dt);
  const Vector3 v{-speed * std::cos(angle), speed * std::sin(angle), 0.0};
  pair.add(ball, {}, {});
  pair.add(ball, Vector3{2.0 * thesis::radius, 0.0, 0.0} - (1.0 + phase) * dt * v, v);
  pair.recorded = false;
  pair.steps(static_cast<int>(6.0 * part));
  double after = 0.0;
  for (const auto& s : pair.spheres)
    after += dot(s.v, s.v) + 0.4 * thesis::radius * thesis::radius * dot(s.spin, s.spin);
  return after / dot(v, v);
}

}  // namespace

TEST(HertzContacts, ATangentialSpringThatStiffensGivesNoEnergy) {
  // What it stores is lost where it stiffens under its force, and where the contact ends. That is
  // the law's, whatever the step. The swing of the spring, w_t t_c < 7, is late by (w_t dt)^2/24 of
  // its phase: by 4/7 of that the energy of the surfaces, half of which is lost at most.
  for (const double angle : {5.0, 20.0, 45.0, 70.0, 85.0}) {
    const double converged = left_after_sticking(angle, 400.0, 0.3);
    EXPECT_GT(converged, 0.88) << angle;
    for (const double part : {10.0, 20.0})
      for (int phase = 0; phase < 8; phase++) {
        const double left = left_after_sticking(angle, part, phase / 8.0);
        EXPECT_LE(left, 1.0) << angle << " " << part;
        EXPECT_NEAR(left, converged, 4.0 / (part * part)) << angle << " " << part << " " << phase;
      }
  }
}

TEST(HertzContacts, AnAdhesiveContactIsPersistentUnderAnyLoad) {
  // An elastic impact under twice F_ad. IntegratedContact::lasts() excludes time levels whose
  // overlap, there or one step later, is below the displacement in a step: one level after touch
  // and two before parting. One more is for the change of the speed in these steps.
  constexpr int excluded = 4;
  // The energy account holds the work of the forces, so the error of the Runge-Kutta scheme does
  // not enter. EnergyAccount::is_open() counts it as closed below this part of mu v^2. The pair
  // leaves no faster than it came; round-off, 4 eps D/(v dt), is below 1e-12.
  constexpr double negligible = 1e-9;
  const double speed = 0.1, pull = 2e-4;
  const contact::Adhesion adhesion{pull, thesis::range, pull * thesis::range};
  const auto law = contact::HertzSpringDashpot::from_restitution(
      hertz(1.0).modulus, 0.5 * thesis::radius, 1.0, thesis::reduced_mass);
  for (const double part : {10.0, 20.0})
    for (int phase = 0; phase < phases; phase++) {
      const ContactSolver solver(law, adhesion, core, contact_time(speed) / part);
      PairInPlane pair(solver, core, speed, 0.0, phase);
      pair.external = 2.0 * pull / thesis::reduced_mass;
      const auto energy = [&] {
        const double last = pair.vx, x = pair.x + solver.step() * last;
        pair.step();
        return 0.5 * last * pair.vx - pair.external * x;
      };
      const double before = energy();
      int touching = 0, persistent = 0;
      for (int n = 0; n < 3.0 * part; n++) {
        pair.step();
        touching += pair.distance() < core;
        persistent += pair.state.is_persistent();
      }
      EXPECT_GE(persistent, touching - excluded) << part << " " << phase;
      EXPECT_GE(touching, excluded + 1) << part << " " << phase;
      EXPECT_EQ(pair.state.phase, ContactState::outside);
      EXPECT_NEAR(energy(), before, negligible * speed * speed) << part << " " << phase;
    }
}

TEST(HertzContacts, TheEnergyOfAFrictionalColumnCloses) {
  // To the third order of the step, as of linear springs (energy_account.h).
  for (const double part : {10.0, 20.0}) {
    Frictional box(hertz(0.8, 0.3), {}, contact_time(0.1) / part);
    for (int k = 0; k < 5; k++)
      box.add(ball, {0.1e-3 * (k % 2), 0.05e-3 * (k % 3), (1.0 + 2.2 * k) * thesis::radius + 1e-5},
              {0.01 * k, 0.0, -0.05});
    box.add_wall({{}, {0.0, 0.0, 1.0}, {}});
    box.gravity = {0.0, 0.0, -9.81};
    box.step();
    const double start = box.energy;
    double worst = 0.0;
    for (int n = 0; n < 200.0 * part; n++) {
      box.step();
      worst = std::max(worst, std::abs(box.energy - start));
    }
    EXPECT_LT(worst, 1e-4 * start) << part;
  }
}

}  // namespace cohesion::contact_solver
