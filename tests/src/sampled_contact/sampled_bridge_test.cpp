// SPDX-License-Identifier: BSD-3-Clause
#include "sampled_contact/sampled_bridge.h"

#include <gtest/gtest.h>

#include "contact_solver/thesis_contact.h"

namespace cohesion::sampled_contact {
namespace {

constexpr double core = 2.0 * thesis::radius;
constexpr double force = 1e-4, gap = 0.05 * core;

contact::Adhesion bridge(double fall = 0.0) { return {force, gap, 0.0, true, {}, fall}; }

/// A pair on its line of centres, on a grid of step dt.
struct Bridged {
  SampledBridge law;
  double dt, distance, rate;  // half a step before the first time level
  PairStep last{};
  double dissipated = 0.0;

  Bridged(const contact::ContactParameters& p, double step, double wait, double speed,
          double fall = 0.0)
      : law(contact::normal_contact(p, thesis::reduced_mass), bridge(fall), core),
        dt(step),
        distance(core + wait * speed),
        rate(-speed) {}

  void step() {
    const double next = distance + 0.5 * dt * rate;
    last = law.advance({next, 0.0, 0.0}, {rate, 0.0, 0.0}, {0.5 * dt, 0.5 * dt}, last.inside);
    dissipated += last.record.dissipated;
    rate += last.velocity_change.x;
    distance = next + 0.5 * dt * rate;
  }
  double kinetic() const { return 0.5 * thesis::reduced_mass * rate * rate; }
};

}  // namespace

TEST(SampledBridge, FormsAtTouchAndBreaksBeyondItsGap) {
  EXPECT_FALSE(sampled_bridge(gap, 0.5 * gap, false));
  EXPECT_TRUE(sampled_bridge(gap, -1e-9, false));
  EXPECT_TRUE(sampled_bridge(gap, 0.5 * gap, true));
  EXPECT_FALSE(sampled_bridge(gap, 1.5 * gap, true));
  const SampledBridge law(contact::normal_contact(thesis::contact(), thesis::reduced_mass),
                          bridge(), core);
  const Vector3 in_gap{core + 0.5 * gap, 0, 0};
  const StepWindow window{5e-7, 5e-7};
  EXPECT_EQ(law.advance(in_gap, {}, window, false).velocity_change.x, 0.0);
  EXPECT_NEAR(law.advance(in_gap, {}, window, true).velocity_change.x /
                  (-1e-6 * force / thesis::reduced_mass),
              1.0, 1e-12);
}

TEST(SampledBridge, TakesItsWorkToTheOrderOfTheStep) {
  for (const double fall : {0.0, 0.4 * gap}) {
    const double work = bridge(fall).well_energy();
    for (const double part : {50.0, 400.0}) {
      const double dt = thesis::contact_time / part;
      Bridged run(thesis::elastic(), dt, 0.37 * dt, 0.5, fall);
      const double before = run.kinetic();
      bool bridged = false;
      for (int n = 0; n < 40000 && !(bridged && !run.last.inside); n++) {
        run.step();
        bridged = bridged || run.last.inside;
      }
      ASSERT_TRUE(bridged && !run.last.inside);
      // A step of the flight under the force of touch, at both ends, and leapfrog's error of the
      // contact.
      const double step = force * 0.5 * dt / work;
      EXPECT_LT(std::abs(run.kinetic() + work - before) / work,
                step + 4.0 * dt / thesis::contact_time)
          << fall << " " << part;
      EXPECT_NEAR(run.dissipated / work, 1.0, 2.0 * step) << fall << " " << part;
    }
  }
}

TEST(SampledBridge, TalliesWhatItDidNotDo) {
  // Through the touch with no spring to speak of: the energy with what is stored and lost is that
  // of before, at once, as the force is constant.
  contact::ContactParameters soft;
  soft.stiffness = 1e-9;
  const double dt = 1e-6;
  Bridged run(soft, dt, 0.37 * dt, 0.5);
  const double before = run.kinetic();
  run.step();
  run.step();
  ASSERT_TRUE(run.last.inside);
  const double overlap = core - run.distance;
  const double stored = run.law.spring_energy(overlap) + run.law.adhesion_energy(overlap);
  // The dissipation of the step is that from its begin to where it was found.
  EXPECT_NEAR((run.kinetic() + stored + run.dissipated) / before, 1.0, 1e-12);
}

}  // namespace cohesion::sampled_contact
