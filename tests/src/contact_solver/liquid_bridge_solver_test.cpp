// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/liquid_bridge_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/adhesive_contact.h"
#include "contact_solver/pair_in_plane.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const double parts[] = {4.0, 8.0, 16.0, 50.0};

contact::Adhesion bridge(double force = 1e-4, double gap = 0.05 * core) {
  return {force, gap, 0.0, true};
}

/// Bridges of constant force, and of a liquid whose pull falls over a tenth to ten times the gap of
/// rupture.
std::vector<contact::Adhesion> bridges() {
  std::vector<contact::Adhesion> all;
  for (const double force : {1e-5, 1e-4, 1e-3})
    for (const double gap : {1e-6, 0.05 * core, core}) all.push_back(bridge(force, gap));
  for (const double fall : {0.1, 1.0, 10.0})
    for (const double gap : {1e-6, 0.05 * core})
      all.push_back({1e-4, gap, 0.0, true, {}, fall * gap});
  return all;
}

/// A pull that falls stops a pair later.
double long_enough(const contact::Adhesion& a) {
  const double weakest = a.pull().at(a.cutoff);
  return 8.0 * thesis::contact_time +
         4.0 * std::sqrt(2.0 * thesis::reduced_mass * a.cutoff / weakest);
}

}  // namespace

TEST(LiquidBridgeSolver, EscapesHeadOnAtTheVelocityOfTheClosedFormForAnyStepAndPhase) {
  const auto law = spring(thesis::contact().damping);
  for (const contact::Adhesion& a : bridges()) {
    const double escape = contact::AdhesiveContact(law, a).escape_velocity();
    for (const double part : parts)
      for (int phase = 0; phase < phases; phase++)
        for (const double factor : {0.999, 1.001}) {
          const LiquidBridgeSolver contact(law, a, core, thesis::contact_time / part);
          PairInPlane pair(contact, core, factor * escape, 0.0, phase);
          EXPECT_EQ(pair.parts_within(long_enough(a)), factor > 1.0)
              << a.force << " " << a.cutoff << " " << a.fall << " " << part << " " << phase;
        }
  }
}

TEST(LiquidBridgeSolver, TakesTheWorkOfTheBridge) {
  for (const contact::Adhesion& a :
       {bridge(), contact::Adhesion{1e-4, 0.05 * core, 0.0, true, {}, 0.02 * core}})
    for (const double part : parts)
      for (int phase = 0; phase < phases; phase++)
        for (const double across : {0.0, 0.3}) {
          const LiquidBridgeSolver contact(spring(0.0), a, core, thesis::contact_time / part);
          PairInPlane pair(contact, core, 0.5, across, phase);
          const double before = pair.energy(), turning = pair.turning();
          ASSERT_TRUE(pair.parts_within(long_enough(a)));
          const double lost = (before - pair.energy()) * thesis::reduced_mass;
          // Places rounded over the step, in some 20 of them; turning, of whose energy: in contact
          // 3 x/R, in the gap the square of the angle of a step.
          const double overlap = 0.5 / std::sqrt(800.0 / thesis::reduced_mass) / core;
          const double angle = 0.5 * contact.step() / core;
          const double of_turning =
              thesis::reduced_mass * across * across * (3.0 * overlap * overlap + angle * angle);
          EXPECT_NEAR(lost, a.well_energy(),
                      thesis::reduced_mass * 20.0 * part * eps * core / contact.step() + of_turning)
              << a.fall << " " << part << " " << phase;
          EXPECT_NEAR(pair.turning(), turning, 1e4 * eps * core * 0.5);
        }
}

// A pair in a bridge that falls, let go at rest: when it meets.
TEST(LiquidBridgeSolver, ClosesUnderAFallingPullInTheTimeOfTheLaw) {
  const contact::Adhesion a{1e-4, 0.05 * core, 0.0, true, {}, 0.02 * core};
  const liquid_bridge::Pull pull = a.pull();
  const double from = 0.9 * a.cutoff;
  // Time from the energy, dS/v, with S = from (1 - z^2) for the speed that vanishes at first; by
  // the midpoint rule, to 1e-6.
  double time = 0.0;
  constexpr int intervals = 1000;
  for (int k = 0; k < intervals; k++) {
    const double z = (k + 0.5) / intervals, gap = from * (1.0 - z * z);
    const double speed =
        std::sqrt(2.0 * pull.mean(gap, from) * (from - gap) / thesis::reduced_mass);
    time += 2.0 * z * from / intervals / speed;
  }
  for (const double part : {4.0, 16.0, 64.0}) {
    const double dt = thesis::contact_time / part;
    const LiquidBridgeSolver contact(spring(0.0), a, core, dt);
    ContactState state;
    state.phase = ContactState::inside;
    double distance = core + from, rate = 0.0;
    double found = 0.0;
    for (int n = 0; n < 100000; n++) {
      const ContactStep step =
          contact.advance({distance, rate, 0.0}, 0.0, n ? dt : 0.5 * dt, state);
      rate += (n ? dt : 0.5 * dt) * step.force / thesis::reduced_mass;
      const double last = distance;
      distance += dt * rate;
      if (distance < core) {
        // The touch within its step, but for the contact's force in the rest of it and for the
        // curvature of the flight: half the square of a step times the acceleration.
        found = dt * (n + (last - core) / (last - distance));
        break;
      }
    }
    // Of second order in the change of the pull within a segment, less than a third: a twelfth of
    // its square. The step with the touch is taken as straight.
    EXPECT_NEAR(found / time, 1.0, 1.0 / 9.0 / 12.0 + 0.5 * dt / time) << part;
  }
}

TEST(LiquidBridgeSolver, PartsUnderASlowLoadAtTheForceOfTouch) {
  for (const double fall : {0.0, 0.02 * core}) {
    const contact::Adhesion a{1e-4, 0.05 * core, 0.0, true, {}, fall};
    for (const double factor : {0.99, 1.01}) {
      const LiquidBridgeSolver contact(spring(4e-3), a, core, thesis::contact_time / 8.0);
      PairInPlane pair(contact, core, 1e-3, 0.0, 0);
      // At rest after the first tenth; the load grows over hundreds of contact times.
      bool parted = false;
      for (int n = 0; n < 20000 && !parted; n++) {
        const double grown = std::min(std::max(n - 2000, 0) / 6000.0, 1.0);
        pair.external = grown * factor * a.force / thesis::reduced_mass;
        pair.step();
        parted = n > 2000 && pair.state.phase == ContactState::outside;
      }
      EXPECT_EQ(parted, factor > 1.0) << fall << " " << factor;
    }
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
