// SPDX-License-Identifier: BSD-3-Clause
#include "powder/grain_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hamaker/law.h"
#include "hamaker/small_gap.h"

namespace cohesion::powder {

namespace {

constexpr double d = 5e-4, speed = 0.3;
const Elastic glass{63e9, 0.22};
const double mass = 2500.0 * sphere_volume(0.5 * d);

/// Duration and largest overlap of Hertz's impact, by Runge and Kutta in steps of `dt`.
struct Impact {
  double time = 0.0, overlap = 0.0;
};
Impact integrated(double dt) {
  const double c =
      4.0 / 3.0 * glass.young / (2.0 * (1.0 - glass.poisson * glass.poisson)) * std::sqrt(0.25 * d);
  const auto acceleration = [&](double x) {
    return -c * std::pow(std::max(x, 0.0), 1.5) * 2.0 / mass;
  };
  double x = 0.0, v = speed;
  Impact impact;
  while (true) {
    const double a1 = acceleration(x), x2 = x + 0.5 * dt * v;
    const double v2 = v + 0.5 * dt * a1, a2 = acceleration(x2), x3 = x + 0.5 * dt * v2;
    const double v3 = v + 0.5 * dt * a2, a3 = acceleration(x3), x4 = x + dt * v3;
    const double v4 = v + dt * a3, a4 = acceleration(x4);
    const double next = x + dt / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
    v += dt / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    if (next < 0.0) {
      impact.time += dt * x / (x - next);
      return impact;
    }
    x = next;
    impact.time += dt;
    impact.overlap = std::max(impact.overlap, x);
  }
}

}  // namespace

// 2.9432 has five digits; of 20,000 steps the largest overlap is known to the square of one.
TEST(GrainContact, HertzIsAsAnIntegrationOfTheMotion) {
  const double time = hertz_contact_time(glass, d, mass, speed);
  const Impact impact = integrated(time / 20000.0);
  EXPECT_NEAR(time / impact.time, 1.0, 1e-4);
  const double stiffness = linear_stiffness(glass, d, mass, speed);
  EXPECT_NEAR(0.5 * mass * speed * speed / (stiffness * impact.overlap * impact.overlap), 1.0,
              1e-6);
}

// t = 2.868 (m*^2/(R* E*^2 v))^(1/5), as it is often quoted, with four digits.
TEST(GrainContact, HertzIsAsQuoted) {
  const double modulus = glass.young / (2.0 * (1.0 - glass.poisson * glass.poisson));
  const double quoted =
      2.868 * std::pow(0.25 * mass * mass / (0.25 * d * modulus * modulus * speed), 0.2);
  EXPECT_NEAR(hertz_contact_time(glass, d, mass, speed) / quoted, 1.0, 5e-4);
}

TEST(GrainContact, SurfaceEnergyPullsAsByDerjaguin) {
  const double gamma = 0.03, cutoff = 4e-10;
  const double a = hamaker_of_surface_energy(gamma, cutoff);
  const hamaker::HamakerLaw<hamaker::SmallGap> law({a, cutoff, 1e-7});
  const double force = 4.0 * pi * gamma * 0.25 * d;
  EXPECT_NEAR(law.adhesion_force(two_spheres(0.5 * d, 0.5 * d)), force, 1e-14 * force);
}

TEST(GrainContact, TheSoftestSpringBearsImpactsAdhesionAndBed) {
  const double pull_off = 2e-6, pressure = 4e3, overlap = 0.01;
  const Pressed pair{d, 0.5 * mass};
  const auto softest = [&](double v, double force, double p) {
    const auto adhesion = [&](double) { return contact::Adhesion{force, 0.0, 0.0}; };
    return softest_stiffness(pair, 0.8, adhesion, {v, p}, overlap);
  };
  const auto spring =
      contact::LinearSpringDashpot::from_restitution(softest(speed, 0.0, 0.0), 0.8, 0.5 * mass);
  EXPECT_NEAR(spring.maximum_overlap(speed), overlap * d, 1e-12 * d);
  EXPECT_NEAR(softest(1e-9, 0.0, pressure), pressure * d / overlap, 1e-9);
  // A pair that comes to rest under F alone presses the spring to F/K, and on the way to up to
  // twice that; without loss it would be twice.
  const double held = softest(1e-9, pull_off, 0.0) / (pull_off / (overlap * d));
  EXPECT_GT(held, 1.0);
  EXPECT_LT(held, 2.0);
  // Adhesion adds to an impact: mu v^2/2 + F x = K x^2/2 without loss, at x = 0.01 d.
  const double x = overlap * d;
  const auto lossless = [&](double) { return contact::Adhesion{pull_off, 0.0, 0.0}; };
  EXPECT_NEAR(softest_stiffness(pair, 1.0, lossless, {speed, 0.0}, overlap) /
                  ((0.5 * mass * speed * speed + 2.0 * pull_off * x) / (x * x)),
              1.0, 1e-9);
}

// A wall is as a partner of infinite mass: at the same speed sqrt(2) times the overlap of a pair.
TEST(GrainContact, AWallNeedsTwiceTheStiffness) {
  const auto none = [](double) { return contact::Adhesion{}; };
  EXPECT_NEAR(softest_stiffness({d, mass}, 0.8, none, {speed, 0.0}, 0.01) /
                  softest_stiffness({d, 0.5 * mass}, 0.8, none, {speed, 0.0}, 0.01),
              2.0, 1e-9);
}

TEST(GrainContact, StickingPairsPressTheSpringOfTheirOwnEscapeVelocity) {
  const contact::Adhesion adhesion{8e-6, 4e-10, 3e-15};
  const double k = sticking_stiffness(glass, d, mass, 0.9, adhesion, speed);
  const contact::AdhesiveContact contact(
      contact::LinearSpringDashpot::from_restitution(k, 0.9, 0.5 * mass), adhesion);
  const double entry = contact.entry_speed(contact.escape_velocity());
  EXPECT_NEAR(linear_stiffness(glass, d, mass, entry, adhesion.force) / k, 1.0, 1e-12);
  // Far slower than impacts, and softer: K goes as the fifth root of the square of the speed, at
  // least as what holds the pair has it.
  EXPECT_LT(k, linear_stiffness(glass, d, mass, speed));
  EXPECT_EQ(sticking_stiffness(glass, d, mass, 0.9, {}, speed),
            linear_stiffness(glass, d, mass, speed));
}

TEST(GrainContact, NumbersOfAPairAreThoseOfItsContact) {
  const contact::Adhesion adhesion{1e-6, 4e-10, 2e-16};
  const PairNumbers n = pair_numbers(100.0, 0.8, mass, adhesion);
  const auto spring = contact::LinearSpringDashpot::from_restitution(100.0, 0.8, 0.5 * mass);
  EXPECT_EQ(n.contact_time, spring.contact_time());
  EXPECT_EQ(n.escape_velocity, contact::AdhesiveContact(spring, adhesion).escape_velocity());
  EXPECT_EQ(n.pull_off, 1e-6);
}

TEST(GrainContact, WhatIsNoMaterialIsRefused) {
  EXPECT_THROW(hertz({0.0, 0.3}, d), InvalidParameter);
  EXPECT_THROW(hertz({1e9, 0.6}, d), InvalidParameter);
  EXPECT_THROW(hertz_contact_time(glass, d, mass, 0.0), InvalidParameter);
  EXPECT_THROW(hamaker_of_surface_energy(-1.0, 4e-10), InvalidParameter);
}

}  // namespace cohesion::powder
