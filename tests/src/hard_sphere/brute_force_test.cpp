// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

#include "hard_sphere/event_simulation.h"
#include "hard_sphere/gas_of_spheres.h"

// Comparison with a simulation without lists and stored predictions: before each event it searches
// all pairs, images and walls for the first crossing.
namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

class BruteForce {
 public:
  BruteForce(const EventSimulation& simulation, const PeriodicBox& box)
      : box_(box),
        bodies_(simulation.bodies),
        flights(simulation.flights),
        pairs_(simulation.pairs),
        walls_(simulation.walls) {
    for (int i = 0; i < count(); i++) {
      for (const int j : with_higher_tags(i))
        for_each_image(box_, 0.0, flights[j].position - flights[i].position, 1,
                       [&](const Vector3& boxes, const Vector3& r) {
                         const SurfaceDistances surfaces = pairs_.surfaces(bodies_[i], bodies_[j]);
                         if (surfaces.has_well() && norm(r) < surfaces.edge)
                           inside_[key(i, j, boxes)] = true;
                       });
      for (int w = 0; w < static_cast<int>(walls_.size()); w++) {
        const SurfaceDistances surfaces = walls_[w].surfaces(bodies_[i]);
        const MovingWall& wall = walls_[w].motion;
        if (surfaces.has_well() &&
            wall.wall.nearest(flights[i].position, wall.at(0.0), 0.0).distance < surfaces.edge)
          inside_[key(i, -1 - w, {})] = true;
      }
    }
  }

  /// Executes the next event.
  Event advance() {
    Next next;
    for (int i = 0; i < count(); i++) {
      for (const int j : with_higher_tags(i)) {
        if (bodies_[i].inverse_mass + bodies_[j].inverse_mass == 0.0) continue;
        // Images within two boxes now come first, before those that are farther away now.
        for_each_image(box_, time_, flights[j].at(time_) - flights[i].at(time_), 1,
                       [&](const Vector3& boxes, const Vector3&) { test_pair(i, j, boxes, next); });
      }
      for (int w = 0; w < static_cast<int>(walls_.size()); w++) test_wall(i, w, next);
    }
    return execute(next);
  }

 private:
  using Key = std::tuple<int, int, int, int, int>;
  struct Next {
    EventKey key{never, 0, 0, 0};
    int i = 0, j = 0;  // i has the lower tag
    Vector3 boxes;
    Surface surface = Surface::core;
  };

  int count() const { return static_cast<int>(bodies_.size()); }
  std::vector<int> with_higher_tags(int i) const {
    std::vector<int> all;
    for (int j = 0; j < count(); j++)
      if (bodies_[j].tag > bodies_[i].tag) all.push_back(j);
    return all;
  }
  static Key key(int i, int j, const Vector3& boxes) {
    return {i, j, int(boxes.x), int(boxes.y), int(boxes.z)};
  }

  std::array<Vector3, 2> relative_motion(int i, int j, const Vector3& boxes, double time) const {
    Vector3 r = flights[j].at(time) - flights[i].at(time);
    Vector3 w = flights[j].velocity - flights[i].velocity;
    r += box_.edges * boxes + time * (box_.rates * boxes);
    w += box_.rates * boxes;
    return {r, w};
  }

  bool is_inside(const Key& key) const {
    const auto found = inside_.find(key);
    return found != inside_.end() && found->second;
  }

  int depth(int i, double time) const {
    return flights[i].start_time == time ? bodies_[i].event_state.causal_depth : -1;
  }

  void test_pair(int i, int j, const Vector3& boxes, Next& next) const {
    const VersionedFlight &a = flights[i], &b = flights[j];
    const double now = std::max(a.start_time, b.start_time);
    const auto [r, w] = relative_motion(i, j, boxes, now);
    const double vv = std::max(dot(a.velocity, a.velocity), dot(b.velocity, b.velocity));
    const Crossing crossing = next_crossing(r, w, vv, pairs_.surfaces(bodies_[i], bodies_[j]),
                                            is_inside(key(i, j, boxes)));
    const double time = now + crossing.wait;
    const EventKey key{time, 1 + std::max(depth(i, time), depth(j, time)), bodies_[i].tag,
                       bodies_[j].tag};
    if (time < never && key < next.key) next = {key, i, j, boxes, crossing.surface};
  }

