// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/energy_account.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact_solver/contact_solver.h"
#include "contact_solver/pair_in_plane.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The largest work of a pair's forces on an encounter without other forces, of eight positions in
/// the step, over its kinetic energy at the start.
double largest_work(const ContactSolver& contact, double sideways) {
  const double dt = contact.step(), speed = 0.05,
               energy = 0.5 * (speed * speed + sideways * sideways);
  double largest = 0.0;
  for (int phase = 0; phase < 8; phase++) {
    const double flight = dt * (2.0 + phase / 8.0);
    double x = core + contact.range() + speed * flight, y = -sideways * flight;
    double vx = -speed, vy = sideways, ax = 0.0, ay = 0.0, work = 0.0;
    ContactState state;
    bool touched = false, over = false;
    for (int n = 0; !over && n < 40.0 * thesis::contact_time / dt; n++) {
      x += dt * vx;
      y += dt * vy;
      const double r = std::hypot(x, y), nx = x / r, ny = y / r;
      const StaggeredMotion at{r, vx * nx + vy * ny, std::abs(vy * nx - vx * ny)};
      const double a = contact.advance(at, 0.0, dt, state).force / thesis::reduced_mass;
      work += 0.5 * dt * ((ax + a * nx) * vx + (ay + a * ny) * vy);
      ax = a * nx;
      ay = a * ny;
      vx += dt * ax;
      vy += dt * ay;
      touched = touched || state.in_range();
      over = touched && state.phase == ContactState::outside && a == 0.0;
    }
    EXPECT_TRUE(over);
    largest = std::max(largest, std::abs(work) / energy);
  }
  return largest;
}

/// Three equal spheres in a line: the first hits the second, which hits the third while it still
/// touches the first. A contact knows of the other what it did a step before.
struct Chain {
  ContactSolver contact;
  double x[3], v[3];
  double a[3] = {};
  ContactState state[2] = {};

  Chain(const ContactSolver& law, double speed, double gap, double phase)
      : contact(law), v{speed, 0.0, 0.0} {
    const double flown = speed * law.step() * (2.0 + phase);
    x[0] = 0.0;
    x[1] = core + law.range() + flown;
    x[2] = x[1] + core + law.range() + gap;
  }
  double energy() const { return 0.5 * thesis::mass * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }
  bool is_over() const {
    return a[0] == 0.0 && a[1] == 0.0 && a[2] == 0.0 && state[0].phase == ContactState::outside &&
           state[1].phase == ContactState::outside && v[0] <= v[1] && v[1] <= v[2];
  }
  void step() {
    const double dt = contact.step();
    double now[3] = {};
    for (int k = 0; k < 3; k++) x[k] += dt * v[k];
    for (int k = 0; k < 2; k++) {
      const StaggeredMotion at{x[k + 1] - x[k], v[k + 1] - v[k], 0.0};
      const double external = contact.external(a[k + 1] - a[k], at, state[k]);
      const double force = contact.advance(at, external, dt, state[k]).force;
      now[k] -= force / thesis::mass;
      now[k + 1] += force / thesis::mass;
    }
    for (int k = 0; k < 3; k++) {
      a[k] = now[k];
      v[k] += dt * a[k];
    }
  }
  /// The energy when all have parted, over that at the start.
  double left() {
    const double before = energy();
    step();
    for (int n = 0; n < 200.0 * thesis::contact_time / contact.step() && !is_over(); n++) step();
    EXPECT_TRUE(is_over());
    return energy() / before;
  }
};

}  // namespace

TEST(EnergyAccount, ElasticPairsGiveBackWhatTheyTook) {
  for (const double hamaker : {0.0, 2e-18}) {
    const auto adhesion = hamaker > 0.0 ? thesis::adhesion(hamaker) : contact::Adhesion{};
    for (const double part : {4.0, 10.0, 20.0, 50.0})
      for (const double sideways : {0.0, 0.05}) {
        const ContactSolver contact(spring(0.0), adhesion, core, thesis::contact_time / part);
        // Rounding of the distance, felt in the velocity over a step; what it turns by in a step,
        // squared.
        const double dt = contact.step(), turns = dt * sideways / core;
        const double alone = 8.0 * (part + 5.0) * eps * core / dt / 0.05 + turns * turns;
        EXPECT_LT(largest_work(contact, sideways), alone) << hamaker << " " << part;
      }
  }
}

