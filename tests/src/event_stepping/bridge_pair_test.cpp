// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/bridge_pair.h"

#include <gtest/gtest.h>

#include <limits>

#include "contact/adhesive_contact.h"
#include "event_stepping/pair_run.h"

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double pi = 3.14159265358979324;
constexpr double core = 2.0 * thesis::radius;
constexpr double force = 1e-4, gap = 0.05 * core;  // W = 5e-9 J
const Body particle{thesis::radius, 1.0 / thesis::mass};
const double pull = force / thesis::reduced_mass;

using Bridged = PairRun<BridgePair>;

contact::Adhesion bridge(double f = force, double h = gap) { return {f, h, 0.0, true}; }

/// Two thesis particles that would touch at `speed`, with the impact parameter `offset` [length],
/// `wait` after the start.
Bridged meeting(const contact::ContactParameters& p, double dt, double speed, double offset,
                double wait, const contact::Adhesion& a = bridge()) {
  const Vector3 velocity{-speed, 0.0, 0.0};
  const Vector3 touch{std::sqrt(std::max(core * core - offset * offset, 0.0)), offset, 0.0};
  return {p, a, particle, particle, dt, {touch - wait * velocity, velocity}};
}

}  // namespace

TEST(BridgePair, EscapesHeadOnAtTheVelocityOfTheClosedFormForAnyStepAndPhase) {
  const auto spring = contact::normal_contact(thesis::contact(), thesis::reduced_mass);
  for (const double f : {1e-5, 1e-4, 1e-3})
    for (const double h : {1e-6, gap, core}) {
      const double closed = contact::AdhesiveContact(spring, bridge(f, h)).escape_velocity();
      for (const double part : {2.0, 4.0, 10.0, 50.0})
        for (int phase = 0; phase < 8; phase++)
          // The contact rounds the distance by 1e-19 m, w0 1e-19 m = 3e-15 m/s of 5e-3 m/s, and the
          // velocity by eps, in each of its < 60 steps: 1e-10 of the energy that decides.
          for (const double off : {-1e-8, 1e-8}) {
            const double escape = closed * (1.0 + off), dt = thesis::contact_time / part;
            Bridged run = meeting(thesis::contact(), dt, escape, 0.0, dt * (phase + 0.37) / 8.0,
                                  bridge(f, h));
            // Up and down the bridge, which barely reaches h: twice sqrt(2 mu h/F).
            const double flight = 2.0 * std::sqrt(2.0 * thesis::reduced_mass * h / f);
            const int steps = static_cast<int>((3.0 * thesis::contact_time + flight) / dt) + 10;
            EXPECT_EQ(run.run_to_escape(steps), off > 0.0) << f << " " << h << " " << part;
            EXPECT_EQ(run.unresolved(), 0);
          }
    }
}

TEST(BridgePair, IsWhereItsPhasesPutItAtAnyTime) {
  // Head-on and elastic: at v to the touch; in contact about F/K; in the gap on the parabola of F.
  const double speed = 0.5, start = core + 3e-5;
  const double w0 = std::sqrt(800.0 / thesis::reduced_mass), rest = force / 800.0;
  const double swing = std::hypot(speed / w0, rest), phase = std::atan2(rest, speed / w0);
  const double touches = 3e-5 / speed, parts = touches + (pi + 2.0 * phase) / w0;
  const double slower = std::sqrt(speed * speed - 2.0 * pull * gap);
  const double breaks = parts + (speed - slower) / pull;
  const auto distance = [&](double t) {
    if (t < touches) return start - speed * t;
    if (t < parts) return core - rest - swing * std::sin(w0 * (t - touches) - phase);
    const double s = t - parts;
    if (t < breaks) return core + s * (speed - 0.5 * pull * s);
    return core + gap + slower * (t - breaks);
  };
  for (const double part : {1.1, 4.0, 8.0, 16.0, 50.0}) {
    const double dt = thesis::contact_time / part;
    Bridged run(thesis::elastic(), bridge(), particle, particle, dt,
                {{start, 0, 0}, {-speed, 0, 0}});
    bool in_the_gap = false;
    const int steps = static_cast<int>(1.5 * breaks / dt) + 1;
    for (int n = 1; n <= steps; n++) {
      run.step();
      // A few roundings of distance and speed in each step, and what the ones of the distance do to
      // speeds in contact, w0 1e-19 m, later.
      EXPECT_NEAR(run.distance(), distance(n * dt),
                  n * (8.0 * eps * core + dt * (4.0 * n * eps * speed + 1e-13)));
      in_the_gap = in_the_gap || (run.last().inside && run.distance() > core);
    }
    EXPECT_FALSE(run.last().inside);
    EXPECT_TRUE(in_the_gap || part == 1.1);
    // Its speed, and what it has paid, beside roundings of the energy.
    const double rounding = steps * 20.0 * eps * speed;
    EXPECT_NEAR(-run.approach(), slower, 1e-12 + rounding);
    EXPECT_NEAR(run.dissipated(), force * gap,
                10.0 * eps * force * gap + thesis::reduced_mass * speed * rounding);
  }
}

