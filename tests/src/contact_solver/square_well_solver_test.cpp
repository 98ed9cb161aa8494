// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/square_well_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact_solver/pair_in_plane.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double pi = 3.14159265358979;
constexpr double mu_depth = 5e-11;  // [J]
/// Thin, as the thesis has it, and as wide as the particles.
const std::vector<double> ratios{1.001, 1.01, 1.5, 2.0};
const std::vector<double> parts{4.0, 10.0, 50.0};

contact::Adhesion well(double ratio, double depth = mu_depth) {
  return {0.0, (ratio - 1.0) * core, depth};
}
/// 2 D/mu, [velocity^2]
double gained(double depth = mu_depth) { return 2.0 * depth / thesis::reduced_mass; }

/// What rounding of the distance does to a velocity on the grid in `points` grid points.
double rounding(const ContactSolver& law, double points) {
  return points * eps * (core + law.range()) / law.step();
}

/// Long enough for two ways across the well and a contact.
double long_enough(double ratio, double speed) {
  return 4.0 * (ratio - 1.0) * core / speed + 8.0 * thesis::contact_time;
}

}  // namespace

TEST(SquareWellSolver, ApproachAndEscapeChangeTheEnergyByTheDepth) {
  for (const double ratio : ratios)
    for (const double part : parts)
      for (int phase = 0; phase < phases; phase++)
        for (const double across : {0.0, 0.03}) {
          const SquareWellSolver law(spring(0.0), well(ratio), core, thesis::contact_time / part);
          PairInPlane pair(law, core + law.range(), 0.02, across, phase);
          const double before = pair.energy(), turning = pair.turning();
          pair.until(ContactState::inside);
          const double speed = std::sqrt(2.0 * before + gained());
          // What turning does in contact counts as constant there: it changes by 3 overlap/core.
          const double normal = std::sqrt(0.02 * 0.02 + gained());
          const double overlap = normal * thesis::contact_time / pi / core;
          const double room = 3.0 * across * across * overlap * overlap / 0.02;
          EXPECT_NEAR(std::sqrt(2.0 * pair.energy()), speed,
                      rounding(law, 2.0 * part + 20.0) + room)
              << ratio << " " << part;
          ASSERT_TRUE(pair.parts_within(long_enough(ratio, 0.02))) << ratio << " " << part;
          EXPECT_NEAR(std::sqrt(2.0 * pair.energy()), std::sqrt(2.0 * before),
                      rounding(law, 2.0 * part + 20.0) * speed / 0.02 + room)
              << ratio << " " << part << " " << phase;
          EXPECT_NEAR(pair.turning(), turning, 1e4 * eps * core * 0.1);
        }
}

TEST(SquareWellSolver, EscapesHeadOnAtTheVelocityOfTheClosedFormForAnyStepAndPhase) {
  const auto law = spring(thesis::contact().damping);
  const double e = law.restitution();
  for (const double depth : {1e-11, 5e-11, 1e-10}) {
    const double escape = std::sqrt(gained(depth) * (1.0 / (e * e) - 1.0));
    for (const double ratio : ratios)
      for (const double part : parts)
        for (int phase = 0; phase < phases; phase++)
          for (const double factor : {0.999, 1.001}) {
            const SquareWellSolver contact(law, well(ratio, depth), core,
                                           thesis::contact_time / part);
            PairInPlane pair(contact, core + contact.range(), factor * escape, 0.0, phase);
            // Just above it flies away from the edge at e sqrt(2e-3) of the speed.
            EXPECT_EQ(pair.parts_within(long_enough(ratio, escape)), factor > 1.0)
                << depth << " " << ratio << " " << part << " " << phase;
          }
  }
}

TEST(SquareWellSolver, RestitutionInTheWellIsThatOfTheSpring) {
  const auto law = spring(thesis::contact().damping);
  for (const double ratio : ratios)
    for (const double part : parts)
      for (int phase = 0; phase < phases; phase++) {
        const SquareWellSolver contact(law, well(ratio), core, thesis::contact_time / part);
        const double speed = 0.05, e = law.restitution();
        PairInPlane pair(contact, core + contact.range(), speed, 0.0, phase);
        ASSERT_TRUE(pair.parts_within(long_enough(ratio, speed)));
        const double back = std::sqrt(e * e * (speed * speed + gained()) - gained());
        EXPECT_NEAR(pair.vx, back, rounding(contact, 2.0 * part + 20.0)) << ratio << " " << part;
      }
}

TEST(SquareWellSolver, ObliquePairsFlyStraightThroughTheWell) {
  // A pair that misses the contact: two crossings, and the energy at the end that of the start; the
  // angle between is that of two refractions, sin a = b/R outside and b v/(v' R) inside.
  for (const double ratio : {1.5, 2.0})
    for (const double part : parts)
      for (int phase = 0; phase < phases; phase++) {
        const SquareWellSolver law(spring(0.0), well(ratio), core, thesis::contact_time / part);
        const double speed = 0.05, edge = ratio * core;
        PairInPlane pair(law, core + law.range(), speed, 0.0, phase);
        pair.y = 0.95 * edge;
        pair.x = std::sqrt(edge * edge - pair.y * pair.y) + pair.x - edge;
        ASSERT_TRUE(pair.parts_within(long_enough(ratio, speed)));
        const double inside = std::sqrt(speed * speed + gained());
        const double turned = 2.0 * (std::asin(0.95) - std::asin(0.95 * speed / inside));
        // The impulse acts at a grid point, and there along its line of centres: up to a step of
        // flight from where it is due.
        const double angle = std::atan2(-pair.vy, -pair.vx);
        EXPECT_NEAR(angle, turned, 4.0 * law.step() * inside / edge) << ratio << " " << part;
        EXPECT_NEAR(std::hypot(pair.vx, pair.vy), speed, rounding(law, 20.0));
      }
}

