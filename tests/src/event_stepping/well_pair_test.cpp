// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/well_pair.h"

#include <gtest/gtest.h>

#include <limits>

#include "event_stepping/pair_run.h"

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double core = 2.0 * thesis::radius;
const Body particle{thesis::radius, 1.0 / thesis::mass};

using Wells = PairRun<WellPair>;

contact::Adhesion well(double depth, double ratio) { return {0.0, (ratio - 1.0) * core, depth}; }

double speed_of(double depth) { return std::sqrt(2.0 * depth / thesis::reduced_mass); }

/// Two thesis particles that meet the edge with `speed`, the impact parameter `offset` [length],
/// `wait` after the start.
Wells meeting(const contact::ContactParameters& p, const contact::Adhesion& a, double dt,
              double speed, double offset, double wait) {
  const double edge = core + a.cutoff;
  const Vector3 velocity{-speed, 0.0, 0.0};
  const Vector3 at_edge{std::sqrt(edge * edge - offset * offset), offset, 0.0};
  return {p, a, particle, particle, dt, {at_edge - wait * velocity, velocity}};
}

}  // namespace

TEST(WellPair, EscapesHeadOnAtTheVelocityOfTheClosedFormForAnyStepAndPhase) {
  // v_esc^2 = (2 D/mu) (1/e^2 - 1), e of the thesis' contact.
  const double e = contact::normal_contact(thesis::contact(), thesis::reduced_mass).restitution();
  for (const double depth : {1e-11, 5e-11, 1e-10})
    for (const double ratio : {1.0, 1.0001, 1.01, 1.5})
      for (const double part : {2.0, 4.0, 10.0, 50.0})
        for (int phase = 0; phase < 8; phase++)
          // The contact rounds the distance by 1e-19 m, w0 1e-19 m = 3e-15 m/s of 1e-3 m/s, and the
          // velocity by eps, in each of its < 60 steps: 1e-10 of the energy that decides.
          for (const double off : {-1e-8, 1e-8}) {
            const double escape = speed_of(depth) * std::sqrt(1.0 / (e * e) - 1.0) * (1.0 + off);
            const double dt = thesis::contact_time / part;
            Wells run = meeting(thesis::contact(), well(depth, ratio), dt, escape, 0.0,
                                dt * (phase + 0.37) / 8.0);
            const double crossing = 2.0 * (ratio - 1.0) * core / speed_of(depth);
            const int steps = static_cast<int>((3.0 * thesis::contact_time + crossing) / dt) + 10;
            EXPECT_EQ(run.run_to_escape(steps), off > 0.0)
                << depth << " " << ratio << " " << part << " " << phase;
            EXPECT_EQ(run.unresolved(), 0);
          }
}

TEST(WellPair, EnergyChangesByTheDepthAtApproachAndEscapeAndNotAtCapture) {
  const double depth = 5e-11, dt = thesis::contact_time / 4.0;
  // Rounding: a few operations on velocities in each step.
  const double few = 20.0 * eps;
  for (const double speed : {1e-3, 0.02}) {
    Wells run = meeting(thesis::elastic(), well(depth, 1.01), dt, speed, 0.3 * core, 0.5 * dt);
    const double before = run.kinetic();
    run.step();
    EXPECT_NEAR((run.kinetic() - before) / depth, 1.0, few * run.kinetic() / depth);
    EXPECT_NEAR(run.stored(), -depth, 0.0);
    EXPECT_TRUE(run.last().inside);
    ASSERT_TRUE(run.run_to_escape(3000));
    // In contact, for up to ten steps at this dt, 1e-19 m is rounded at the force K v/w0: over the
    // energy inside 2 w0 1e-19 m/v.
    const double in = std::hypot(speed, speed_of(depth));
    const double w0 = std::sqrt(800.0 / thesis::reduced_mass);
    EXPECT_NEAR((run.kinetic() - before) / before, 0.0,
                (few * run.steps() + 10.0 * 2.0 * w0 * 1e-19 / in) * (in * in) / (speed * speed));
    EXPECT_EQ(run.stored(), 0.0);
  }
  // Inside the well, too slow to leave.
  Wells run(thesis::elastic(), well(depth, 1.01), particle, particle, dt,
            {{1.009 * core, 0, 0}, {0.5 * speed_of(depth), 0.1 * speed_of(depth), 0}});
  run.set_inside(true, -0.009 * core);
  const double before = run.kinetic();
  int turns = 0;
  for (int n = 0; n < 100; n++) {
    const double approach = run.approach();
    run.step();
    turns += approach < 0.0 && run.approach() > 0.0;
    ASSERT_TRUE(run.last().inside);
    if (run.last().normal.contact_time > 0.0) break;
    EXPECT_NEAR(run.kinetic() / before, 1.0, few * (n + 1));
  }
  EXPECT_EQ(turns, 1);
}