TEST(BridgePair, WhatDoesNotTouchFliesOnToTheLastBit) {
  for (const double part : {1.0, 4.0, 20.0}) {
    const double dt = thesis::contact_time / part;
    Bridged run = meeting(thesis::contact(), dt, 0.1, core + 0.01 * gap, 0.05 * core / 0.1);
    const Vector3 velocity = run.state().velocity;
    double nearest = run.distance();
    for (int n = 0; n < static_cast<int>(0.1 * core / 0.1 / dt) + 1; n++) {
      run.step();
      nearest = std::min(nearest, run.distance());
      EXPECT_FALSE(run.last().interacts);
      EXPECT_FALSE(run.last().inside);
      EXPECT_EQ(run.state().velocity.x, velocity.x);
      EXPECT_EQ(run.state().velocity.y, velocity.y);
    }
    EXPECT_LT(nearest, core + 0.1 * gap);
  }
}

TEST(BridgePair, TakesTheWorkOfTheBridgeFromObliquePairsToo) {
  // All but the turning is exact, and that keeps the angular momentum. What it does to the energy
  // is an error of the kicks, second order in the step.
  for (const double offset : {0.2, 0.6, 0.9}) {
    double error[2];
    for (const int k : {0, 1}) {
      const double dt = thesis::contact_time / (k ? 40.0 : 10.0);
      Bridged run = meeting(thesis::elastic(), dt, 0.5, offset * core, 0.37 * dt);
      const Vector3 turning = run.angular_momentum();
      const double before = run.kinetic();
      ASSERT_TRUE(run.run_to_escape(4000));
      EXPECT_NEAR(run.angular_momentum().z / turning.z, 1.0, run.steps() * 20.0 * eps);
      error[k] = std::abs(run.kinetic() + force * gap - before) / before;
    }
    // In contact the centrifugal force counts as constant: 1.5 (x/R)^2 of the turning, both steps.
    const double overlap = 0.5 / std::sqrt(800.0 / thesis::reduced_mass) / core;
    const double floor = 1.5 * overlap * overlap;
    EXPECT_LT(error[0], 1e-5 + floor) << offset;
    EXPECT_LT(error[1], error[0] / 8.0 + floor) << offset;
  }
}

TEST(BridgePair, AsWideAsTheParticlesItTakesItsWorkWhileItTurns) {
  // Kicks err by the square of the angle by which the pair turns in a step, of the work; steps of
  // up to four contact times.
  const double weak = 1e-6, wide = core;
  for (const double offset : {0.5, 0.9})
    for (const double part : {0.25, 1.0, 8.0}) {
      const double dt = thesis::contact_time / part;
      const Vector3 velocity{0.3, 0.2, 0.0};
      Bridged run(thesis::elastic(), bridge(weak, wide), particle, particle, dt,
                  {{std::sqrt(1.0 - offset * offset) * core, offset * core, 0.0}, velocity});
      run.set_inside(true, 0.0);
      const double before = run.energy();
      for (int n = 0; n < 10000 && run.last().inside; n++) run.step();
      ASSERT_FALSE(run.last().inside);
      const double angle = norm(velocity) * dt / core;
      EXPECT_NEAR(run.energy(), before, angle * angle * weak * wide) << offset << " " << part;
      EXPECT_GT(run.distance(), core + wide * (1.0 - angle * angle));
    }
}

