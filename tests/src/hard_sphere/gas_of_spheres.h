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

namespace cohesion::hard_sphere {

/// A periodic box.
inline PeriodicBox periodic_box(const PeriodicBox::Edges& edges,
                                const PeriodicBox::Edges& rates = {}) {
  PeriodicBox box;
  box.origin = {-0.3, 0.2, 1.1};
  box.edges = edges;
  box.rates = rates;
  box.periodic = {true, true, true};
  return box;
}

/// Calls f(boxes, separation) for the images of a body at the separation r that are up to
/// `farthest` boxes away from the nearest one; `boxes` is the offset in each direction. With 1
/// these are all images closer than one box, and half a box more between its opposite faces.
template <class F>
void for_each_image(const PeriodicBox& box, double time, const Vector3& r, int farthest, F f) {
  const auto h = box.edges_at(time);
  const Vector3 fraction = PeriodicBox::fraction(h, r);
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

/// Spheres with radii from `least` to `most`, whose number density is proportional to r^-3, so that
/// each range of sizes contributes to the volume. Positions are random without overlap, images
/// included. A sphere of diameter 1 has mass 1. Velocities relative to the flow of the box are
/// random, with the same distribution for all sizes.
struct GasOfSpheres {
  int count = 100;
  double least = 0.5, most = 0.5;
  double speed = 1.0;  // of each component
  unsigned seed = 1;

  void fill(EventSimulation& simulation, const PeriodicBox& box) const {
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

  /// Whether a sphere at a position overlaps no body except `self`, and no wall.
  static bool is_free(const EventSimulation& simulation, const PeriodicBox& box, double time,
                      const Vector3& position, double radius, int self = -1) {
    for (const auto& wall : simulation.walls)
      if (wall.motion.wall.nearest(position, wall.motion.at(time), 0.0).distance < radius)
        return false;
    bool free = true;
    for (int n = 0; n < static_cast<int>(simulation.bodies.size()) && free; n++) {
      if (n == self) continue;
      const double apart = radius + simulation.bodies[n].radius;
      for_each_image(box, time, position - simulation.flights[n].at(time), 1,
                     [&](const Vector3&, const Vector3& r) {
                       if (dot(r, r) < apart * apart) free = false;
                     });
    }
    return free;
  }

 private:
  /// Interpolates between the inverse squares of two numbers.
  static double in_between(double a, double b, double part) {
    return (1.0 - part) / (a * a) + part / (b * b);
  }
};

}  // namespace cohesion::hard_sphere