TEST(WellPair, IsWhereItsEventsPutItAtAnyTime) {
  // Head-on and elastic: to the edge at v, through the well at v' = sqrt(v^2 + 2 D/mu), half a
  // period pi/w0 in contact, and back.
  const double depth = 5e-11, speed = 4e-3, start = 1.011 * core, width = 0.01 * core;
  const double inside = std::hypot(speed, speed_of(depth));
  const double contact_time = 3.14159265358979324 * std::sqrt(thesis::reduced_mass / 800.0);
  const double enters = (start - core - width) / speed, touches = enters + width / inside;
  const double parts = touches + contact_time, leaves = parts + width / inside;
  const auto distance = [&](double t) {
    if (t < enters) return start - speed * t;
    if (t < touches) return core + width - inside * (t - enters);
    if (t < parts) {
      const double phase = 3.14159265358979324 * (t - touches) / contact_time;
      return core - inside * contact_time / 3.14159265358979324 * std::sin(phase);
    }
    return t < leaves ? core + inside * (t - parts) : core + width + speed * (t - leaves);
  };
  for (const double part : {1.1, 4.0, 31.0}) {  // a contact is followed for a period at most
    const double dt = thesis::contact_time / part;
    Wells run(thesis::elastic(), well(depth, 1.01), particle, particle, dt,
              {{start, 0, 0}, {-speed, 0, 0}});
    const int steps = static_cast<int>(1.2 * leaves / dt) + 1;
    for (int n = 1; n <= steps; n++) {
      run.step();
      // 1e-19 m in each step, and what it does to speeds in contact, w0 1e-19 m, later.
      EXPECT_NEAR(run.distance(), distance(n * dt), 4e-19 * n + 4e-15 * 10 * n * dt + 1e-18);
    }
    EXPECT_FALSE(run.last().inside);
  }
}

TEST(WellPair, PassesWithoutContactAreRefracted) {
  // The edge refracts the path like light entering a denser medium, n = sqrt(1 + 2 D/(mu v^2)): a
  // pass at impact parameter s that does not touch (s/n > core) is deflected by
  // 2 (asin(s/edge) - asin(s/(n edge))). Up to the grazing pass.
  for (const double ratio : {1.01, 1.5})
    for (const double part : {0.1, 1.0, 4.0, 30.0}) {
      const double depth = 1e-11, speed = 0.1, edge = ratio * core;
      const double n = std::sqrt(1.0 + speed_of(depth) * speed_of(depth) / (speed * speed));
      for (const double share : {0.01, 0.3, 0.7, 0.99, 0.999999}) {
        const double offset = n * core + share * (edge - n * core);
        const double dt = thesis::contact_time / part;
        Wells run = meeting(thesis::contact(), well(depth, ratio), dt, speed, offset, 0.37 * dt);
        const int steps = static_cast<int>(2.0 * edge / speed / dt) + 2;
        for (int k = 0; k < steps; k++) run.step();
        EXPECT_FALSE(run.last().inside);
        const Vector3 v = run.state().velocity;
        const double deflection = 2.0 * (std::asin(offset / edge) - std::asin(offset / n / edge));
        // Positions are rounded by 1e-19 m four times in each step, at random, 5 sigma; the slope
        // of asin.
        const double slope = 2.0 / std::sqrt(1.0 - offset / edge * (offset / edge));
        EXPECT_NEAR(std::atan2(v.y, -v.x), -deflection,
                    slope * 5.0 * std::sqrt(4.0 * steps) * 1e-19 / edge)
            << ratio << " " << share;
        EXPECT_NEAR(norm(v) / speed, 1.0, 40.0 * eps);
        EXPECT_EQ(run.dissipated(), 0.0);
      }
      Wells run =
          meeting(thesis::contact(), well(depth, ratio), 1e-5, speed, edge * (1.0 - 1e-9), 3e-6);
      run.shift({0.0, 2e-9 * edge, 0.0});
      for (int k = 0; k < 100; k++) run.step();
      EXPECT_EQ(run.state().velocity.y, 0.0);
      EXPECT_EQ(run.state().velocity.x, -speed);
    }
}

