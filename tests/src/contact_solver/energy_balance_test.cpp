// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/energy_balance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cohesion::contact_solver {
namespace {

constexpr double mass = 2.0, inertia = 0.3, stiffness = 50.0, damping = 0.4, dt = 0.02;
constexpr Vector3 gravity{0.0, 0.0, -1.5};

/// A particle on a linear spring and dashpot to the origin, with weight, another force, a torque of
/// contact and one of other origin; its energies are summed.
struct Particle {
  Vector3 x{0.1, -0.2, 0.3}, v{0.4, 0.1, -0.2}, omega{0.5, -0.1, 0.2};
  EnergySums sums;
  ParticleWork work;
  WorkOfForces dashpot;
  Vector3 force{}, torque{};

  /// The engine's forces at a time level; those of contacts are of the velocity that it has.
  void act(double half, bool starts, bool again) {
    if (again) {
      sums.begin_again();
      work.begin_again();
      dashpot.begin_again();
    } else {
      sums.begin_step();
      work.begin_step();
      dashpot.begin_step();
    }
    const Vector3 spring = -stiffness * x, damped = -damping * v;
    const Vector3 push{0.3, 0.2, 0.1}, of_contact{0.02, 0.0, -0.03}, other_torque{0.01, 0.01, 0.0};
    force = spring + damped + push + mass * gravity;
    torque = of_contact + other_torque;
    const Vector3 kick = (half / mass) * force, turn = (half / inertia) * torque;
    // v and omega are of half a step before the time level, but as a run is set up.
    const bool sets_up = starts || again;
    if (!sets_up) {
      v += kick;
      omega += turn;
    }
    const auto passage = starts  ? Passage::start(v, kick, omega, turn, half)
                         : again ? Passage::second_half(v, kick, omega, turn, half)
                                 : Passage::whole(v, kick, omega, turn, half);
    sums.store(1.0, {0.5 * stiffness * dot(x, x), 0.0, 0.0, 0.0});
    dashpot.add(damped, {}, passage);
    const ForcesAtLevel forces{force, spring + damped, mass * gravity, {}, torque, of_contact};
    work.add_external_work(forces, passage);
    work.friction.add(forces.friction, forces.of_contacts_torque, passage);
    if (!starts) work.store_motion(forces, 1.0 / mass, 1.0 / inertia, half);
  }
  void move(double half) {
    v += (half / mass) * force;
    omega += (half / inertia) * torque;
    x += 2.0 * half * v;
  }
  double balance() const {
    double entries[energy_tally::ENTRIES] = {};
    energy_tally::add_body(entries, mass, inertia, v, omega, mass * gravity, x);
    EnergySums all = sums;
    all.lose({-dashpot.so_far()});
    add_so_far(all, work, 1.0, entries);
    add_stored(all, work, entries);
    return energy_tally::balance(entries);
  }
};

/// The work of a linear force from level to level is exact beside 1/2 m v_(n-1/2) v_(n+1/2), and so
/// is what is stored there. (1e-13: rounding of some hundred steps.)
TEST(EnergyBalance, BalanceOfALinearSpringIsExact) {
  Particle p;
  p.act(0.5 * dt, false, true);
  const double begin = p.balance();
  for (int step = 0; step < 300; step++) {
    p.move(0.5 * dt);
    p.act(0.5 * dt, false, false);
    EXPECT_NEAR(p.balance(), begin, 1e-13 * 300.0);
  }
}

/// A run that goes on makes new forces of the time level: of the dashpot, whose velocity is
/// another. That changes what is stored there by dt^2/(8 m) of the difference of F^2, and nothing
/// later.
TEST(EnergyBalance, RunThatGoesOnBalancesAgain) {
  Particle p;
  p.act(0.5 * dt, false, true);
  for (int step = 0; step < 20; step++) {
    p.move(0.5 * dt);
    p.act(0.5 * dt, false, false);
  }
  const double before = p.balance();
  const Vector3 old = p.force;
  p.act(0.5 * dt, false, true);
  const double after = p.balance();
  const Vector3 of_others = Vector3{0.3, 0.2, 0.1} + mass * gravity;
  EXPECT_NEAR(after - before, -dt * dt / (8.0 * mass) * (dot(p.force, p.force) - dot(old, old)),
              1e-13);
  EXPECT_GT(norm(p.force - old), 1e-4 * norm(of_others));
  for (int step = 0; step < 20; step++) {
    p.move(0.5 * dt);
    p.act(0.5 * dt, false, false);
    EXPECT_NEAR(p.balance(), after, 1e-12);
  }
}

/// The first step of a run with accounts begins from the kinetic energy alone; what other forces
/// and torques do in it is exact. (Without contact.)
TEST(ParticleWork, StartCountsTheWorkOfTheMeanVelocity) {
  ParticleWork work;
  const Vector3 v{0.4, 0.1, -0.2}, push{0.3, 0.2, 0.1};
  const Vector3 kick = (0.5 * dt / mass) * push;
  work.add_external_work({push, {}, {}, {}, {}, {}}, Passage::start(v, kick, {}, {}, 0.5 * dt));
  EXPECT_EQ(work.external.so_far(), 0.0);
  work.begin_step();
  const Vector3 after = v + kick;
  EXPECT_NEAR(work.external.so_far(), 0.5 * mass * (dot(after, after) - dot(v, v)), 1e-16);
}

/// The half step after a time level is part of the work whether or not the step has output.
TEST(ParticleWork, WorkIsIndependentOfOutputSteps) {
  const Vector3 v{0.4, 0.1, -0.2}, kick{0.03, 0.0, 0.01}, spin{0.5, -0.1, 0.2},
      turn{0.0, 0.02, 0.0};
  const Vector3 push{0.3, 0.2, 0.1}, torque{0.01, 0.0, 0.02};
  WorkOfForces with, without;
  with.add(push, torque, Passage::whole(v, kick, spin, turn, 0.5 * dt));
  without.add(push, torque, Passage::without_output(v, spin, 0.5 * dt));
  EXPECT_NE(with.so_far(), without.so_far());
  for (WorkOfForces* const work : {&with, &without}) work->begin_step();
  EXPECT_EQ(with.so_far(), without.so_far());
}

/// The entries of compute gran/energy from the sums of contacts, without work of friction.
TEST(EnergyBalance, EntriesOfContacts) {
  EnergySums sums;
  ContactEnergies energies;
  energies.stored = {1.0, 2.0, 3.0, -4.0, 0.5};
  energies.before = {0.1, 0.2, 0.3};
  energies.exchanged = 0.25;
  sums.store(1.0, energies.stored);
  sums.lose(1.0, energies);
  double entries[energy_tally::ENTRIES] = {};
  add_so_far(sums, {}, 1.0, entries);
  add_stored(sums, {}, entries);
  EXPECT_DOUBLE_EQ(entries[energy_tally::SPRING], 1.0 + 0.5 + 0.25);
  EXPECT_DOUBLE_EQ(entries[energy_tally::TANGENTIAL_SPRING], 2.0);
  EXPECT_DOUBLE_EQ(entries[energy_tally::ROLLING_SPRING], 3.0);
  EXPECT_DOUBLE_EQ(entries[energy_tally::ADHESION], -4.0);
  EXPECT_DOUBLE_EQ(entries[energy_tally::NORMAL_DAMPING], 0.1);
  EXPECT_DOUBLE_EQ(entries[energy_tally::TANGENTIAL_DAMPING], 0.2);
  EXPECT_DOUBLE_EQ(entries[energy_tally::ROLLING], 0.3);
  // All that friction has taken, which is nothing here, less where it went.
  EXPECT_DOUBLE_EQ(entries[energy_tally::FRICTION], -(2.0 + 3.0 + 0.2 + 0.3));
}

}  // namespace
}  // namespace cohesion::contact_solver
