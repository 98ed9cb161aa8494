// SPDX-License-Identifier: BSD-3-Clause
#include "contact/sampled_work.h"

#include <gtest/gtest.h>

#include <vector>

namespace cohesion::contact {
namespace {

constexpr double radius = 0.5e-3, mass = 1.4e-6, stiffness = 800.0, damping = 0.8e-3;
constexpr double inertia = 0.4 * mass * radius * radius;

/// Two spheres with spring, dashpot, and a tangential spring and dashpot without slider, stepped as
/// an engine does.
struct Spheres {
  Vector3 xi{}, xj;
  Motion half;  // velocities half a step behind the places
  Vector3 displacement;
  double exponent = 1.0;

  ContactSample contact() const {
    ContactSample c;
    const Vector3 way = xi - xj;
    c.normal = (1.0 / norm(way)) * way;
    c.overlap = 2.0 * radius - norm(way);
    if (c.overlap <= 0.0) return c;
    c.exponent = exponent;
    c.stiffness = stiffness * std::pow(c.overlap / 1e-6, exponent - 1.0);
    c.repulsion = c.stiffness * c.overlap - damping * c.separation_speed(half);
    c.lever_i = c.lever_j = radius - 0.5 * c.overlap;
    c.displacement = displacement;
    c.tangential_stiffness = 0.3 * stiffness;
    c.tangential_damping = 0.5 * damping;
    c.tangential =
        -c.tangential_stiffness * displacement - c.tangential_damping * c.sliding_velocity(half);
    return c;
  }
};

double kinetic(const Motion& m) {
  const auto of = [](const Moving& p) {
    return 0.5 * mass * dot(p.velocity, p.velocity) + 0.5 * inertia * dot(p.spin, p.spin);
  };
  return of(m.i) + of(m.j);
}

/// Largest change of the tally's total over an impact of t = 2e-4 s.
double largest_residual(Spheres s, double dt) {
  Losses lost;
  double worst = 0.0, start = kinetic(s.half);
  for (int step = 0; step * dt < 2e-4; step++) {
    s.xi += dt * s.half.i.velocity;
    s.xj += dt * s.half.j.velocity;
    ContactSample c = s.contact();
    if (c.overlap > 0.0) {
      s.displacement += dt * c.sliding_velocity(s.half);
      s.displacement -= dot(s.displacement, c.normal) * c.normal;
      c = s.contact();
    } else {
      s.displacement = {};
    }
    const Vector3 force = c.force_on_i();
    const auto kicked = [&](const Moving& p, double sign, const Vector3& torque, double time) {
      return Moving{p.velocity + (sign * time / mass) * force, p.spin + (time / inertia) * torque};
    };
    const Motion grid{kicked(s.half.i, 1.0, c.torque_on_i(), 0.5 * dt),
                      kicked(s.half.j, -1.0, c.torque_on_j(), 0.5 * dt)};
    const Motion after = half_a_step_on(s.half, grid);
    lost.add(dt, losses(c, s.half, grid));
    const Stored held = stored(c, after, 0.5 * dt);
    s.half = after;
    // The tangential spring is empty at the end of a contact; what it had then is lost as well.
    const double residual =
        kinetic(s.half) + held.spring + lost.normal_damping + lost.tangential - start;
    worst = std::max(worst, std::abs(residual));
    // What the tangential force takes is in its spring and dashpot, nothing being lost in sliding,
    // until they part.
    if (c.overlap > 0.0 && held.overlap > 0.0) {
      EXPECT_NEAR(lost.tangential, lost.tangential_damping + held.tangential_spring, 1e-3 * start);
      EXPECT_GT(lost.tangential, 0.0);
    }
  }
  EXPECT_GT(lost.normal_damping, 0.01 * start);
  return worst / start;
}

Spheres oblique(double exponent) {
  Spheres s;
  s.xj = {2.0 * radius + 1e-9, 0.0, 0.0};
  s.half.i = {{0.05, 0.03, 0.0}, {20.0, -30.0, 40.0}};
  s.half.j = {{-0.05, 0.0, 0.01}, {0.0, 10.0, 5.0}};
  s.exponent = exponent;
  return s;
}

}  // namespace

TEST(SampledWork, TallyOfAnImpactClosesAtSecondOrder) {
  for (const double exponent : {1.0, 1.5}) {
    const double coarse = largest_residual(oblique(exponent), 1e-6);
    const double fine = largest_residual(oblique(exponent), 1e-7);
    // Of the order of (w dt)^2/8 = 1.4e-4; the phase of entry and exit in the step changes it by a
    // factor of some.
    EXPECT_LT(coarse, 1e-3);
    EXPECT_LT(fine, coarse / 30.0);
  }
}

TEST(SampledWork, HalfAStepOnIsAsFarAgain) {
  const Motion before{{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}, {}};
  const Motion grid{{{2.0, 2.0, 2.0}, {4.0, 4.0, 4.0}}, {{1.0, 0.0, 0.0}, {}}};
  const Motion after = half_a_step_on(before, grid);
  EXPECT_EQ(after.i.velocity.x, 3.0);
  EXPECT_EQ(after.i.velocity.z, 1.0);
  EXPECT_EQ(after.i.spin.y, 3.0);
  EXPECT_EQ(after.j.velocity.x, 2.0);
}

TEST(SampledWork, SlidingLeavesTheDashpotNothing) {
  ContactSample c;
  c.normal = {1.0, 0.0, 0.0};
  c.overlap = 1e-6;
  c.stiffness = stiffness;
  c.tangential_damping = damping;
  const Motion m{{{0.0, 0.1, 0.0}, {}}, {}};
  c.tangential = -0.3 * damping * Vector3{0.0, 0.1, 0.0};  // less than the dashpot would hold
  Losses lost = losses(c, m, m);
  EXPECT_EQ(lost.tangential_damping, 0.0);
  EXPECT_DOUBLE_EQ(lost.tangential, 0.3 * damping * 0.01);
  c.tangential = -damping * Vector3{0.0, 0.1, 0.0};
  lost = losses(c, m, m);
  EXPECT_DOUBLE_EQ(lost.tangential_damping, damping * 0.01);
}

TEST(SampledWork, TorqueThatResistsRollingTakesItsWork) {
  ContactSample c;
  c.normal = {1.0, 0.0, 0.0};
  c.rolling_i = {0.0, -2.0, 0.0};
  c.rolling_j = {0.0, 2.0, 0.0};
  const Motion m{{{}, {0.0, 3.0, 0.0}}, {{}, {0.0, 1.0, 0.0}}};
  EXPECT_DOUBLE_EQ(losses(c, m, m).rolling, 4.0);
  // The force 2/0.5 = 4 stretches the spring by 1: 4/2.
  EXPECT_DOUBLE_EQ(rolling_spring_energy({0.0, 2.0, 0.0}, 4.0, 0.5), 2.0);
  EXPECT_EQ(rolling_spring_energy({0.0, 2.0, 0.0}, 0.0, 0.5), 0.0);
}

TEST(SampledWork, WhatHasPartedStoresNothing) {
  ContactSample c;
  c.normal = {1.0, 0.0, 0.0};
  c.overlap = 1e-8;
  c.stiffness = c.tangential_stiffness = stiffness;
  c.displacement = {0.0, 1e-8, 0.0};
  const Motion leaves{{{0.1, 0.0, 0.0}, {}}, {}};
  const Stored s = stored(c, leaves, 1e-6);
  EXPECT_DOUBLE_EQ(s.overlap, 1e-8 - 1e-7);
  EXPECT_EQ(s.spring, 0.0);
  EXPECT_EQ(s.tangential_spring, 0.0);
  EXPECT_GT(stored(c, {}, 1e-6).tangential_spring, 0.0);
  c.overlap = -1e-8;  // a gap that the pair closes within the half step: no force has acted yet
  EXPECT_EQ(stored(c, {{{-0.1, 0.0, 0.0}, {}}, {}}, 1e-6).spring, 0.0);
}

}  // namespace cohesion::contact
