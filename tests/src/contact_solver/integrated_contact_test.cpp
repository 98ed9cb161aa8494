// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/integrated_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

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
  const hamaker::Law<hamaker::SmallGap> law({constant, 4e-10, 1e-7});
  return contact::adhesion_of(law, two_spheres(0.5 * diameter, 0.5 * diameter));
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

TEST(IntegratedContact, RestitutionIsTheSameAtEverySpeed) {
  // The RK4 sub-steps and the discrete orbit are of second order: at t_c/20, 1e-3 of the speed.
  for (const double restitution : {0.5, 0.7, 0.9, 0.99})
    for (const double speed : {1e-3, 0.1, 10.0}) {
      const Grains g = glass(1e-4, 1e9, restitution);
      const double dt = g.law().contact_time(speed) / 20.0;
      const ContactSolver solver(g.law(), {}, 1e-4, dt);
      double worst = 0.0;
      for (int phase = 0; phase < 16; phase++) {
        HeadOn pair(solver, g.mass, 1e-4, speed, (phase + 0.37) / 16.0);
        worst = std::max(worst, std::abs(pair.rebound(100.0 * dt) / speed / restitution - 1.0));
      }
      std::printf("e %g v %g: %.2e\n", restitution, speed, worst);
      EXPECT_LT(worst, 1e-3) << restitution << " " << speed;
    }
}

TEST(IntegratedContact, EscapesAtTheVelocityOfTheConvergedIntegration) {
  for (const double diameter : {1e-3, 1e-4, 1e-5})
    for (const double modulus : {5e6, 5e7, 3.7e10})
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
            double low = 1e9, high = 0.0;
            for (int phase = 0; phase < 16; phase++) {
              double a = 0.5, b = 2.0;
              for (int k = 0; k < 16; k++) {
                const double m = std::sqrt(a * b);
                HeadOn pair(solver, g.mass, diameter + adhesion.cutoff, m * escape,
                            (phase + 0.37) / 16.0);
                (pair.rebound(20.0 * contact_time) > 0.0 ? b : a) = m;
              }
              low = std::min(low, a);
              high = std::max(high, b);
            }
            std::printf("d %g E %g e %g A %g t_c/%g: %.2e %.2e\n", diameter, modulus, restitution,
                        constant, part, low - 1.0, high - 1.0);
          }
        }
}

}  // namespace cohesion::contact_solver