TEST(EnergyAccount, ElasticChainsKeepTheirEnergyAtAnyStep) {
  const double speed = 0.05;
  for (const double hamaker : {0.0, 1e-19}) {
    const auto adhesion = hamaker > 0.0 ? thesis::adhesion(hamaker) : contact::Adhesion{};
    for (const double part : {4.0, 10.0, 20.0, 50.0})
      for (const double gap : {0.0, 1e-7, 2e-7})
        for (int phase = 0; phase < 8; phase++) {
          const ContactSolver contact(spring(0.0), adhesion, core, thesis::contact_time / part);
          // Each contact closes its account, up to 1e-9 of its energy and rounding as above.
          const double rounding = 8.0 * (part + 5.0) * eps * core / contact.step() / speed;
          EXPECT_NEAR(Chain(contact, speed, gap, phase / 8.0).left(), 1.0, 1e-8 + rounding)
              << hamaker << " " << part << " " << gap << " " << phase;
        }
  }
}

// mu = 2 and dt = 0.5 below. Tolerances: some ten roundings of terms of the size of mu v^2.
TEST(EnergyAccount, SettlingChangesTheKineticEnergyByTheAccount) {
  const EnergyAccount account(2.0, 0.5);
  const double load = 0.8, speed = 3.0 + 0.25 * load;
  for (const double r : {-4.0, 0.0, 4.0}) {
    double force = 0.3;
    EXPECT_TRUE(account.settle({1.0, 3.0, 0.0}, load, r, force));
    const double settled = speed + 0.5 * force / 2.0;
    EXPECT_NEAR(speed * speed - settled * settled, r, 20.0 * eps * speed * speed);
  }
}

TEST(EnergyAccount, SettlingKeepsHalfTheSpeedThatTheForceWouldLeave) {
  const EnergyAccount account(2.0, 0.5);
  const double speed = 3.0, force = -4.0, half = 0.5 * (speed + 0.5 * force / 2.0);
  const double most = speed * speed - half * half;  // energy above that of half the speed
  for (const double part : {0.999, 1.001, 10.0}) {
    double settled = force;
    EXPECT_EQ(account.settle({1.0, speed, 0.0}, 0.0, part * most, settled), part < 1.0);
    if (part > 1.0) {
      EXPECT_NEAR(speed + 0.5 * settled / 2.0, half, 10.0 * eps * speed);
    }
  }
}

TEST(EnergyAccount, SettlingStopsAPairThatTheForceWouldTurnBack) {
  const EnergyAccount account(2.0, 0.5);
  for (const double part : {0.999, 1.001}) {
    double force = -20.0;
    EXPECT_EQ(account.settle({1.0, 3.0, 0.0}, 0.0, part * 9.0, force), part < 1.0);
    if (part > 1.0) {
      EXPECT_NEAR(3.0 + 0.5 * force / 2.0, 0.0, 30.0 * eps);
    }
  }
}

TEST(EnergyAccount, APairThatComesBackKeepsItsForce) {
  const EnergyAccount account(2.0, 0.5);
  for (const double rate : {-3.0, -0.2, 0.0}) {  // half a step under the load turns none of them
    double force = 0.3;
    EXPECT_FALSE(account.settle({1.0, rate, 0.0}, rate < 0.0 ? 0.4 : 0.0, 1.0, force));
    EXPECT_EQ(force, 0.3);
  }
}

// Open: R above 1e-9 mu v^2, or a force that changes the momentum by more than 1e-9 of it in a
// step. Rounding of the distance adds 4 eps/(dt v) = 6e-16 to the 1e-9.
TEST(EnergyAccount, IsOpenAboveABillionthOfTheMotion) {
  const EnergyAccount account(2.0, 0.5);
  const double rate = 3.0, least = 1e-9 * 2.0 * rate;
  for (const double sign : {-1.0, 1.0})
    for (const double part : {0.999, 1.001}) {
      const StaggeredMotion now{1.0, sign * rate, 0.0};
      EXPECT_EQ(account.is_open(now, sign * part * least * rate, ContactState{}), part > 1.0);
      ContactState pushed, before;
      pushed.force = sign * part * least / 0.5;
      before.force_before = pushed.force;
      EXPECT_EQ(account.is_open(now, 0.0, pushed), part > 1.0);
      EXPECT_EQ(account.is_open(now, 0.0, before), part > 1.0);
    }
}

TEST(EnergyAccount, IsClosedWithinTheRoundingOfTheDistance) {
  const EnergyAccount account(2.0, 0.5);
  const double distance = 7.0, least = 2.0 * 4.0 * eps * distance / 0.5;
  for (const double part : {0.999, 1.001}) {
    ContactState state;
    state.force = part * least / 0.5;
    EXPECT_EQ(account.is_open({distance, 0.0, 0.0}, 0.0, state), part > 1.0);
  }
}

}  // namespace cohesion::contact_solver
