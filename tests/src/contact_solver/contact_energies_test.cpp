// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "constants.h"
#include "contact_solver/exact_contact.h"
#include "contact_solver/liquid_bridge_solver.h"
#include "contact_solver/spheres.h"
#include "contact_solver/square_well_solver.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double core = 2.0 * thesis::radius;
constexpr int phases = 8;

struct Balance {
  double worst;  ///< largest error of the energy at any time level, over that of the impact
  double lost;   ///< over the energy of the impact
};

/// Of an impact, until the pair has parted: kinetic energy of the true motion, what is stored and
/// what was lost, against the kinetic energy before.
template <class Solver, int SIZE>
Balance balance(const contact::ContactParameters& p, const contact::Adhesion& a, double edge,
                double part, double speed, double across) {
  Balance found{};
  for (int phase = 0; phase < phases; phase++) {
    const double dt = thesis::contact_time / part;
    auto pair =
        meeting<Solver, SIZE>(p, a, dt, edge, speed, across, dt * (2.0 + (phase + 0.37) / phases));
    const double before = pair.kinetic_energy();
    bool met = false;
    for (int n = 0; n < 100000 && !(met && pair.are_apart()); n++) {
      pair.step();
      met = met || pair.any_in_range();
      found.worst = std::max(found.worst, std::abs(pair.energy - before) / before);
    }
    EXPECT_TRUE(met && pair.are_apart());
    // What flies away is what is left.
    found.worst =
        std::max(found.worst, std::abs(pair.kinetic_energy() + pair.lost - before) / before);
    found.lost = pair.lost / before;
  }
  return found;
}

/// Rounding of the distance, eps core/2, over a step, against the speed: in each step with a force.
double rounding(double part, double speed, double forces) {
  return 2.0 * (forces + 5.0) * eps * core * part / thesis::contact_time / speed;
}

}  // namespace

TEST(ContactEnergies, OfHeadOnImpactsAreConstantAtEveryTimeLevel) {
  const double e = contact::normal_contact(thesis::contact(), thesis::reduced_mass).restitution();
  for (const double part : {4.0, 8.0, 16.0, 50.0}) {
    const double speed = 0.1, of_core = rounding(part, speed, part);
    const auto plain = balance<ContactSolver, ContactHistory::normal_only>(thesis::contact(), {},
                                                                           core, part, speed, 0.0);
    EXPECT_LT(plain.worst, of_core) << part;
    // Of the kinetic energy of one moving sphere, half is of the relative motion.
    EXPECT_NEAR(plain.lost, 0.5 * (1.0 - e * e), of_core) << part;
    const auto adhesive = balance<ContactSolver, ContactHistory::normal_only>(
        thesis::contact(), thesis::adhesion(7.49e-19), core + thesis::range, part, speed, 0.0);
    EXPECT_LT(adhesive.worst, of_core) << part;
    // Faster in contact by the energy of the well.
    const double well = thesis::adhesion(7.49e-19).well_energy();
    EXPECT_GT(adhesive.lost,
              0.5 * (1.0 - e * e) * (1.0 + 2.0 * well / thesis::reduced_mass / speed / speed));
    const auto in_well = balance<SquareWellSolver, ContactHistory::normal_only>(
        thesis::contact(), {0.0, 1e-5, 5e-11}, core + 1e-5, part, speed, 0.0);
    const double fall = 2.0 * 5e-11 / thesis::reduced_mass;
    EXPECT_LT(in_well.worst, of_core) << part;
    EXPECT_NEAR(in_well.lost, 0.5 * (1.0 - e * e) * (1.0 + fall / speed / speed), of_core) << part;
    // The bridge loses the work of its rupture; in its gap each step has a force.
    const double force = 1e-4, gap = 0.05 * core;
    const auto bridge = balance<LiquidBridgeSolver, ContactHistory::normal_only>(
        thesis::elastic(), {force, gap, 0.0, true}, core, part, 0.5, 0.0);
    EXPECT_LT(bridge.worst, rounding(part, 0.5, 3.0 * part)) << part;
    EXPECT_NEAR(bridge.lost, force * gap / (0.5 * thesis::mass * 0.25),
                rounding(part, 0.5, 3.0 * part))
        << part;
  }
}

TEST(ContactEnergies, OfObliqueImpactsAreConstantToTheSecondOrder) {
  // The impulse of friction errs by (4/7) pi^2/16 (dt/t_c)^2 of the speed u across
  // (contact_friction_test.cpp), and its energy by 2 u of that over u^2 + v^2. In a step the pair
  // turns by u dt/D, and what it loses then is the work of the force along the line of centres, of
  // the share 1 - e^2, there where it was. The centrifugal energy is that of touching spheres.
  const double speed = 0.14;
  const double e = contact::normal_contact(thesis::contact(), thesis::reduced_mass).restitution();
  for (const double angle : {0.3, 0.8, 1.3}) {
    const double u = speed * std::sin(angle), v = speed * std::cos(angle);
    const double share = u * u / (speed * speed);
    const double overlap = v * thesis::contact_time / pi / core;
    for (const double friction : {0.0, 0.05, 0.3, 5.0}) {
      contact::ContactParameters p = thesis::contact();
      p.friction = friction;
      for (const double part : {4.0, 8.0, 16.0, 50.0}) {
        const double dt = thesis::contact_time / part;
        const double turning = u * dt / core * (1.0 - e * e) + 1.5 * overlap * overlap * share;
        const double sliding = 4.0 / 7.0 * pi * pi / 16.0 / (part * part) * 2.0 * share;
        const auto plain =
            balance<ContactSolver, ContactHistory::with_friction>(p, {}, core, part, v, u);
        EXPECT_LT(plain.worst, turning + (friction > 0.0 ? sliding : 0.0))
            << angle << " " << friction << " " << part;
      }
    }
  }
}

}  // namespace cohesion::contact_solver