  void test_wall(int i, int w, Next& next) const {
    const VersionedFlight& a = flights[i];
    if (bodies_[i].inverse_mass == 0.0) return;
    const Crossing crossing =
        next_crossing(walls_[w].motion, a.position, a.velocity, a.start_time,
                      walls_[w].surfaces(bodies_[i]), is_inside(key(i, -1 - w, {})));
    const double time = a.start_time + crossing.wait;
    const EventKey key{time, 1 + depth(i, time), bodies_[i].tag, -1 - w};
    if (time < never && key < next.key) next = {key, i, -1 - w, {}, crossing.surface};
  }

  CollisionPartner partner(int i) const {
    const HardSphere& body = bodies_[i];
    return {flights[i].velocity, body.event_state.spin, body.inverse_mass, body.inverse_inertia,
            body.radius};
  }

  Event execute(const Next& next) {
    time_ = next.key.time;
    const int i = next.i, j = next.j;
    Event event{};
    event.key = next.key;
    event.i = i;
    event.j = j;
    bool& inside = inside_[key(i, j, next.boxes)];
    event.was_inside = inside;
    CollisionPartner other{};
    ImpactLaw law;
    if (j < 0) {
      const MovingWall& wall = walls_[-1 - j].motion;
      const auto point = wall.wall.nearest(flights[i].at(time_), wall.at(time_), wall.rim_speed);
      event.separation = point.separation;
      other = {point.velocity, {}, 0.0, 0.0, 0.0};
      law = walls_[-1 - j].law(bodies_[i]);
    } else {
      event.separation = relative_motion(i, j, next.boxes, time_)[0];
      other = partner(j);
      other.velocity += box_.rates * next.boxes;
      law = pairs_.law(bodies_[i], bodies_[j]);
    }
    const double distance = norm(event.separation);
    const Vector3& r = event.separation;
    const Vector3 k{r.x / distance, r.y / distance, r.z / distance};
    event.impact = compute_impact(next.surface, k, law, partner(i), other);
    inside = event.impact.inside;
    change(i, -1.0, event);
    if (j >= 0) change(j, 1.0, event);
    return event;
  }

  void change(int i, double side, const Event& event) {
    VersionedFlight& flight = flights[i];
    HardSphere& body = bodies_[i];
    flight.position = flight.at(time_);
    flight.velocity += (side * body.inverse_mass) * event.impact.impulse;
    flight.start_time = time_;
    body.event_state.spin -= (body.radius * body.inverse_inertia) * event.impact.spin_impulse;
    body.event_state.causal_depth = event.key.causal_depth;
  }

  PeriodicBox box_;
  std::vector<HardSphere> bodies_;

 public:
  std::vector<VersionedFlight> flights;

 private:
  PairRules pairs_;
  std::vector<HardWall> walls_;
  std::map<Key, bool> inside_;
  double time_ = 0.0;
};

/// Expects the same events in the same order, with the same impulses, to the last bit.
void expect_events_of_brute_force(EventSimulation& simulation, const PeriodicBox& box, double time,
                                  std::size_t at_least) {
  simulation.rules.collapse_limit = 0;
  simulation.reset_time(box);
  simulation.set_up(box.rates.is_zero() ? never : 0.3 * time, {});
  BruteForce reference(simulation, box);
  std::size_t events = 0;
  for (int n = 0; n < 20; n++) {
    simulation.begin_step(time / 20.0);
    simulation.run(simulation.end());
    for (const Event& event : simulation.events) {
      const Event expected = reference.advance();
      ASSERT_TRUE(same_bits(event, expected))
          << events << ": " << event.key.time << ' ' << event.key.causal_depth << ' '
          << event.key.tag_i << ' ' << event.key.tag_j << ", expected " << expected.key.time << ' '
          << expected.key.causal_depth << ' ' << expected.key.tag_i << ' ' << expected.key.tag_j;
      events++;
    }
  }
  for (std::size_t n = 0; n < simulation.flights.size(); n++)
    EXPECT_TRUE(same(simulation.flights[n], reference.flights[n]));
  // No event is missing at the end.
  EXPECT_GT(reference.advance().key.time, simulation.end());
  EXPECT_GT(events, at_least);
}