TEST(WellPair, ObliqueImpactsDoNotDependOnTheStep) {
  for (const double ratio : {1.0001, 1.01, 1.5})
    for (const double share : {0.0, 0.3, 0.7, 0.95}) {
      const double speed = 0.05, depth = 1e-10;
      const auto leave = [&](double part, double wait) {
        const double dt = thesis::contact_time / part;
        Wells run =
            meeting(thesis::contact(), well(depth, ratio), dt, speed, share * core, wait * dt);
        EXPECT_TRUE(run.run_to_escape(static_cast<int>((4.0 * ratio * core / speed) / dt)))
            << ratio << " " << share;
        EXPECT_EQ(run.unresolved(), 0);
        return run.state().velocity;
      };
      const Vector3 fine = leave(200.0, 0.37);
      for (const double part : {2.0, 4.0, 10.0})
        // 1e-19 m of rounding each step, times w0 in contact: 3e-15 m/s; amplified at the edge by
        // speed over normal speed, below 20.
        EXPECT_LT(norm(leave(part, 0.71) - fine), 1e-11) << ratio << " " << share << " " << part;
    }
}

TEST(WellPair, ACapturedElasticPairKeepsEnergyAndAngularMomentum) {
  for (const double ratio : {1.0, 1.0001, 1.01, 1.5})
    for (const double around : {0.0, 0.3, 0.8})
      for (const double part : {2.0, 4.7, 30.0}) {
        const double depth = 5e-11, dt = thesis::contact_time / part;
        const contact::Adhesion a = well(depth, ratio);
        const double v = 0.9 * speed_of(depth);
        Wells run(thesis::elastic(), a, particle, particle, dt,
                  {{core - 1e-9, 0, 0}, {-v * std::sqrt(1.0 - around * around), v * around, 0}});
        run.set_inside(true, 1e-9);
        const double start = run.energy();
        const Vector3 turning = run.angular_momentum();
        const int steps = 20000;
        double worst = 0.0;
        for (int n = 0; n < steps; n++) {
          run.step();
          ASSERT_TRUE(run.last().inside) << ratio << " " << around << " " << part << " " << n;
          worst = std::max(worst, std::abs(run.energy() - start));
        }
        // In contact the distance is rounded by a few 1e-19 m per step at a force of K v/w0; the
        // centrifugal energy is followed to first order in the overlap v/w0: 1.5 (x/R)^2 of it
        // comes and goes.
        const double x = v / std::sqrt(800.0 / thesis::reduced_mass);
        const double rounding =
            5.0 * std::sqrt(steps) * 4e-19 * 800.0 * x + 20.0 * steps * eps * depth;
        const double centrifugal = 1.5 * x * x / core / core * run.kinetic() * 2.0;
        EXPECT_LT(worst, rounding + centrifugal) << ratio << " " << around << " " << part;
        EXPECT_LT(worst, 1e-4 * depth);
        EXPECT_LT(std::abs(run.dissipated()), rounding);
        EXPECT_LT(norm(run.angular_momentum() - turning),
                  16.0 * eps * steps * norm(turning) + 1e-30);
        EXPECT_EQ(run.unresolved(), 0) << ratio << " " << around << " " << part;
      }
}