TEST(SquareWellSolver, WithoutDepthIsTheContactAlone) {
  const auto law = spring(thesis::contact().damping);
  for (const double ratio : {1.0, 1.01, 2.0})
    for (int phase = 0; phase < phases; phase++) {
      const SquareWellSolver contact(law, well(ratio, 0.0), core, thesis::contact_time / 10.0);
      PairInPlane pair(contact, core + contact.range(), 0.02, 0.0, phase);
      ASSERT_TRUE(pair.parts_within(long_enough(ratio, 0.02)));
      EXPECT_NEAR(pair.vx, law.restitution() * 0.02, rounding(contact, 40.0)) << ratio;
    }
}

TEST(SquareWellSolver, ACapturedPairKeepsItsEnergyForAThousandBounces) {
  const double speed = 0.01;  // of sqrt(2 D/mu) = 0.012 m/s that it would need
  for (const double ratio : ratios)
    for (const double part : parts)
      for (const double across : {0.0, 0.004}) {
        if (ratio > 1.1 && part > 4.0) continue;  // it would take many steps in flight
        const SquareWellSolver law(spring(0.0), well(ratio), core, thesis::contact_time / part);
        PairInPlane pair(law, core + law.range(), speed, across, 0.0);
        pair.x = core + 0.5 * law.range();
        pair.y = 0.0;
        pair.state.phase = ContactState::inside;
        const double before = pair.energy();
        const double bounce = 2.0 * law.range() / speed + thesis::contact_time;
        for (int n = 0; n < 1000.0 * bounce / law.step(); n++) {
          pair.step();
          ASSERT_TRUE(pair.state.in_range());
        }
        pair.until(ContactState::inside);
        // Rounding in each step with an event, felt along the normal, and in each contact what
        // turning changes by, as above.
        const double events = 1000.0 * (part + 5.0);
        const double overlap = speed * thesis::contact_time / pi / core;
        const double turned = across / speed * overlap;
        EXPECT_NEAR(std::sqrt(pair.energy() / before), 1.0,
                    std::sqrt(events) * rounding(law, 4.0) / speed + 3000.0 * turned * turned)
            << ratio << " " << part << " " << across;
      }
}

TEST(SquareWellSolver, RestsUnderLoadOnTheContactAndAtTheEdge) {
  const auto law = spring(thesis::contact().damping);
  for (const double part : parts)
    for (const double load : {-9.81, 9.81}) {
      const SquareWellSolver contact(law, well(1.01), core, thesis::contact_time / part);
      PairInPlane pair(contact, core + contact.range(), 0.0, 0.0, 0.0);
      pair.x = load < 0.0 ? core * (1.0 - 1e-9) : core + contact.range();
      pair.y = pair.vx = pair.vy = 0.0;
      pair.external = load;
      pair.state.phase = ContactState::inside;
      for (int n = 0; n < 800.0 * part; n++) {
        pair.step();
        EXPECT_TRUE(pair.state.in_range());
      }
      // In contact it presses the spring on the grid; at the edge it hangs, turned back from where
      // a step under the load takes it.
      const double overlap = thesis::reduced_mass * 9.81 / discrete_stiffness(contact);
      const double fall = 0.5 * 9.81 * contact.step() * contact.step();
      if (load < 0.0)
        EXPECT_NEAR(core - pair.distance(), overlap, 4.0 * eps * core + 1e-9 * overlap) << part;
      else
        EXPECT_NEAR(pair.distance(), core + contact.range(), 2.0 * fall) << part;
    }
}

TEST(SquareWellSolver, ABoundPairBetweenEventsHasNoForce) {
  const SquareWellSolver law(spring(0.0), well(1.5), core, thesis::contact_time / 10.0);
  ContactState state;
  state.phase = ContactState::inside;
  EXPECT_EQ(law.advance({1.2 * core, 0.01, 0.02}, 9.81, law.step(), state).force, 0.0);
  EXPECT_EQ(state.phase, ContactState::inside);
  // A run that starts with a pair in its well does not let it fall in.
  ContactState unknown;
  EXPECT_EQ(law.advance({1.2 * core, 0.01, 0.02}, 0.0, 0.5 * law.step(), unknown).force, 0.0);
  EXPECT_EQ(unknown.phase, ContactState::inside);
}

TEST(SquareWellSolver, ExtremesStayFinite) {
  for (const double damping : {0.0, 1.0, 1e3})
    for (const double ratio : {1.0, 1.0 + 1e-9, 1.001, 3.0})
      for (const double depth : {0.0, 1e-20, 1e-11, 1e-3})
        for (const double speed : {0.0, 1e-9, 0.02, 1.0})
          for (const double across : {0.0, 0.5}) {
            const SquareWellSolver law(spring(damping), well(ratio, depth), core,
                                       thesis::contact_time / 4);
            PairInPlane pair(law, core + law.range(), speed, across, 3.0);
            for (int n = 0; n < 1000; n++) pair.step();
            EXPECT_TRUE(std::isfinite(pair.x) && std::isfinite(pair.vy))
                << damping << " " << ratio << " " << depth << " " << speed << " " << across;
          }
}

}  // namespace cohesion::contact_solver
