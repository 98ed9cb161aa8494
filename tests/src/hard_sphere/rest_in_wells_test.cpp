// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "hard_sphere/box_of_spheres.h"
#include "hard_sphere/event_simulation.h"

// The rule of rest in clusters that are bound by wells.
namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

constexpr double depth = 1.0;

/// Spheres of diameter 1 and mass 1 about the origin, in a wide periodic box.
struct Cluster {
  EventSimulation simulation;
  int most_events = 0;
  double most_added = 0.0;   // energy that one collision adds
  double most_beyond = 0.0;  // distance of a pair beyond the edge at an event
  double edge = 1.01;

  /// `velocity`: function of the position.
  template <class Velocity>
  Cluster(const std::vector<Vector3>& positions, Velocity velocity) {
    for (const Vector3& position : positions) {
      HardSphere body;
      body.tag = static_cast<int>(simulation.bodies.size()) + 1;
      body.radius = 0.5;
      body.inverse_mass = 1.0;
      body.inverse_inertia = 10.0;
      simulation.bodies.push_back(body);
      VersionedFlight flight;
      flight.position = position;
      flight.velocity = velocity(position);
      simulation.flights.push_back(flight);
    }
    simulation.rules.collapse_limit = 0;
  }

  void start(const ImpactLaw& law, double ratio) {
    edge = ratio;
    simulation.pairs.set(0, 0, contact(law, ratio));
    start();
  }
  void start() {
    simulation.neighbour_lists().bodies_in_box = static_cast<double>(simulation.bodies.size());
    PeriodicBox box = closed_box({-50.0, -50.0, -50.0}, {50.0, 50.0, 50.0});
    box.periodic = {true, true, true};
    simulation.reset_time(box);
    simulation.set_up(never, {});
  }

  /// Runs until the limit of events; returns whether it was not reached.
  bool run(int steps, double dt) {
    for (int n = 0; n < steps && simulation.overrun().first < 0; n++) {
      simulation.begin_step(dt);
      simulation.run(simulation.end());
      for (const Event& event : simulation.events)
        if (event.impact.kind == EventKind::collision)
          most_added = std::max(most_added, event.impact.energy_change);
        else
          most_beyond = std::max(most_beyond, event.distance - edge);
      for (std::size_t i = 0; i < simulation.bodies.size(); i++)
        most_events = std::max(most_events, simulation.state_in_step(static_cast<int>(i)).events);
      simulation.shift_time_origin();
    }
    return simulation.overrun().first < 0;
  }

  int bonds() const {
    int count = 0;
    simulation.for_each_pair([&count](int, const Neighbour& n) { count += n.inside; });
    return count;
  }
  Vector3 momentum() const {
    Vector3 sum;
    for (const VersionedFlight& flight : simulation.flights) sum += flight.velocity;
    return sum;
  }
  /// About the origin.
  Vector3 angular_momentum() const {
    Vector3 sum;
    for (std::size_t n = 0; n < simulation.flights.size(); n++) {
      const VersionedFlight& flight = simulation.flights[n];
      sum += cross(flight.at(simulation.end()), flight.velocity) +
             (1.0 / simulation.bodies[n].inverse_inertia) * simulation.bodies[n].event_state.spin;
    }
    return sum;
  }
  /// About the centre of mass.
  Vector3 angular_momentum_within() const {
    Vector3 positions;
    for (const VersionedFlight& flight : simulation.flights)
      positions += flight.at(simulation.end());
    return angular_momentum() -
           cross((1.0 / static_cast<double>(simulation.flights.size())) * positions, momentum());
  }
  double spin_energy() const {
    double sum = 0.0;
    for (const HardSphere& body : simulation.bodies)
      sum += 0.5 * dot(body.event_state.spin, body.event_state.spin) / body.inverse_inertia;
    return sum;
  }
};

/// Pairs in the middle of their wells.
std::vector<Vector3> triangle(double ratio) {
  const double side = 0.5 * (1.0 + ratio), high = std::sqrt(0.75) * side;
  return {{-0.5 * side, -high / 3.0, 0.0}, {0.5 * side, -high / 3.0, 0.0}, {0.0, high / 1.5, 0.0}};
}

/// A sphere and its twelve neighbours in a close packing.
std::vector<Vector3> thirteen(double distance) {
  std::vector<Vector3> positions{{}};
  const double a = distance / std::sqrt(2.0);
  for (const double x : {-a, a})
    for (const double y : {-a, a}) {
      positions.push_back({x, y, 0.0});
      positions.push_back({x, 0.0, y});
      positions.push_back({0.0, x, y});
    }
  return positions;
}

/// Rotation about a random axis with small random velocities.
auto tumbling(unsigned seed) {
  return [random = std::mt19937(seed), turn = Vector3{}](const Vector3& x) mutable {
    std::normal_distribution<double> normal;
    const auto any = [&] { return Vector3{normal(random), normal(random), normal(random)}; };
    if (same(turn, {})) turn = 0.5 * any();
    return cross(turn, x) + 0.1 * any();
  };
}

