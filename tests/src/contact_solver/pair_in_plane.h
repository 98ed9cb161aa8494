// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "contact_solver/contact_solver.h"
#include "contact_solver/thesis_contact.h"

namespace cohesion::contact_solver {

inline constexpr double core = 2.0 * thesis::radius;  // of the centres at touch, [length]
inline constexpr int phases = 8;                      // positions of an event within its step

inline contact::LinearSpringDashpot spring(double damping) {
  return {thesis::contact().stiffness, damping, thesis::reduced_mass};
}

/// K' of a contact with a linear spring, [force/length].
inline double discrete_stiffness(const ContactSolver& solver) {
  return std::get<LinearContact>(solver.contact()).discrete_spring().stiffness;
}

/// Two spheres in a plane, with staggered velocities as an engine has them.
struct PairInPlane {
  const ContactSolver& solver;
  double x, y, vx, vy;
  double external = 0.0;  ///< acceleration along the line of centres, known to the solver
  ContactState state{};
  ContactStep last{};

  /// One that is to meet the distance `edge` a share `phase` of a step after a time level, at
  /// normal speed and with a speed across.
  PairInPlane(const ContactSolver& solver_, double edge, double speed, double across, double phase)
      : solver(solver_), vx(-speed), vy(across) {
    const double wait = solver.step() * (2.0 + (phase + 0.37) / phases);
    x = edge + speed * wait;
    y = -across * wait;
  }
  double distance() const { return std::hypot(x, y); }
  double energy() const { return 0.5 * (vx * vx + vy * vy); }  // over mu
  double turning() const { return x * vy - y * vx; }

  void step() {
    const double dt = solver.step();
    x += dt * vx;
    y += dt * vy;
    const double r = distance(), nx = x / r, ny = y / r;
    const StaggeredMotion now{r, vx * nx + vy * ny, std::abs(vy * nx - vx * ny)};
    last = solver.advance(now, external, dt, state);
    const double push = dt * (last.force / thesis::reduced_mass + external);
    vx += push * nx;
    vy += push * ny;
  }
  /// Until it has been in range and is out of it again; false: not within the time [time].
  bool parts_within(double time) {
    bool was_inside = state.in_range();
    for (int n = 0; n < time / solver.step(); n++) {
      step();
      was_inside = was_inside || state.in_range();
      if (was_inside && state.phase == ContactState::outside) return true;
    }
    return false;
  }
  void until(ContactState::Phase phase) {
    for (int n = 0; n < 100000 && state.phase != phase; n++) step();
    EXPECT_EQ(state.phase, phase);
  }
};

}  // namespace cohesion::contact_solver
