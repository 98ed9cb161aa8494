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
constexpr int plain = ContactHistory::normal_only;

template <class Pair>
Vector3 relative_velocity(const Pair& pair) {
  return pair.motion(pair.contacts[0]).velocity;
}

}  // namespace

TEST(ContactEdges, ThatOfAWellAloneRefractsAtAnyImpactParameter) {
  // Also through the place of the contact: by 2 (asin(s/edge) - asin(s/(n edge))),
  // n = sqrt(1 + 2 D/(mu v^2)). The impulse acts at a time level, along the line of centres there:
  // up to a step of flight away from where it is due, on the way in and out.
  const double depth = 1e-11, speed = 0.02;
  const double n = std::sqrt(1.0 + 2.0 * depth / thesis::reduced_mass / (speed * speed));
  for (const double ratio : {1.01, 1.5})
    for (const double part : {4.0, 20.0})
      for (const double share : {0.05, 0.3, 0.9}) {
        const double edge = ratio * core, offset = share * edge, dt = thesis::contact_time / part;
        const double along = std::sqrt(edge * edge - offset * offset) + 2.37 * dt * speed;
        Spheres<WellEdgeSolver, plain> pair(thesis::contact(), {0.0, edge - core, depth}, dt);
        pair.add(thesis::particle(), {}, {});
        pair.add(thesis::particle(), {along, offset, 0.0}, {-speed, 0.0, 0.0});
        pair.step();
        const Vector3 turning = pair.angular_momentum();
        const int steps = static_cast<int>(2.5 * edge / speed / dt) + 10;
        double least = 0.0;
        for (int k = 0; k < steps; k++) {
          pair.step();
          const ContactEnergies& energies = pair.contacts[0].energies;
          least = std::min(least, energies.stored.adhesion);
          EXPECT_EQ(energies.stored.spring, 0.0);
        }
        EXPECT_TRUE(pair.are_apart());
        EXPECT_EQ(least, -depth);
        EXPECT_EQ(pair.lost, 0.0);
        const Vector3 v = relative_velocity(pair);
        const double deflection = 2.0 * (std::asin(offset / edge) - std::asin(offset / n / edge));
        const double turned = 2.0 * n * speed * dt / edge / std::sqrt(1.0 - share * share);
        EXPECT_NEAR(std::atan2(v.y, -v.x), -deflection, turned)
            << ratio << " " << part << " " << share;
        // Rounding of the distance over a step, at both events.
        EXPECT_NEAR(norm(v), speed, 20.0 * eps * edge / dt);
        EXPECT_NEAR(pair.angular_momentum().z, turning.z,
                    8.0 * eps * steps * thesis::mass * speed * edge);
      }
}

TEST(ContactEdges, APairFirstSeenInRangeStandsThereWithItsEnergies) {
  // In the first step of a run, and within a run where nothing is known of it: it has not come
  // there by its motion, so it gains no energy of the tail or of the well.
  const double dt = thesis::contact_time / 10.0, depth = 5e-11;
  const auto check = [&](auto pair, double overlap, double adhesion, bool within_run) {
    pair.add(thesis::particle(), {}, {});
    if (within_run) {
      pair.add(thesis::particle(), {2.0 * core, 0.0, 0.0}, {});
      pair.step();
      pair.spheres[1].x = {core - overlap, 0.0, 0.0};
      pair.contacts[0].history = ContactHistory::unknown();
    } else {
      pair.add(thesis::particle(), {core - overlap, 0.0, 0.0}, {});
    }
    pair.step();
    const double spring = overlap > 0.0 ? 400.0 * overlap * overlap : 0.0;
    const double rounding = 4.0 * eps * core * (800.0 * std::abs(overlap) + 2e-4);
    EXPECT_NEAR(pair.energy, spring + adhesion, rounding);
    EXPECT_NEAR(pair.kinetic, 0.0, rounding);
    EXPECT_TRUE(pair.any_in_range());
    // And all of it comes to light: it moves, and its energy stays what it was.
    const double before = pair.energy;
    double worst = 0.0;
    for (int n = 0; n < 40; n++) {
      pair.step();
      worst = std::max(worst, std::abs(pair.energy - before));
    }
    // Rounding of the distance over a step, at the largest speed that there can be.
    const double most = std::sqrt(2.0 * (spring + std::abs(adhesion)) / thesis::reduced_mass);
    EXPECT_LT(worst, 160.0 * eps * core / dt * thesis::reduced_mass * most);
  };
  for (const bool within_run : {false, true}) {
    const auto p = thesis::contact();
    const contact::Adhesion a = thesis::adhesion(7.49e-19);
    check(Spheres<ContactSolver, plain>(p, {}, dt), 1e-7, 0.0, within_run);
    check(Spheres<ContactSolver, plain>(p, a, dt), 1e-7,
          -a.tail_energy - a.force * (a.cutoff + 1e-7), within_run);
    check(Spheres<ContactSolver, plain>(p, a, dt), -0.5 * a.cutoff,
          -a.tail_energy - 0.5 * a.force * a.cutoff, within_run);
    check(Spheres<SquareWellSolver, plain>(p, {0.0, 1e-5, depth}, dt), -0.5e-5, -depth, within_run);
    check(Spheres<SquareWellSolver, plain>(p, {0.0, 1e-5, depth}, dt), 1e-7, -depth, within_run);
    check(Spheres<LiquidBridgeSolver, plain>(p, {1e-4, 0.05 * core, 0.0, true}, dt), 1e-7, -1e-11,
          within_run);
  }
}