const ImpactLaw sticky{0.95, 0.2, 0.2};
const ImpactLaw rough{0.9, 0.3, 0.0};

class BruteForceWithMargin : public testing::TestWithParam<double> {
 protected:
  EventSimulation simulation;

  void SetUp() override { simulation.neighbour_lists().margin = GetParam(); }
};

INSTANTIATE_TEST_SUITE_P(All, BruteForceWithMargin, testing::Values(0.1, 0.6, 2.0));

TEST_P(BruteForceWithMargin, HasTheSameEventsInACube) {
  simulation.pairs.set(0, 0, contact(rough));
  const PeriodicBox box = periodic_box({4.0, 4.0, 4.0});
  GasOfSpheres{30}.fill(simulation, box);
  expect_events_of_brute_force(simulation, box, 25.0, 400);
}

TEST_P(BruteForceWithMargin, HasTheSameEventsWithWellsInATiltedBox) {
  simulation.pairs.set(0, 0, contact(sticky, 1.5));
  const PeriodicBox box = periodic_box({4.0, 3.7, 4.2, 1.6, -1.2, 1.9});
  GasOfSpheres{30, 0.3, 0.6}.fill(simulation, box);
  expect_events_of_brute_force(simulation, box, 4.0, 400);
}

TEST_P(BruteForceWithMargin, HasTheSameEventsUnderShear) {
  simulation.pairs.set(0, 0, contact(sticky, 1.5));
  PeriodicBox::Edges rates;
  rates.xy = 0.1 * 4.0;
  const PeriodicBox box = periodic_box({4.0, 4.0, 4.0}, rates);
  GasOfSpheres{30, 0.3, 0.6}.fill(simulation, box);
  expect_events_of_brute_force(simulation, box, 3.0, 400);
}

TEST_P(BruteForceWithMargin, HasTheSameEventsInADeformingBox) {
  simulation.pairs.set(0, 0, contact(sticky, 1.5));
  const PeriodicBox box =
      periodic_box({4.5, 4.2, 3.9, -0.6, 0.7, 1.3}, {0.2, -0.1, 0.05, 0.4, -0.3, -0.5});
  GasOfSpheres{30, 0.3, 0.6}.fill(simulation, box);
  expect_events_of_brute_force(simulation, box, 4.0, 400);
}

TEST_P(BruteForceWithMargin, HasTheSameEventsInASmallBox) {
  simulation.pairs.set(0, 0, contact(sticky, 1.4));
  const PeriodicBox box = periodic_box({2.1, 2.2, 2.3, 0.2, -0.4, 0.6}, {0, 0, 0, 0, 0, 0.1});
  GasOfSpheres{4}.fill(simulation, box);
  expect_events_of_brute_force(simulation, box, 30.0, 200);
}

TEST_P(BruteForceWithMargin, HasTheSameEventsOfSizesFromOneToTen) {
  simulation.pairs.set(0, 0, contact(sticky, 1.4));
  const PeriodicBox box = periodic_box({3.0, 3.2, 2.9, 0.0, 0.4, -0.3});
  GasOfSpheres{40, 0.1, 1.0}.fill(simulation, box);
  expect_events_of_brute_force(simulation, box, 0.5, 300);
}

