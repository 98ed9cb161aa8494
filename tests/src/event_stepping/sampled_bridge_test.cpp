// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/sampled_bridge.h"

#include <gtest/gtest.h>

#include "event_stepping/pair_run.h"

namespace cohesion::event_stepping {
namespace {

constexpr double core = 2.0 * thesis::radius;
constexpr double force = 1e-4, gap = 0.05 * core;
const Body particle{thesis::radius, 1.0 / thesis::mass};

using Bridged = PairRun<SampledBridge>;

Bridged meeting(double dt, double speed) {
  const Vector3 velocity{-speed, 0.0, 0.0};
  return {thesis::elastic(),
          {force, gap, 0.0, true},
          particle,
          particle,
          dt,
          {{core + 0.37 * dt * speed, 0, 0}, velocity}};
}

}  // namespace

TEST(SampledBridge, FormsAtTouchAndBreaksBeyondItsGap) {
  EXPECT_FALSE(sampled_bridge(gap, 0.5 * gap, false));
  EXPECT_TRUE(sampled_bridge(gap, -1e-9, false));
  EXPECT_TRUE(sampled_bridge(gap, 0.5 * gap, true));
  EXPECT_FALSE(sampled_bridge(gap, 1.5 * gap, true));
  const SampledBridge law(contact::normal_contact(thesis::contact(), thesis::reduced_mass),
                          {force, gap, 0.0, true}, core, 1e-6);
  const RelativeState in_gap{{core + 0.5 * gap, 0, 0}, {}};
  const StepWindow window{5e-7, 5e-7};
  EXPECT_EQ(law.advance(in_gap, window, false).change.velocity.x, 0.0);
  EXPECT_NEAR(
      law.advance(in_gap, window, true).change.velocity.x / (-1e-6 * force / thesis::reduced_mass),
      1.0, 1e-12);
}

TEST(SampledBridge, TakesItsWorkToTheOrderOfTheStep) {
  double error[2];
  for (const int k : {0, 1}) {
    const double dt = thesis::contact_time / (k ? 400.0 : 50.0);
    Bridged run = meeting(dt, 0.5);
    const double before = run.kinetic();
    ASSERT_TRUE(run.run_to_escape(40000));
    error[k] = std::abs(run.kinetic() + force * gap - before) / (force * gap);
    // Up to a step of the flight beyond the gap, and leapfrog's error of the contact, both ends.
    EXPECT_LT(error[k], 0.5 * dt / gap + 4.0 * dt / thesis::contact_time);
    EXPECT_NEAR(run.dissipated() / (force * gap), 1.0, 0.5 * dt / gap * 2.0);
  }
}

TEST(SampledBridge, TalliesWhatItDidNotDo) {
  // Through the touch with no spring to speak of: the energy with what is stored and lost is that
  // of before, at once, as the force is constant.
  contact::ContactParameters soft;
  soft.stiffness = 1e-9;
  const double dt = 1e-6, speed = 0.5;
  Bridged run(soft, {force, gap, 0.0, true}, particle, particle, dt,
              {{core + 0.37 * dt * speed, 0, 0}, {-speed, 0, 0}});
  const double before = run.kinetic();
  run.step();
  run.step();
  ASSERT_TRUE(run.last().inside);
  const double at_the_end = core - run.distance();
  // The dissipation of the step is that from its begin to where it was found.
  EXPECT_NEAR((run.kinetic() + run.stored_at(at_the_end) + run.dissipated()) / before, 1.0, 1e-12);
}

}  // namespace cohesion::event_stepping
