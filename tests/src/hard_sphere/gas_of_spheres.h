// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "hard_sphere/box_of_spheres.h"
#include "hard_sphere/event_simulation.h"

/// A periodic box.
inline cohesion::hard_sphere::PeriodicBox periodic_box(
    const cohesion::hard_sphere::PeriodicBox::Edges& edges,
    const cohesion::hard_sphere::PeriodicBox::Edges& rates = {}) {
  cohesion::hard_sphere::PeriodicBox box;
  box.origin = {-0.3, 0.2, 1.1};
  box.edges = edges;
  box.rates = rates;
  box.periodic = {true, true, true};
  return box;
}

/// Calls f(boxes, separation) for the images of a body at the separation r that are up to
/// `farthest` boxes away from the nearest one, by the number of boxes that they are away in each
/// direction. With 1 that is all that are nearer than a box, and half a box more, between its
/// opposite sides.
template <class F>
void for_each_image(const cohesion::hard_sphere::PeriodicBox& box, double time,
                    const cohesion::Vector3& r, int farthest, F f) {
  using cohesion::Vector3;
  const auto h = box.edges_at(time);
  const Vector3 fraction = cohesion::hard_sphere::PeriodicBox::fraction(h, r);
  const double coordinates[] = {fraction.x, fraction.y, fraction.z};
  int low[3], high[3];
  for (int k = 0; k < 3; k++) {
    low[k] = high[k] = 0;
    if (!box.periodic[k]) continue;
    const int nearest = -static_cast<int>(std::lround(coordinates[k]));
    low[k] = nearest - farthest;
    high[k] = nearest + farthest;
  }
  for (int x = low[0]; x <= high[0]; x++)
    for (int y = low[1]; y <= high[1]; y++)
      for (int z = low[2]; z <= high[2]; z++) {
        const Vector3 boxes{double(x), double(y), double(z)};
        f(boxes, r + h * boxes);
      }
}

/// Spheres with radii from `least` to `most`, of which the number goes as r^-3: so each range of
/// sizes has its part of the volume. They are at random places where they overlap no image of each
/// other. A sphere of diameter 1 has mass 1. Their velocities are random, but for the flow of the
/// box, large ones as fast as small ones.
struct GasOfSpheres {
  int count = 100;
  double least = 0.5, most = 0.5;
  double speed = 1.0;  // of each component
  unsigned seed = 1;

  void fill(cohesion::hard_sphere::EventSimulation& simulation,
            const cohesion::hard_sphere::PeriodicBox& box) const {
    using namespace cohesion::hard_sphere;
    using cohesion::Vector3;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform;
    std::normal_distribution<double> normal;
    std::vector<double> radii;
    for (int n = 0; n < count; n++)
      radii.push_back(1.0 / std::sqrt(in_between(least, most, uniform(random))));
    if (count > 1) radii[0] = most, radii[1] = least;
    std::sort(radii.rbegin(), radii.rend());
    for (const double radius : radii) {
      HardSphere body;
      body.tag = static_cast<int>(simulation.bodies.size()) + 1;
      body.radius = radius;
      body.inverse_mass = 1.0 / (8.0 * radius * radius * radius);
      body.inverse_inertia = 2.5 * body.inverse_mass / (radius * radius);
      VersionedFlight flight;
      Vector3 fraction;
      int tries = 0;
      do {
        if (tries++ == 100000) throw std::runtime_error("no room for another sphere");
        fraction = {uniform(random), uniform(random), uniform(random)};
        flight.position = box.origin + box.edges * fraction;
      } while (!is_free(simulation, box, 0.0, flight.position, radius));
      flight.velocity = speed * Vector3{normal(random), normal(random), normal(random)};
      flight.velocity += box.rates * (fraction - Vector3{0.5, 0.5, 0.5});
      simulation.bodies.push_back(body);
      simulation.flights.push_back(flight);
    }
    simulation.neighbour_lists().bodies_in_box = count;
  }

  /// Whether a sphere overlaps no other one at a place, but for body `self`, and no wall.
  static bool is_free(const cohesion::hard_sphere::EventSimulation& simulation,
                      const cohesion::hard_sphere::PeriodicBox& box, double time,
                      const cohesion::Vector3& position, double radius, int self = -1) {
    for (const auto& wall : simulation.walls)
      if (wall.motion.wall.nearest(position, wall.motion.at(time), 0.0).distance < radius)
        return false;
    bool free = true;
    for (int n = 0; n < static_cast<int>(simulation.bodies.size()) && free; n++) {
      if (n == self) continue;
      const double apart = radius + simulation.bodies[n].radius;
      for_each_image(box, time, position - simulation.flights[n].at(time), 1,
                     [&](const cohesion::Vector3&, const cohesion::Vector3& r) {
                       if (dot(r, r) < apart * apart) free = false;
                     });
    }
    return free;
  }

 private:
  /// Between the inverse squares of two numbers.
  static double in_between(double a, double b, double part) {
    return (1.0 - part) / (a * a) + part / (b * b);
  }
};
