// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "hard_sphere/box_of_spheres.h"
#include "hard_sphere/event_simulation.h"

// The rule of rest: spheres that come to rest under gravity.
namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

constexpr double gravity = 1.0, dt = 0.01;

/// Spheres of diameter 1 and mass 1 above a floor at y = 0, with gravity along -y; walls at x = 0
/// and x = `width` if that is above 0.
struct SettlingBed {
  EventSimulation simulation;
  std::map<std::pair<int, int>, double> impulse;  // by contact, in this step
  std::map<std::pair<int, int>, int> collisions;
  double dissipated = 0.0, added = 0.0, floor_impulse = 0.0, fastest = 0.0;
  int rest_rule_collisions = 0, most_events = 0;

  SettlingBed(const std::vector<Vector3>& positions, const ImpactLaw& law, double width = 0.0) {
    simulation.pairs.set(0, 0, contact(law));
    simulation.walls = {{{{Wall::y_plane, 1.0, 0.0}, {}}, {{law}}}};
    if (width > 0.0) {
      simulation.walls.push_back({{{Wall::x_plane, 1.0, 0.0}, {}}, {{law}}});
      simulation.walls.push_back({{{Wall::x_plane, -1.0, width}, {}}, {{law}}});
    }
    Vector3 high{width + 1.0, 1.0, 1.0};
    for (const Vector3& position : positions) {
      HardSphere body;
      body.tag = static_cast<int>(simulation.bodies.size()) + 1;
      body.radius = 0.5;
      body.inverse_mass = 1.0;
      body.inverse_inertia = 10.0;
      simulation.bodies.push_back(body);
      VersionedFlight flight;
      flight.position = position;
      simulation.flights.push_back(flight);
      high.y = std::max(high.y, position.y + 1.0);
    }
    simulation.neighbour_lists().bodies_in_box = static_cast<double>(positions.size());
    simulation.reset_time(closed_box({-1.0, 0.0, -1.0}, high));
    simulation.set_up(never, {});
  }

  double height() const {
    double sum = 0.0;
    for (const VersionedFlight& flight : simulation.flights) sum += flight.at(simulation.end()).y;
    return sum;
  }
  double kinetic_energy() const { return kinetic_energy_of(simulation); }

  /// A step of an engine: velocity increments, flights and events.
  void step() {
    simulation.begin_step(dt);
    const int count = static_cast<int>(simulation.bodies.size());
    for (int n = 0; n < count; n++) {
      HardSphere& body = simulation.bodies[n];
      increment_velocity(simulation, n, {0.0, -gravity * dt, 0.0});
      body.speed_increment = speed_increment({0.0, -gravity, 0.0}, body.inverse_mass, dt);
    }
    for (int n = 0; n < count; n++) simulation.predict(n);
    simulation.run(simulation.end());
    count_events();
  }

  void count_events() {
    impulse.clear(), collisions.clear();
    for (const Event& event : simulation.events) {
      impulse[{event.i, event.j}] += event.impact.normal_impulse;
      collisions[{event.i, event.j}]++;
      dissipated -= event.impact.energy_change;
      added += event.impact.rest_rule_energy;
      rest_rule_collisions += event.impact.rest_rule_energy > 0.0;
      if (event.j == -1) floor_impulse += event.impact.normal_impulse;
    }
    for (std::size_t n = 0; n < simulation.bodies.size(); n++) {
      most_events = std::max(most_events, simulation.state_in_step(static_cast<int>(n)).events);
      fastest = std::max(fastest, norm(simulation.flights[n].velocity));
    }
  }

  /// Fails if a contact had more collisions in the last step than its impulse allows. The reduced
  /// mass of two spheres is 1/2, of a sphere and a wall 1.
  void expect_bounded() const {
    for (const auto& [contact, number] : collisions) {
      const double increment =
          simulation.rules.rest_factor * gravity * dt * (contact.second < 0 ? 1.0 : 0.5);
      const double most = 1.0 + std::pow(1.5 * impulse.at(contact) / increment, 2.0 / 3.0);
      EXPECT_LE(number, most * (1.0 + 1e-12));
    }
  }
};

std::vector<Vector3> column(int count, double gap) {
  std::vector<Vector3> positions;
  for (int n = 0; n < count; n++) positions.push_back({0.0, 0.5 + gap + n * (1.0 + gap), 0.0});
  return positions;
}

/// A row that fills the width from wall to wall when it is flat; every second sphere is raised.
std::vector<Vector3> row_that_just_fits(int count, double raised) {
  std::vector<Vector3> positions;
  const double step = std::sqrt(1.0 - raised * raised), left = 0.5 * (count - 1) * (1.0 - step);
  for (int n = 0; n < count; n++)
    positions.push_back({0.5 + left + n * step, 0.5 + n % 2 * raised, 0.0});
  return positions;
}