TEST(ContactEdges, ABridgeRupturesWithItsWorkWhereOthersPullItApart) {
  // Pulled by a weight on one of the two, stronger than the bridge: at the gap of rupture the work
  // of the bridge is lost, and the rest of the work of the weight is motion.
  const double force = 1e-4, gap = 0.05 * core, gravity = 4.0 * force / thesis::mass;
  for (const double part : {4.0, 10.0, 50.0}) {
    const double dt = thesis::contact_time / part;
    Spheres<LiquidBridgeSolver, plain> sphere(thesis::elastic(), {force, gap, 0.0, true}, dt);
    sphere.add(thesis::particle(), {0.0, 0.0, -thesis::radius + 1e-9}, {});
    sphere.add_wall({{}, {0.0, 0.0, -1.0}, {}});
    sphere.gravity = {0.0, 0.0, -gravity};
    sphere.step();
    const double before = sphere.energy;
    for (int n = 0; n < 100000 && sphere.any_in_range(); n++) sphere.step();
    ASSERT_FALSE(sphere.any_in_range());
    EXPECT_NEAR(sphere.lost / (force * gap), 1.0, 1e-12) << part;
    for (int n = 0; n < 3; n++) sphere.step();
    // It leaves the contact under a load that the spring feels one step late, g dt of its speed.
    const double fall = thesis::mass * gravity * gap;
    const double speed = std::sqrt(1.5 * gravity * gap);
    EXPECT_NEAR(sphere.energy, before, 2.0 * gravity * dt / speed * fall) << part;
  }
}

TEST(ContactEdges, AWallIsTheLimitOfALargeSphere) {
  // Oblique, with friction and adhesion: the sphere's centre is 50 m away, known to 7e-15 m, which
  // over a step is 7e-15 m/dt in each. Its radius is 1e5 larger.
  contact::ContactParameters p = thesis::contact();
  p.friction = 0.3;
  const double ratio = 1e5;
  for (const double hamaker : {1e-19, 2e-16}) {
    const double dt = thesis::contact_time / 8.0, speed = 0.1;
    const contact::Adhesion a = thesis::adhesion(hamaker);
    const Vector3 v{0.0, 0.8 * speed, -speed}, spin{50.0, -20.0, 30.0};
    Spheres<ContactSolver, ContactHistory::with_friction> beside(p, a, dt), two(p, a, dt);
    beside.add(thesis::particle(), {0.0, 0.0, thesis::radius + 2.3 * dt * speed}, v, spin);
    beside.add_wall({{}, {0.0, 0.0, 1.0}, {}});
    two.add(thesis::particle(), {0.0, 0.0, thesis::radius + 2.3 * dt * speed}, v, spin);
    two.add({ratio * thesis::radius, 0.0}, {0.0, 0.0, -ratio * thesis::radius}, {});
    const int steps = 40;
    for (int n = 0; n < steps; n++) {
      beside.step();
      two.step();
    }
    EXPECT_EQ(beside.any_in_range(), hamaker > 1e-18);
    EXPECT_NE(norm(beside.contacts[0].friction), 0.0);
    const double known = steps * (4.0 * eps * ratio * thesis::radius / dt) + 10.0 * speed / ratio;
    EXPECT_LT(norm(beside.spheres[0].v - two.spheres[0].v), known);
    EXPECT_LT(thesis::radius * norm(beside.spheres[0].spin - two.spheres[0].spin), 2.5 * known);
  }
}

}  // namespace cohesion::contact_solver
