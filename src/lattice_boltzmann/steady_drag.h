// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "constants.h"
#include "lattice_boltzmann/arrays.h"
#include "lattice_boltzmann/flow.h"
#include "lattice_boltzmann/relaxation.h"
#include "lattice_boltzmann/walls.h"
#include "sphere.h"
#include "validation.h"

namespace cohesion::lattice_boltzmann {

/// How a flow is driven, and when it is steady. Lattice units.
struct Course {
  double viscosity;         ///< [spacing^2/step]
  Vector body_force;        ///< [spacing/step^2]
  double tolerance = 1e-6;  ///< of the velocity that is yet to come, over it, [1]
  long most_steps = 1000000;
};

/// What a steady flow through an array of fixed spheres gives.
struct SteadyDrag {
  Vector superficial;          ///< [spacing/step]
  std::vector<Vector> forces;  ///< on each sphere by its surface: F_total less V_p g
  double balance;              ///< error of their sum against the force on the fluid nodes, [1]
  double solid;                ///< fraction of the spheres, [1]
  double diameter;             ///< Sauter mean, [spacing]
  long steps;
};

/// Told between looks at the flow: steps done, and the change of the velocity that is yet to come,
/// [1].
using Told = std::function<void(long, double)>;

/// Runs the flow from rest until what is left of its change, taken for a geometric series, is below
/// the tolerance. Throws InvalidParameter when it is not within the steps given, or blows up.
inline SteadyDrag steady_drag(const Array& array, const Course& course, const Told& told = {}) {
  const Grid grid(array.nodes);
  const Walls walls(grid, array.spheres);
  Flow flow(grid, walls, Relaxation(course.viscosity), static_cast<int>(array.spheres.size()));
  flow.set_body_force(course.body_force);
  const auto speed = [&] {
    const Vector u = flow.superficial_velocity();
    double along = 0.0;
    for (int k = 0; k < 3; k++) along += u[k] * course.body_force[k];
    return along;
  };
  const int interval = 100;
  long steps = 0;
  double before = 0.0, last = 0.0, left = 1.0;
  while (left > course.tolerance) {
    require(steps < course.most_steps, "largest number of steps", course.most_steps,
            "the flow is not steady by then: allow more, or a larger tolerance");
    for (int i = 0; i < interval; i++, steps++) flow.step();
    const double now = speed(), change = now - last;
    require(std::isfinite(now), "velocity", now, "the flow is unstable: take a smaller body force");
    if (steps >= 3 * interval) {
      const double rest = std::abs(change / now), earlier = last - before;
      const bool shrinks = change * earlier > 0.0 && std::abs(change) < std::abs(earlier);
      left = shrinks ? rest * std::abs(change / (earlier - change)) : rest;
    }
    before = last;
    last = now;
    if (told) told(steps, left);
  }
  SteadyDrag found{flow.superficial_velocity(), flow.forces(), 0.0, 0.0, 0.0, steps + 1};
  // Of two steps: momentum that goes to and fro between them is no force.
  flow.step();
  double squares = 0.0, cubes = 0.0, sum = 0.0, force = 0.0;
  for (std::size_t s = 0; s < array.spheres.size(); s++) {
    for (int k = 0; k < 3; k++) {
      found.forces[s][k] = 0.5 * (found.forces[s][k] + flow.forces()[s][k]);
      sum += found.forces[s][k] * course.body_force[k];
    }
    const double d = 2.0 * array.spheres[s].radius;
    squares += d * d;
    cubes += d * d * d;
  }
  for (int k = 0; k < 3; k++) force += course.body_force[k] * course.body_force[k];
  found.balance = std::abs(sum / (force * static_cast<double>(walls.fluid_nodes())) - 1.0);
  found.solid = pi / 6.0 * cubes / grid.volume();
  found.diameter = cubes / squares;
  return found;
}

/// Length of a vector.
inline double size_of(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

/// F* = F_drag/(3 pi mu d U), F_drag = (1 - phi) F_total, of the mean over the spheres, F_total = g
/// V/N: the force by which the fluid is driven in the whole box, spheres included. [1]
inline double mean_drag(const SteadyDrag& drag, const Array& array, const Course& course) {
  const double volume = Grid(array.nodes).volume() / static_cast<double>(array.spheres.size());
  return (1.0 - drag.solid) * size_of(course.body_force) * volume /
         (3.0 * pi * course.viscosity * drag.diameter * size_of(drag.superficial));
}

/// Re = U d/nu, superficial.
inline double reynolds(const SteadyDrag& drag, const Course& course) {
  return size_of(drag.superficial) * drag.diameter / course.viscosity;
}

}  // namespace cohesion::lattice_boltzmann