TEST(BridgePair, ACapturedPairBouncesForEver) {
  // Elastic, below the speed that all of F h_r takes: the energy stays, the turning included.
  const double most = std::sqrt(2.0 * force * gap / thesis::reduced_mass);
  for (const double part : {2.0, 4.0, 10.0})
    for (const double offset : {0.0, 0.5}) {
      const double dt = thesis::contact_time / part, speed = 0.9 * most;
      Bridged run = meeting(thesis::elastic(), dt, speed, offset * core, 0.37 * dt);
      const double before = run.kinetic();
      double worst = 0.0;
      for (int n = 0; n < 20000; n++) {
        run.step();
        ASSERT_TRUE(run.last().inside || n < 2);
        worst = std::max(worst, std::abs(run.energy() / before - 1.0));
      }
      EXPECT_NEAR(run.dissipated() / before, 0.0, 20000 * 20.0 * eps);
      EXPECT_EQ(run.unresolved(), 0);
      // 20 roundings a step; w0 1e-19 m in each step in contact over the speed; turning: as above,
      // and by kicks: of the energy of turning, offset^2, the square of the angle of a step.
      const double overlap = speed / std::sqrt(800.0 / thesis::reduced_mass) / core;
      const double angle = speed * dt / core;
      const double turning = offset * offset * (1.5 * overlap * overlap + angle * angle);
      EXPECT_LT(worst, 20000 * (20.0 * eps + 2.0 * 3.5e4 * 1e-19 / speed) + 100.0 * turning)
          << part << " " << offset;
    }
}

TEST(BridgePair, BreaksWhereOthersPullItBeyondItsGap) {
  const double dt = thesis::contact_time / 4.0;
  for (const double velocity : {-0.01, 0.0, 0.01}) {
    Bridged run(thesis::contact(), bridge(), particle, particle, dt,
                {{core + 1.01 * gap, 0, 0}, {velocity, 0, 0}});
    run.set_inside(true, -1.01 * gap);
    run.step();
    EXPECT_FALSE(run.last().inside);
    EXPECT_EQ(run.state().velocity.x, velocity);
    EXPECT_NEAR(run.dissipated() / (1.01 * force * gap), 1.0, 1e-12);
  }
}

TEST(BridgePair, OneThatOthersPushedIntoContactHasIt) {
  const double dt = thesis::contact_time / 4.0;
  Bridged run(thesis::contact(), bridge(), particle, particle, dt,
              {{core - 1e-7, 0, 0}, {1e-3, 0, 0}});
  run.step();
  EXPECT_TRUE(run.last().inside);
}

TEST(BridgePair, WithoutForceIsTheContactAlone) {
  const double dt = thesis::contact_time / 4.0;
  Bridged run = meeting(thesis::contact(), dt, 0.1, 0.3 * core, 0.37 * dt, {});
  PairRun<SpherePair> plain(thesis::contact(), {}, particle, particle, dt, run.state());
  for (int n = 0; n < 20; n++) {
    run.step();
    plain.step();
    // Both fly to the touch by a root, each in its own way: some roundings of the distance, which
    // in contact are speeds of w0 1e-19 m.
    EXPECT_NEAR(run.state().velocity.x, plain.state().velocity.x, 1e-13);
    EXPECT_NEAR(run.state().separation.x, plain.state().separation.x, (n + 1) * 4.0 * eps * core);
    EXPECT_EQ(run.last().inside, plain.last().inside);
  }
}

TEST(BridgePlane, IsAHeadOnPairWhateverItsWayAlongTheWall) {
  const Body wall{0.0, 0.0};
  const double dt = thesis::contact_time / 8.0, r = thesis::radius;
  PairRun<BridgePlane> run(thesis::contact(), bridge(), particle, wall, dt,
                           {{r + 1e-5, 0, 0}, {-0.4, 0, 0}});
  const Body twin{r, 0.0};
  PairRun<BridgePair> pair(thesis::contact(), bridge(), particle, twin, dt,
                           {{2.0 * r + 1e-5, 0, 0}, {-0.4, 0, 0}});
  for (int n = 0; n < 60; n++) {
    run.step();
    pair.step();
    EXPECT_NEAR(run.state().velocity.x, pair.state().velocity.x, 1e-12);
    EXPECT_EQ(run.last().inside, pair.last().inside);
  }
  const BridgePlane plane(contact::normal_contact(thesis::contact(), thesis::mass), bridge(), r,
                          dt);
  const PairStep step =
      plane.advance({{r + 1e-7, 0, 0}, {-0.4, 0.3, -0.2}}, {0.5 * dt, 0.5 * dt}, false);
  EXPECT_TRUE(step.inside);
  EXPECT_EQ(step.change.velocity.y, 0.0);
  EXPECT_EQ(step.change.separation.z, 0.0);
}

}  // namespace cohesion::event_stepping
