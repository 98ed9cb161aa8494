// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/flux_parts.h"

#include <gtest/gtest.h>

#include <limits>

#include "constants.h"
#include "contact_solver/spheres.h"
#include "sampled_contact/sampled_contact.h"
#include "sampled_contact/sampled_well.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

constexpr double core = 2.0 * thesis::radius;
const Body particle = thesis::particle();
using Pair = Spheres<ContactSolver, ContactHistory::normal_only>;

constexpr double repulsion = 3.0, pull = 2.0;
const Vector3 place{0.6, 0.8, 0.0}, friction{-0.4, 0.3, 0.0};

}  // namespace

TEST(FluxParts, WhatIsNotOfContactIsOfAdhesion) {
  FluxParts parts;
  parts.add(0.5, place, (repulsion - pull) * place + friction, repulsion * place + friction);
  const MomentumFlux contact = momentum_flux(place, repulsion * place + friction);
  const MomentumFlux adhesion = momentum_flux(place, -pull * place);
  for (std::size_t k = 0; k < contact.size(); k++) {
    EXPECT_NEAR(parts.of[FluxParts::contact][k], 0.5 * contact[k], 16 * eps);
    EXPECT_NEAR(parts.of[FluxParts::adhesion][k], 0.5 * adhesion[k], 16 * eps);
  }
}

TEST(FluxParts, OfASampledContactTheSpringAndFrictionAreOfContact) {
  contact::ContactParameters p = thesis::contact();
  p.friction = 0.3;
  const double dt = 1e-5, overlap = 1e-6, rate = 0.01;
  const PairMotion grid{{core - overlap, 0.0, 0.0}, {-rate, 0.02, 0.0}, {}, {}};
  const double normal = dt * (800.0 * overlap + 0.79e-3 * rate);
  for (const double depth : {0.0, 5e-11}) {
    const double range = depth > 0.0 ? 0.01 * core : 0.0;
    const sampled_contact::SampledContact<sampled_contact::SampledWell> c(
        p, {0.0, range, depth}, particle, particle, {0.5 * dt, 0.5 * dt});
    // A pair that flew into the contact from outside of the well gets the impulse of its edge, too.
    ContactHistory history;
    const FrictionalStep step =
        c.advance<ContactHistory::with_friction>(grid, {}, false, history, nullptr);
    // The overlap is a difference of numbers a thousand times larger.
    const Vector3 by_contact = c.by_contact(grid, step);
    EXPECT_NEAR(by_contact.x / normal, 1.0, 1e-12);
    EXPECT_NEAR(by_contact.y, step.impulse.y, 4 * eps * normal);
    EXPECT_LT(by_contact.y, -1e-3 * normal);
    const double gain = std::sqrt(rate * rate + 2.0 * depth / thesis::reduced_mass) - rate;
    EXPECT_NEAR(step.impulse.x, normal - thesis::reduced_mass * gain, 1e-12 * normal);
  }
}

TEST(FluxParts, InAPersistentContactAtRestTheSpringBearsTheAdhesion) {
  const contact::Adhesion a = thesis::adhesion(2e-18);
  const double dt = thesis::contact_time / 10.0, distance = core - a.force / 800.0;
  Pair pair(thesis::contact(), a, dt);
  pair.add(particle, {}, {});
  pair.add(particle, {distance, 0.0, 0.0}, {});
  pair.steps(5);
  ASSERT_EQ(pair.contacts[0].history.normal.phase, ContactState::persistent);
  pair.contacts[0].by_contact = {};
  pair.step();
  // A few roundings of the distance in a step.
  const double rounding = 16 * eps * thesis::reduced_mass * core / dt;
  EXPECT_NEAR(pair.contacts[0].by_contact.x, a.force * dt, rounding);
  EXPECT_NEAR(pair.spheres[1].v.x, 0.0, rounding / thesis::mass);
}

TEST(FluxParts, InAResolvedImpactTheSpringGivesWhatItDoesInContact) {
  // Head-on, elastic: the spring meets at v_c^2 = v^2 + 2 W/mu, and repels for the time T of
  // x = x_e (1 - cos w0 t) + v_c/w0 sin w0 t > 0, x_e = F/K: 2 mu v_c + F T in all.
  const double speed = 0.02;
  for (const double hamaker : {0.0, 2e-18}) {
    const contact::Adhesion a = hamaker > 0.0 ? thesis::adhesion(hamaker) : contact::Adhesion{};
    const double w0 = std::sqrt(800.0 / thesis::reduced_mass);
    const double met = std::sqrt(speed * speed + 2.0 * a.well_energy() / thesis::reduced_mass);
    const double time = 2.0 / w0 * (pi - std::atan2(met / w0, a.force / 800.0));
    const double expected = 2.0 * thesis::reduced_mass * met + a.force * time;
    for (const double part : {4.0, 30.0}) {
      const double dt = thesis::contact_time / part;
      auto pair = meeting<ContactSolver, ContactHistory::normal_only>(
          thesis::elastic(), a, dt, core + a.cutoff, speed, 0.0, 2.3 * dt);
      const int steps = static_cast<int>(2.5 * part) + 4;
      pair.steps(steps);
      ASSERT_TRUE(pair.are_apart());
      // A few roundings of the distance of 1e-3 m in each step, at w0 over the speed; the way
      // through the range of 4e-10 m is known to 3e-10 of itself, and so is its energy.
      EXPECT_NEAR(pair.contacts[0].by_contact.x / expected, 1.0,
                  4.0 * steps * core * eps * w0 / speed + 1e-9);
      EXPECT_EQ(pair.contacts[0].by_contact.y, 0.0);
    }
  }
}

TEST(MomentumFlux, IsPositiveInCompressionAndNotSymmetricWithFriction) {
  const MomentumFlux flux = momentum_flux({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0});
  EXPECT_EQ(flux, (MomentumFlux{4.0, 10.0, 18.0, 5.0, 6.0, 12.0}));
}

}  // namespace cohesion::contact_solver