void expect_conserved(Cluster& cluster, const Vector3& momentum, const Vector3& turning) {
  // Up to the round-off of K^2/2, 1e-6 of the depth in the first collisions of a step.
  EXPECT_LT(cluster.most_added, 1e-17);
  EXPECT_NEAR(norm(cluster.momentum() - momentum), 0.0, 1e-12);
  // Each rotation of a velocity at a capture changes it by 1e-6 of the width, 1e-2 at most here, of
  // the momenta.
  EXPECT_NEAR(norm(cluster.angular_momentum() - turning), 0.0, 1e-5);
}

// Without the rule some speeds tend to 0, and the number of events in a step is infinite.
// Nevertheless the pairs stay in their wells, to round-off: their speeds at the edges do not
// decrease below 1e-8 of the others.
TEST(RestInWells, TumblingTriplesHaveFinitelyManyEvents) {
  int endless_without_rule = 0;
  for (const double e : {0.1, 0.8})
    for (const double ratio : {1.001, 1.01, 1.1})
      for (const unsigned seed : {1, 2, 3, 4, 5})
        for (const bool with_rule : {true, false}) {
          Cluster three(triangle(ratio), tumbling(seed));
          const Vector3 momentum = three.momentum(), turning = three.angular_momentum();
          three.simulation.rules.event_limit = 5000;
          if (!with_rule) three.simulation.rules.rest_factor = 0.0;
          three.start({e, 0.0, depth}, ratio);
          const bool ends = three.run(100, 1.0);
          endless_without_rule += !ends && !with_rule;
          EXPECT_LT(three.most_beyond, 1e-12);
          if (!with_rule) continue;
          EXPECT_TRUE(ends) << e << " " << ratio << " " << seed;
          expect_conserved(three, momentum, turning);
        }
  EXPECT_GT(endless_without_rule, 3);
}

// A triple dissipates energy until its cores do not collide any more. With its angular momentum L
// it then rotates about its normal, with all pairs between core and edge. The moment of inertia of
// three spheres at the distance d is d^2. So the least kinetic energy is L^2/(2 d^2) at the edges;
// with that at the cores, L^2/2, they could still collide.
TEST(RestInWells, TripleFinallyRotatesAboutItsNormal) {
  const double ratio = 1.01;
  for (const double e : {0.1, 0.5}) {
    Cluster three(triangle(ratio), tumbling(1));
    three.start({e, 0.0, depth}, ratio);
    const Vector3 momentum = three.momentum();
    const auto inner = [&] {
      return kinetic_energy_of(three.simulation) - dot(momentum, momentum) / 6.0;
    };
    const double turning = norm(three.angular_momentum_within());
    EXPECT_GT(inner(), 1.2 * 0.5 * turning * turning);
    ASSERT_TRUE(three.run(20000, 1.0));
    EXPECT_EQ(three.bonds(), 3);
    EXPECT_GE(inner(), 0.5 * turning * turning / (ratio * ratio) * (1.0 - 1e-9));
    EXPECT_LE(inner(), 0.5 * turning * turning);
  }
}

// Friction dissipates the spins, and the rule limits its effect on speeds below K.
TEST(RestInWells, SpinningClustersWithFrictionHaveFinitelyManyEvents) {
  for (const double friction : {0.1, 1.0})
    for (const double e : {0.3, 1.0}) {
      Cluster many(thirteen(1.005), tumbling(7));
      for (HardSphere& body : many.simulation.bodies)
        body.event_state.spin = {1.0, -2.0, 0.3 * body.tag};
      const Vector3 momentum = many.momentum(), turning = many.angular_momentum();
      many.start({e, friction, depth}, 1.01);
      const double spins = many.spin_energy();
      EXPECT_TRUE(many.run(50, 1.0)) << friction << " " << e;
      expect_conserved(many, momentum, turning);
      EXPECT_LT(many.spin_energy(), 0.5 * spins);
    }
}

// A sphere without attraction is pressed onto the twelve around it, which attract each other.
TEST(RestInWells, SphereWithoutAWellInACageHasFinitelyManyEvents) {
  int endless_without_rule = 0;
  for (const unsigned seed : {1, 2, 3})
    for (const bool with_rule : {true, false}) {
      Cluster cage(thirteen(1.005), tumbling(seed));
      if (!with_rule) cage.simulation.rules.rest_factor = 0.0;
      cage.simulation.rules.event_limit = 5000;
      cage.simulation.bodies[0].material = 1;
      cage.simulation.pairs = PairRules(2);
      cage.simulation.pairs.set(0, 0, contact({1.0, 0.0, depth}, 1.01));
      cage.simulation.pairs.set(0, 1, contact({0.5, 0.0, 0.0}));
      cage.start();
      const bool ends = cage.run(30, 1.0);
      EXPECT_TRUE(ends || !with_rule) << seed;
      endless_without_rule += !ends;
    }
  EXPECT_GT(endless_without_rule, 0);
}

}  // namespace