TEST(WellPair, ACapturedPairWithDashpotComesToTouchAndTurns) {
  // The dashpot takes the motion along the normal until the pair just grazes the core (turning at
  // core distance with what is left: m u_t^2/2), and never more.
  for (const double ratio : {1.0, 1.0001, 1.01, 1.5})
    for (const double around : {0.0, 0.3}) {
      const double depth = 5e-11, dt = thesis::contact_time / 4.0, v = 0.9 * speed_of(depth);
      Wells run(thesis::contact(), well(depth, ratio), particle, particle, dt,
                {{core, 0, 0}, {-v * std::sqrt(1.0 - around * around), v * around, 0}});
      run.set_inside(true, 0.0);
      const double start = run.energy();
      const Vector3 turning = run.angular_momentum();
      double last = run.kinetic();
      const int steps = 400000;
      for (int n = 0; n < steps; n++) {
        run.step();
        ASSERT_TRUE(run.last().inside);
      }
      const double left = 0.5 * thesis::reduced_mass * v * v * around * around;
      EXPECT_LT(run.kinetic(), last);
      EXPECT_GE(run.kinetic(), left * (1.0 - 1e-6));
      EXPECT_LT(run.kinetic() - left, 0.2 * (last - left)) << ratio << " " << around;
      EXPECT_NEAR(run.energy(), start, 1e-6 * depth);
      EXPECT_LT(norm(run.angular_momentum() - turning), 16.0 * eps * steps * norm(turning) + 1e-30);
      EXPECT_EQ(run.unresolved(), 0) << ratio << " " << around;
    }
}

TEST(WellPair, APairThatOthersPutAcrossTheEdgeHasItsEventOnceAndThen) {
  const double depth = 5e-11, dt = 1e-5, speed = 2.0 * speed_of(depth);
  const contact::Adhesion a = well(depth, 1.01);
  const auto after = [&](double distance, double velocity, bool inside, int steps) {
    Wells run(thesis::elastic(), a, particle, particle, dt, {{distance, 0, 0}, {velocity, 0, 0}});
    run.set_inside(inside, core - distance);
    const double before = run.kinetic();
    for (int n = 0; n < steps; n++) run.step();
    return std::pair{(run.kinetic() - before) / depth, run.last().inside};
  };
  const double in = 1.008 * core, out = 1.012 * core;
  const auto is = [](std::pair<double, bool> got, double gain, bool inside) {
    EXPECT_NEAR(got.first, gain, 1e-13);
    EXPECT_EQ(got.second, inside);
  };
  is(after(in, -speed, false, 1), 1.0, true);    // approaching, short of the edge: falls in now
  is(after(in, -speed, false, 3), 1.0, true);    // once
  is(after(in, speed, false, 100), 0.0, false);  // parting: never was in
  is(after(out, speed, true, 1), -1.0, false);   // parting, beyond: leaves now
  is(after(out, speed, true, 3), -1.0, false);
  is(after(out, -speed, true, 3), 0.0, true);       // coming back
  is(after(out, 0.4 * speed, true, 1), 0.0, true);  // captured there
  is(after(out, 0.4 * speed, true, 3), 0.0, true);  // comes back
  is(after(0.999 * core, -speed, false, 1).second ? std::pair{1.0, true} : std::pair{0.0, false},
     1.0, true);  // pushed into the contact: is in the well
}

TEST(WellPair, WithoutDepthItIsTheContactAlone) {
  const double dt = thesis::contact_time / 4.0;
  for (const double offset : {0.0, 0.5, 0.9}) {
    Wells with = meeting(thesis::contact(), {}, dt, 0.1, offset * core, 0.37 * dt);
    PairRun<SpherePair> without(thesis::contact(), {}, particle, particle, dt, with.state());
    for (int n = 0; n < 20; n++) with.step(), without.step();
    EXPECT_EQ(with.state().velocity.x, without.state().velocity.x);
    EXPECT_EQ(with.state().separation.y, without.state().separation.y);
  }
}

}  // namespace cohesion::event_stepping
