// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/liquid_bridge_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/adhesive_contact.h"
#include "contact_solver/pair_in_plane.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const double parts[] = {4.0, 8.0, 16.0, 50.0};

contact::Adhesion bridge(double force = 1e-4, double gap = 0.05 * core) {
  return {force, gap, 0.0, true};
}

double long_enough(double force, double gap) {
  return 8.0 * thesis::contact_time + 4.0 * std::sqrt(2.0 * thesis::reduced_mass * gap / force);
}

}  // namespace

TEST(LiquidBridgeSolver, EscapesHeadOnAtTheVelocityOfTheClosedFormForAnyStepAndPhase) {
  const auto law = spring(thesis::contact().damping);
  for (const double force : {1e-5, 1e-4, 1e-3})
    for (const double gap : {1e-6, 0.05 * core, core}) {
      const double escape = contact::AdhesiveContact(law, bridge(force, gap)).escape_velocity();
      for (const double part : parts)
        for (int phase = 0; phase < phases; phase++)
          for (const double factor : {0.999, 1.001}) {
            const LiquidBridgeSolver contact(law, bridge(force, gap), core,
                                             thesis::contact_time / part);
            PairInPlane pair(contact, core, factor * escape, 0.0, phase);
            EXPECT_EQ(pair.parts_within(long_enough(force, gap)), factor > 1.0)
                << force << " " << gap << " " << part << " " << phase;
          }
    }
}

TEST(LiquidBridgeSolver, TakesTheWorkOfTheBridge) {
  const double force = 1e-4, gap = 0.05 * core;
  for (const double part : parts)
    for (int phase = 0; phase < phases; phase++)
      for (const double across : {0.0, 0.3}) {
        const LiquidBridgeSolver contact(spring(0.0), bridge(), core, thesis::contact_time / part);
        PairInPlane pair(contact, core, 0.5, across, phase);
        const double before = pair.energy(), turning = pair.turning();
        ASSERT_TRUE(pair.parts_within(long_enough(force, gap)));
        const double lost = (before - pair.energy()) * thesis::reduced_mass;
        // Places rounded over the step, in some 20 of them; turning, of whose energy: in contact
        // 3 x/R, in the gap the square of the angle of a step.
        const double overlap = 0.5 / std::sqrt(800.0 / thesis::reduced_mass) / core;
        const double angle = 0.5 * contact.step() / core;
        const double of_turning =
            thesis::reduced_mass * across * across * (3.0 * overlap * overlap + angle * angle);
        EXPECT_NEAR(lost, force * gap,
                    thesis::reduced_mass * 20.0 * part * eps * core / contact.step() + of_turning)
            << part << " " << phase;
        EXPECT_NEAR(pair.turning(), turning, 1e4 * eps * core * 0.5);
      }
}

TEST(LiquidBridgeSolver, ForcesArePositiveOnlyInContactAndNoneBeforeTouch) {
  const LiquidBridgeSolver contact(spring(0.0), bridge(), core, thesis::contact_time / 16.0);
  PairInPlane pair(contact, core, 0.5, 0.0, 3.0);
  pair.x += 0.02 * core;  // within the gap of rupture, without a bridge
  for (int n = 0; n < 1000 && pair.distance() - core > 0.5 * contact.step(); n++) {
    pair.step();
    if (pair.state.phase != ContactState::outside) break;
    EXPECT_EQ(pair.last.force, 0.0);
  }
  ASSERT_TRUE(pair.state.in_range());
  // In the gap the force is that of the bridge, once the true speed at touch is in that of the
  // grid.
  int in_the_gap = 0;
  for (int n = 0; n < 1000 && pair.state.in_range(); n++) {
    const bool entered = pair.state.phase == ContactState::entered;
    const double was = pair.distance();
    pair.step();
    if (!entered || was < core + contact.step() || pair.vx < 0.0) continue;
    if (pair.distance() + 2.0 * contact.step() * pair.vx > core + contact.range()) continue;
    if (in_the_gap++ < 2) continue;
    EXPECT_NEAR(pair.last.force / -1e-4, 1.0, 1e-9);
  }
  EXPECT_GT(in_the_gap, 5);
}

TEST(LiquidBridgeSolver, ARunThatBeginsInTheGapHasNoBridge) {
  const double dt = thesis::contact_time / 8.0;
  const LiquidBridgeSolver contact(spring(0.0), bridge(), core, dt);
  for (const double gap : {-1e-7, 1e-7}) {
    ContactState state;
    const ContactStep step = contact.advance({core + gap, 0.0, 0.0}, 0.0, 0.5 * dt, state);
    EXPECT_EQ(state.in_range(), gap < 0.0);
    EXPECT_EQ(step.force != 0.0, gap < 0.0);
  }
}

}  // namespace cohesion::contact_solver
