// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "constants.h"
#include "hard_sphere/event_simulation.h"
#include "lattice_boltzmann/arrays.h"
#include "validation.h"

namespace cohesion::lattice_boltzmann {

/// What a random array is made of.
struct RandomKind {
  double solid;                   ///< fraction of solid, [1]
  std::vector<double> diameters;  ///< of the spheres, in any unit
  std::uint64_t seed;
  double collisions = 100.0;  ///< of a sphere, in the mean, after it has its size
};

/// Elastic hard spheres in a cubic box of edge 1: put at random places while they are small, grown
/// in the rests between their collisions, and mixed by collisions at their size. What stands still
/// of it is a random array of an equilibrium fluid; above a fraction of 0.494 of equal spheres it
/// is the denser fluid that has not frozen yet, if it has not.
class HardSphereFluid {
 public:
  explicit HardSphereFluid(const RandomKind& kind) : solid_(kind.solid), random_(kind.seed) {
    const double largest = *std::max_element(kind.diameters.begin(), kind.diameters.end());
    double cubes = 0.0;
    for (const double d : kind.diameters) cubes += d * d * d;
    const double scale = std::cbrt(6.0 * kind.solid / (pi * cubes));
    require(largest * scale < 0.5, "diameter of the largest sphere over the edge of the box",
            largest * scale, "must be below 1/2: take more spheres");
    for (const double d : kind.diameters) radii_.push_back(0.5 * scale * d);
    size_ = std::min(1.0, std::cbrt(loose / kind.solid));
    place();
    while (size_ < 1.0) {
      collide(5.0);
      grow();
    }
    collide(kind.collisions);
  }

  const std::vector<double>& radii() const { return radii_; }
  const std::vector<Vector3>& places() const { return places_; }

 private:
  /// Fraction to which spheres are put one after the other; beyond 0.38 there is no room so.
  static constexpr double loose = 0.2;
  /// Of a sphere on its way through a small part of the box: with more of them nothing has room.
  static constexpr int most_events = 10000;

  int count() const { return static_cast<int>(radii_.size()); }
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  static double nearest(double d) { return d - std::round(d); }

  double distance(const Vector3& a, const Vector3& b) const {
    return std::hypot(nearest(a.x - b.x), nearest(a.y - b.y), nearest(a.z - b.z));
  }

  void place() {
    std::vector<int> order(radii_.size());
    for (int i = 0; i < count(); i++) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [this](int a, int b) { return radii_[a] > radii_[b]; });
    places_.resize(radii_.size());
    for (int n = 0; n < count(); n++) {
      const int i = order[n];
      const auto is_free = [&] {
        for (int m = 0; m < n; m++)
          if (distance(places_[i], places_[order[m]]) < size_ * (radii_[i] + radii_[order[m]]))
            return false;
        return true;
      };
      do places_[i] = {uniform(), uniform(), uniform()};
      while (!is_free());
    }
  }

  /// As far as the nearest pair lets all of them grow.
  void grow() {
    double room = std::numeric_limits<double>::max();
    for (int i = 0; i < count(); i++)
      for (int j = 0; j < i; j++)
        room = std::min(room, distance(places_[i], places_[j]) / (radii_[i] + radii_[j]));
    // Not to the last digit, for whom touches to be outside.
    size_ = std::min(1.0, size_ + 0.999 * (room - size_));
  }

  /// Until spheres have had so many collisions in the mean.
  void collide(double each) {
    using namespace hard_sphere;
    EventSimulation simulation;
    simulation.pairs.set(0, 0, HardContactParameters{});
    simulation.rules.collapse_limit = 0;
    simulation.rules.event_limit = most_events;
    for (int i = 0; i < count(); i++) {
      HardSphere body;
      body.tag = i + 1;
      body.radius = size_ * radii_[i];
      body.inverse_mass = 1.0 / (radii_[i] * radii_[i] * radii_[i]);
      body.inverse_inertia = 2.5 * body.inverse_mass / (body.radius * body.radius);
      VersionedFlight flight;
      flight.position = places_[i];
      // Of the same energy in the mean, in a cube of velocities.
      const double speed = std::sqrt(body.inverse_mass);
      flight.velocity = 2.0 * speed * Vector3{uniform() - 0.5, uniform() - 0.5, uniform() - 0.5};
      simulation.bodies.push_back(body);
      simulation.flights.push_back(flight);
    }
    simulation.neighbour_lists().bodies_in_box = count();
    PeriodicBox box;
    box.edges.xx = box.edges.yy = box.edges.zz = 1.0;
    box.periodic = {true, true, true};
    simulation.reset_time(box);
    simulation.set_up(never, {});
    const double time = 1.0 / fastest(simulation);
    for (double collisions = 0.0; collisions < 0.5 * each * count();) {
      simulation.begin_step(time / count());
      simulation.run(simulation.end());
      require(
          simulation.overrun().first < 0, "fraction of solid", solid_,
          "is not reached: these spheres have jammed before; take another seed, or more of them");
      collisions += static_cast<double>(simulation.events.size());
    }
    for (int i = 0; i < count(); i++) {
      const Vector3 at = simulation.flights[i].at(simulation.end());
      places_[i] = {at.x - std::floor(at.x), at.y - std::floor(at.y), at.z - std::floor(at.z)};
    }
  }

  static double fastest(const hard_sphere::EventSimulation& simulation) {
    double squares = 0.0;
    for (const hard_sphere::VersionedFlight& flight : simulation.flights)
      squares = std::max(squares, dot(flight.velocity, flight.velocity));
    return std::sqrt(squares);
  }

  double solid_;  // at last
  std::mt19937_64 random_;
  std::vector<double> radii_;  // at last
  std::vector<Vector3> places_;
  double size_;  // over that at last
};

/// A random array of spheres whose Sauter mean is as near to `diameter` spacings as a whole number
/// of nodes lets it. Throws InvalidParameter unless 0 < solid <= 0.62, diameters are positive, a
/// sphere is smaller than half the box, the smallest one has four spacings or more, and they do not
/// jam.
inline Array random_array(const RandomKind& kind, double diameter) {
  require(kind.solid > 0.0 && kind.solid <= 0.62, "fraction of solid", kind.solid,
          "of a random array must be above 0 and at most 0.62: denser ones jam while they grow");
  require(!kind.diameters.empty(), "number of spheres", 0.0, "must be 1 or more");
  double squares = 0.0, cubes = 0.0;
  for (const double d : kind.diameters) {
    require_positive("diameter of a sphere", d);
    squares += d * d;
    cubes += d * d * d;
  }
  const double edge_over_mean = std::cbrt(pi * cubes / (6.0 * kind.solid)) * squares / cubes;
  const int edge = static_cast<int>(std::lround(diameter * edge_over_mean));
  const HardSphereFluid fluid(kind);
  Array array{{edge, edge, edge}, {}};
  for (std::size_t i = 0; i < kind.diameters.size(); i++) {
    const Vector3& at = fluid.places()[i];
    const double radius = edge * fluid.radii()[i];
    require(radius >= 2.0, "diameter of a sphere in spacings", 2.0 * radius, "must be 4 or more");
    array.spheres.push_back({{edge * at.x, edge * at.y, edge * at.z}, radius});
  }
  return array;
}

}  // namespace cohesion::lattice_boltzmann