// All bounces from the height h last sqrt(2 h/g) (1 + e)/(1 - e). The velocity increments of the
// steps add g dt at most from bounce to bounce, so that speeds do not stay above g dt/(1 - e). The
// least speed of the rule, g dt sqrt(n), is smaller up to 4 collisions in a step. The momentum from
// the floor balances that from gravity.
TEST(Rest, SphereBouncesToRestOnAFloor) {
  const double e = 0.5, h = 2.0, speed = gravity * dt / (1.0 - e);
  SettlingBed bed(column(1, h), {e, 0.0, 0.0});
  const double rest = std::sqrt(2.0 * h / gravity) * (1.0 + e) / (1.0 - e);
  const int steps = static_cast<int>(std::ceil(rest / dt));
  for (int n = 0; n < steps; n++) bed.step();
  EXPECT_GT(bed.fastest, 1.9);
  bed.fastest = 0.0;
  for (int n = 0; n < 1000; n++) {
    bed.step();
    EXPECT_LT(bed.height() - 0.5, speed * dt + 0.5 * speed * speed / gravity);
  }
  EXPECT_LT(bed.fastest, speed);
  EXPECT_LE(bed.most_events, 4);
  EXPECT_NEAR(bed.floor_impulse,
              gravity * dt * (steps + 1000) + bed.simulation.flights[0].velocity.y, 1e-11);
}

TEST(Rest, FirstCollisionOfAStepAndElasticSpheresAreUnchanged) {
  for (const double e : {0.3, 1.0}) {
    SettlingBed bed(column(5, 0.1), {e, 0.0, 0.0});
    for (int n = 0; n < 1000; n++) {
      bed.step();
      std::vector<int> seen(5, 0);
      for (const Event& event : bed.simulation.events) {
        const bool alone = event.with_wall() || seen[event.j] == 0;
        if (e == 1.0 || (seen[event.i] == 0 && alone)) {
          EXPECT_EQ(event.impact.rest_rule_energy, 0.0);
        }
        seen[event.i]++;
        if (!event.with_wall()) seen[event.j]++;
      }
    }
    EXPECT_EQ(bed.rest_rule_collisions > 100, e < 1.0);
  }
}

TEST(Rest, AddsNoEnergyWithoutForces) {
  SettlingBed bed(column(5, 0.1), {0.1, 0.3, 0.0});
  bed.simulation.begin_step(2.0);
  for (int n = 0; n < 5; n++) {
    increment_velocity(bed.simulation, n, {0.0, -1.0, 0.0});
    HardSphere& body = bed.simulation.bodies[n];
    body.speed_increment = speed_increment({}, body.inverse_mass, 2.0);
  }
  for (int n = 0; n < 5; n++) bed.simulation.predict(n);
  bed.simulation.run(bed.simulation.end());
  bed.count_events();
  EXPECT_GT(bed.simulation.events.size(), 20u);
  EXPECT_EQ(bed.rest_rule_collisions, 0);
}

// Energy balance: the kinetic energy decreases by the dissipation of collisions minus the energy
// added by the rule, to round-off.
TEST(Rest, ColumnsComeToRestWithBoundedCollisions) {
  for (const int count : {5, 40}) {
    SettlingBed bed(column(count, 0.01), {0.9, 0.0, 0.0});
    bed.simulation.rules.collapse_limit = 0;
    for (int n = 0; n < 1000; n++) {
      const double before = bed.kinetic_energy(), dissipated = bed.dissipated;
      double gravity_energy = 0.0;  // in this step
      for (const VersionedFlight& flight : bed.simulation.flights)
        gravity_energy += gravity * dt * (0.5 * gravity * dt - flight.velocity.y);
      bed.step();
      bed.expect_bounded();
      EXPECT_NEAR(bed.kinetic_energy() + (bed.dissipated - dissipated), before + gravity_energy,
                  1e-12);
    }
    ASSERT_LT(bed.simulation.overrun().first, 0);
    EXPECT_GT(bed.added, 0.0);
    // The largest speed of the rule, in collisions at the floor, which transmit the weight of all
    // spheres, for a sphere with two contacts; and the gaps due to it.
    const EventRules& rules = bed.simulation.rules;
    const double most = 1.0 + std::pow(1.5 * count / (0.5 * rules.rest_factor), 2.0 / 3.0);
    const double speed = rules.rest_factor * gravity * dt * std::sqrt(2.0 * most);
    EXPECT_LT(bed.kinetic_energy(), 0.5 * count * speed * speed);
    EXPECT_LT(bed.height() - 0.5 * count * count, 0.5 * count * (count + 1) * speed * dt);
  }
}

// The flatter the row, the larger the force of its weight on the walls, and the flat row has no
// clearance. Without the rule the number of collisions is infinite when the clearance has decreased
// to round-off. Which rows reach that in the run is random, since each collision amplifies
// round-off.
TEST(Rest, RowThatJustFitsBetweenTwoWallsStays) {
  int endless_without_rule = 0;
  for (const int count : {5, 7, 9, 12}) {
    for (const bool with_rule : {false, true}) {
      SettlingBed bed(row_that_just_fits(count, 0.05), {0.9, 0.3, 0.0}, count);
      bed.simulation.rules.event_limit = 5000;
      if (!with_rule) bed.simulation.rules.rest_factor = 0.0;
      for (int n = 0; n < 1000 && bed.simulation.overrun().first < 0; n++) {
        bed.step();
        if (with_rule) bed.expect_bounded();
      }
      if (with_rule) {
        EXPECT_LT(bed.simulation.overrun().first, 0);
      } else {
        endless_without_rule += bed.simulation.overrun().first >= 0;
      }
      EXPECT_LT(bed.height(), count * (0.5 + 0.05));
      EXPECT_GE(bed.height(), count * 0.5 - 1e-12);
    }
  }
  EXPECT_GT(endless_without_rule, 0);
}

}  // namespace
