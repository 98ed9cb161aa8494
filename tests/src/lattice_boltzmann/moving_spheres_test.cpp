// SPDX-License-Identifier: BSD-3-Clause
#include "lattice_boltzmann/moving_spheres.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lattice_boltzmann/steady_drag.h"

namespace cohesion::lattice_boltzmann {

namespace {

/// Velocity of the fluid in the mean, seen from the spheres of an array that move with `w` along x:
/// the mean of the last `average` steps of a flow that a force drives. `moves`: whether they do.
struct Seen {
  double velocity, force;
};
Seen seen_from_spheres(const Array& array, double viscosity, double body_force, double w, int steps,
                       int average, bool moves) {
  FlowAmongMovingSpheres flow(Grid(array.nodes), array.spheres, Relaxation(viscosity), {w, 0, 0});
  flow.set_body_force({body_force, 0, 0});
  Seen seen{};
  for (int i = 0; i < steps; i++) {
    flow.step();
    if (i >= steps - average) {
      seen.velocity += (flow.volume_flux()[0] - w) / average;
      seen.force += flow.force()[0] / average;
    }
    if (moves) flow.advance_spheres();
  }
  return seen;
}

Course led(double viscosity, double speed) {
  Course course{viscosity, {1e-8, 0.0, 0.0}};
  course.speed = speed;
  course.tolerance = 1e-6;
  return course;
}

}  // namespace

// In slow flow a velocity of the walls shifts that of the fluid, and no more: seen from the spheres
// the flow that a force drives is that of fixed ones. What is left is inertia, of the order of the
// square of Re, some 1e-4.
TEST(MovingSpheres, WallsWithAVelocityShiftSlowFlow) {
  const Array array = cubic_array(cubic_arrays[0], 0.2, 8.0);
  const double force = 1e-7;
  const Seen still = seen_from_spheres(array, 0.3, force, 0.0, 3000, 100, false);
  ASSERT_GT(still.velocity, 0.0);
  const Seen shifted = seen_from_spheres(array, 0.3, force, -still.velocity, 3000, 100, false);
  EXPECT_NEAR(shifted.velocity / still.velocity, 1.0, 1e-4);
  EXPECT_NEAR(shifted.force / still.force, 1.0, 1e-4);
}

// Spheres that move through a fluid at rest in the mean have the drag of fixed ones in a flow: the
// force that drives a velocity U through fixed spheres drives the same past moving ones, within the
// 1 % that is asked, in the mean of the time in which they move by four spacings. They have come by
// `diameters` before.
void expect_same_drag_in_the_frame_of_the_fluid(double re, double diameters) {
  const double speed = 0.02, diameter = 16.0;
  const Array array = cubic_array(cubic_arrays[0], 0.2, diameter);
  const double viscosity = speed * sauter_mean(array) / re;
  const SteadyDrag fixed = steady_drag(array, led(viscosity, speed));
  const double moved = fixed.superficial[0];
  const int steps = static_cast<int>(diameters * diameter / speed);
  const Seen seen =
      seen_from_spheres(array, viscosity, fixed.body_force[0], -moved, steps, 200, true);
  EXPECT_NEAR(seen.velocity / moved, 1.0, 0.01);
  double held = 0.0;
  for (const Vector& f : fixed.forces) held += f[0];
  EXPECT_NEAR(seen.force / held, 1.0, 0.01);
}

TEST(MovingSpheres, DragIsTheSameInTheFrameOfTheFluid) {
  expect_same_drag_in_the_frame_of_the_fluid(0.5, 4.0);
}

// The wakes meet the next spheres, and the flow takes longer to be steady.
TEST(MovingSpheres, DragIsTheSameInTheFrameOfTheFluidWithInertia) {
  expect_same_drag_in_the_frame_of_the_fluid(20.0, 8.0);
}

}  // namespace cohesion::lattice_boltzmann