TEST_P(BruteForceWithMargin, HasTheSameEventsBetweenMovingWalls) {
  simulation.pairs.set(0, 0, contact(sticky, 1.4));
  PeriodicBox box = periodic_box({4.0, 4.0, 5.0, 0.0, 0.0, 0.0});
  box.periodic[2] = false;
  const HardWall::WallContact rule{sticky, 1.4};
  const WallState rising{{0.0, 0.0, 0.1}, {0.2, 0.0, 0.05}}, still{};
  simulation.walls.push_back(
      {{{Wall::z_plane, 1.0, box.origin.z - 0.1}, rising}, {rule}, -1, true});
  simulation.walls.push_back({{{Wall::z_plane, -1.0, box.origin.z + 5.0}, still}, {rule}});
  GasOfSpheres{25, 0.3, 0.6}.fill(simulation, box);
  expect_events_of_brute_force(simulation, box, 8.0, 400);
}

// Bounding neighbourhoods move towards a wall at rest.
TEST_P(BruteForceWithMargin, HasTheSameEventsBetweenWallsAcrossTheFlow) {
  simulation.pairs.set(0, 0, contact(sticky, 1.4));
  PeriodicBox::Edges rates;
  rates.xy = 4.0;
  PeriodicBox box = periodic_box({5.0, 4.0, 4.0}, rates);
  box.periodic[0] = false;
  const HardWall::WallContact rule{sticky, 1.4};
  simulation.walls.push_back({{{Wall::x_plane, 1.0, box.origin.x}, {}}, {rule}});
  simulation.walls.push_back({{{Wall::x_plane, -1.0, box.origin.x + 5.0}, {}}, {rule}});
  GasOfSpheres{25, 0.3, 0.6, 0.1}.fill(simulation, box);
  expect_events_of_brute_force(simulation, box, 2.0, 100);
}

TEST_P(BruteForceWithMargin, HasTheSameEventsWithImmobileSpheres) {
  simulation.pairs.set(0, 0, contact(sticky, 1.4));
  const PeriodicBox box = periodic_box({4.0, 4.0, 4.0});
  GasOfSpheres{30}.fill(simulation, box);
  for (std::size_t n = 0; n < simulation.bodies.size(); n += 2) {
    simulation.bodies[n].inverse_mass = simulation.bodies[n].inverse_inertia = 0.0;
    simulation.flights[n].velocity = n % 4 ? Vector3{} : Vector3{0.0, 0.0, 0.1};
  }
  expect_events_of_brute_force(simulation, box, 8.0, 300);
}

// Rows of equal spheres on lines, whose positions and velocities are small multiples of powers of
// two, some of them in contact: many events occur at the same instant, and chains of events pass
// through several spheres at once. Tags are in random order. With a margin of 1/2 neighbourhoods
// touch each other exactly.
TEST(BruteForce, HasTheSameEventsOfOneInstant) {
  for (const double margin : {0.5, 0.6})
    for (const unsigned seed : {1, 2, 3, 4}) {
      EventSimulation rows;
      rows.neighbour_lists().margin = margin;
      rows.pairs.set(0, 0, contact(ImpactLaw{}));
      const PeriodicBox box = periodic_box({16.0, 4.0, 4.0});
      std::mt19937 random(seed);
      std::vector<int> tags(36);
      std::iota(tags.begin(), tags.end(), 1);
      std::shuffle(tags.begin(), tags.end(), random);
      for (int n = 0; n < 36; n++) {
        const int row = n / 9, in_row = n % 9;
        HardSphere body;
        body.tag = tags[n];
        body.radius = 0.5;
        body.inverse_mass = 1.0;
        rows.bodies.push_back(body);
        VersionedFlight flight;
        const double last = in_row > 0 ? rows.flights.back().position.x + 1.0 : 0.0;
        flight.position = {last + static_cast<double>(random() % 3) / 4.0, 2.0 * (row % 2),
                           2.0 * (row / 2)};
        flight.velocity = {static_cast<double>(random() % 5) - 2.0, 0.0, 0.0};
        rows.flights.push_back(flight);
      }
      rows.neighbour_lists().bodies_in_box = 36.0;
      expect_events_of_brute_force(rows, box, 8.0, 200);
      if (HasFatalFailure()) return;
    }
}

}  // namespace
