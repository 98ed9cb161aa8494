// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/integrated_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>

#include "contact_solver/contact_solver.h"
#include "contact_solver/hertz_reference.h"
#include "hamaker/law.h"
#include "hamaker/small_gap.h"
#include "sphere.h"

namespace cohesion::contact_solver {
namespace {

using hertz_reference::Grains;

/// Two spheres of glass of this diameter [length].
Grains glass(double diameter, double modulus, double restitution) {
  const double mass = 2650.0 * sphere_volume(0.5 * diameter);
  return {modulus, 0.25 * diameter, restitution, 0.5 * mass};
}
contact::Adhesion hamaker(double diameter, double constant) {
  static std::deque<hamaker::HamakerLaw<hamaker::SmallGap>> laws;
  laws.emplace_back(hamaker::HamakerParameters{constant, 4e-10, 1e-7});
  return contact::adhesion_with_tail(laws.back(), two_spheres(0.5 * diameter, 0.5 * diameter));
}

/// A pair that flies head-on into contact on an engine's grid.
struct HeadOn {
  const ContactSolver& solver;
  double mass, distance, rate;
  ContactState state{};

  HeadOn(const ContactSolver& solver_, double mass_, double edge, double speed, double phase)
      : solver(solver_),
        mass(mass_),
        distance(edge + speed * solver.step() * (1.0 + phase)),
        rate(-speed) {}

  /// The speed at which they part; 0: not within the time.
  double rebound(double time) {
    bool was = false;
    for (int n = 0; n < time / solver.step(); n++) {
      rate += solver.step() *
              solver.advance({distance, rate, 0.0}, 0.0, solver.step(), state).force / mass;
      distance += solver.step() * rate;
      was = was || state.in_range();
      if (was && state.phase == ContactState::outside) return rate;
    }
    return 0.0;
  }
};

}  // namespace

TEST(IntegratedContact, BeginsWhereRoundingHasAPairBeyondTouch) {
  const Grains g = glass(1e-4, 1e9, 0.9);
  const double dt = g.law().contact_time(0.1) / 20.0;
  const IntegratedContact contact(g.law(), 0.0, dt);
  Overlap at{0.0, 0.1}, beyond{-1e-20, 0.1};
  NormalRecord record, same;
  EXPECT_EQ(contact.advance(at, dt, 0.0, record), dt);
  EXPECT_EQ(contact.advance(beyond, dt, 0.0, same), dt);
  EXPECT_EQ(beyond.x, at.x);
  EXPECT_EQ(beyond.v, at.v);
  EXPECT_EQ(same.dissipated, record.dissipated);
}

TEST(IntegratedContact, RestitutionIsTheSameAtEverySpeed) {
  // Of second order in the step, and no more than a part of what the dashpot takes.
  for (const double restitution : {0.5, 0.7, 0.9, 0.99})
    for (const double speed : {1e-3, 0.1, 10.0})
      for (const double part : {10.0, 20.0, 40.0}) {
        const Grains g = glass(1e-4, 1e9, restitution);
        const double dt = g.law().contact_time(speed) / part;
        const ContactSolver solver(g.law(), {}, 1e-4, dt);
        for (int phase = 0; phase < 8; phase++) {
          HeadOn pair(solver, g.mass, 1e-4, speed, (phase + 0.37) / 8.0);
          EXPECT_NEAR(pair.rebound(5.0 * part * dt) / speed, restitution,
                      0.4 * (1.0 - restitution * restitution) / (part * part))
              << restitution << " " << speed << " " << part << " " << phase;
        }
      }
}

TEST(IntegratedContact, EscapesAtTheVelocityOfTheConvergedIntegration) {
  // The largest relative error of the escape velocity; docs/verification/contact_motion.md has what
  // is printed.
  double coarse = 0.0, coarse_damped = 0.0, fine = 0.0;
  for (const double diameter : {1e-3, 1e-4, 1e-5})
    for (const double modulus : {5e6, 1e9, 3.7e10})
      for (const double restitution : {0.5, 0.7, 0.9, 0.99})
        for (const double constant : {1e-20, 1e-18}) {
          const Grains g = glass(diameter, modulus, restitution);
          const contact::Adhesion adhesion = hamaker(diameter, constant);
          const double escape = hertz_reference::escape_velocity(g, adhesion);
          const double touch = std::sqrt(escape * escape + 2.0 * adhesion.well_energy() / g.mass);
          const double contact_time =
              hertz_reference::impact({g.modulus, g.radius, 1.0, g.mass}, adhesion.force, touch)
                  .time;
          for (const double part : {10.0, 20.0}) {
            const ContactSolver solver(g.law(), adhesion, diameter, contact_time / part);
            double& error = part == 20.0 ? fine : restitution < 0.7 ? coarse_damped : coarse;
            for (int phase = 0; phase < 16; phase++) {
              double low = 0.98, high = 1.02;
              while (high - low > 1e-5) {
                const double factor = 0.5 * (low + high);
                HeadOn pair(solver, g.mass, diameter + adhesion.cutoff, factor * escape,
                            (phase + 0.37) / 16.0);
                (pair.rebound(20.0 * contact_time) > 0.0 ? high : low) = factor;
              }
              error = std::max(error, std::abs(0.5 * (low + high) - 1.0));
            }
          }
        }
  std::printf("t_c/10, e >= 0.7: %.3g; e = 0.5: %.3g; t_c/20: %.3g\n", coarse, coarse_damped, fine);
  EXPECT_LT(fine, 1e-3);
  EXPECT_LT(coarse, 2e-3);
}

// What other forces do is known at the time level only: a persistent contact may have ended there,
// further out than it was deep.
TEST(IntegratedContact, AnAccountIsFiniteWhereOthersHavePulledAPairApart) {
  const double step = 1e-6, deep = 1e-9;
  const IntegratedContact<contact::HertzSpringDashpot> contact(glass(4e-4, 1.4e8, 0.9).law(), 1e-6,
                                                               step);
  ContactState state;
  state.phase = ContactState::persistent;
  state.velocity_offset = 1e-4;
  for (const double out : {0.5, 2.0, 10.0}) {
    // From the overlap `deep` to the gap out * deep.
    const double rate = (1.0 + out) * deep / step;
    const ContactPoint now{-out * deep, rate};
    const StaggeredMotion at{4e-4 + out * deep, rate, 0.0};
    EXPECT_TRUE(std::isfinite(contact.account(now, at, state, 0.0))) << out;
    EXPECT_TRUE(std::isfinite(contact.true_rate(now, at, 0.0, state, 0.0))) << out;
    EXPECT_GE(contact.dissipation(now, at, state, 0.0), 0.0) << out;
  }
}

}  // namespace cohesion::contact_solver
