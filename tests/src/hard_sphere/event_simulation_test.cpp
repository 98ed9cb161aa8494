// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/event_simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "hard_sphere/box_of_spheres.h"

namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

const ImpactLaw elastic{1.0, 0.0, 0.3};
const ImpactLaw rough{0.9, 0.3, 0.3};

double changes(const std::vector<Event>& events) {
  return std::accumulate(events.begin(), events.end(), 0.0,
                         [](double sum, const Event& e) { return sum + e.impact.energy_change; });
}

// Each event rounds energies of order 1 by a few 1e-16.
TEST(EventSimulation, EnergyBalances) {
  for (const ImpactLaw& law : {elastic, rough}) {
    BoxOfSpheres box(3, law);
    const double before = box.kinetic_energy();
    for (int n = 0; n < 200; n++) box.step(0.05);
    ASSERT_GT(box.all.size(), 1000u);
    EXPECT_NEAR(box.kinetic_energy() - before, changes(box.all), 2e-15 * box.all.size());
  }
}

TEST(EventSimulation, NoCoresOverlapAndNoSphereLeavesTheBox) {
  BoxOfSpheres box(3, rough);
  EventSimulation& simulation = box.simulation;
  const int count = static_cast<int>(simulation.bodies.size());
  const auto expect_apart = [&](int i, int partner, double distance,
                                const SurfaceDistances& surfaces) {
    EXPECT_GT(distance, surfaces.core - 1e-13);
    const Neighbour* pair = simulation.neighbour_lists().find_neighbour(i, partner, 0);
    const bool inside = pair && pair->inside;
    EXPECT_LT(distance, inside ? surfaces.edge + 1e-13 : never);
    EXPECT_GT(distance, inside ? 0.0 : surfaces.edge - 1e-13);
  };
  for (int n = 0; n < 100; n++) {
    box.step(0.1);
    for (int i = 0; i < count; i++) {
      const HardSphere& body = simulation.bodies[i];
      for (int j = 0; j < count; j++)
        if (j != i)
          expect_apart(i, j, norm(box.position(j) - box.position(i)),
                       simulation.pairs.surfaces(body, simulation.bodies[j]));
      for (int w = 0; w < 6; w++) {
        const HardWall& wall = simulation.walls[w];
        expect_apart(i, -1 - w, wall.motion.wall.nearest(box.position(i), {}, 0.0).distance,
                     wall.surfaces(body));
      }
    }
  }
}

// The step is no physical parameter, and flights do not depend on it: the same events to the last
// bit, if no rule depends on the step.
TEST(EventSimulation, EventsAreIndependentOfTheStep) {
  for (const ImpactLaw& law : {elastic, rough}) {
    BoxOfSpheres fine(3, law), coarse(3, law);
    for (BoxOfSpheres* box : {&fine, &coarse}) box->simulation.rules.collapse_limit = 0;
    for (int n = 0; n < 1024; n++) fine.step(1.0 / 256.0);
    for (int n = 0; n < 2; n++) coarse.step(2.0);
    ASSERT_GT(coarse.all.size(), 100u);
    ASSERT_EQ(fine.all.size(), coarse.all.size());
    for (std::size_t n = 0; n < fine.all.size(); n++)
      EXPECT_TRUE(same_bits(fine.all[n], coarse.all[n])) << n;
    for (std::size_t n = 0; n < fine.simulation.bodies.size(); n++) {
      const Vector3 a = fine.position(n), b = coarse.position(n);
      EXPECT_EQ(a.x, b.x);
      EXPECT_EQ(a.y, b.y);
      EXPECT_EQ(a.z, b.z);
      EXPECT_TRUE(same(fine.simulation.flights[n], coarse.simulation.flights[n]));
      EXPECT_TRUE(same(fine.simulation.bodies[n].event_state.spin,
                       coarse.simulation.bodies[n].event_state.spin));
    }
  }
}

TEST(EventSimulation, EventsAreInOrder) {
  BoxOfSpheres box(3, rough);
  box.step(2.0);
  for (std::size_t n = 1; n < box.simulation.events.size(); n++)
    EXPECT_FALSE(box.simulation.events[n].key < box.simulation.events[n - 1].key);
}

// A row of five spheres, each a neighbour of the adjacent ones only: 1 is fast, 2 to 4 are at rest,
// 5 approaches from the other side. Among 4, 5 and all their neighbours the earliest event is 4-5
// at 1.0, but the momentum of 1 passes through the row and reaches 4 earlier. So being the earliest
// event among neighbours does not allow its execution.
TEST(EventSimulation, MomentumFromBeyondTheNeighboursArrivesFirst) {
  EventSimulation simulation;
  simulation.pairs.set(0, 0, contact(ImpactLaw{}));
  const double x[] = {0.0, 1.2, 2.4, 3.6, 6.6}, v[] = {10.0, 0.0, 0.0, 0.0, -2.0};
  for (int n = 0; n < 5; n++) {
    HardSphere body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    simulation.bodies.push_back(body);
    VersionedFlight flight;
    flight.position = {x[n], 0.0, 0.0};
    flight.velocity = {v[n], 0.0, 0.0};
    simulation.flights.push_back(flight);
  }
  simulation.reset_time(closed_box({-1.0, -1.0, -1.0}, {8.0, 1.0, 1.0}));
  simulation.set_up(never, {});
  simulation.begin_step(1.1);
  simulation.run(1.1);
  const double times[] = {0.02, 0.04, 0.06, 0.06 + (3.0 - 0.12 - 1.0) / 12.0};
  ASSERT_GE(simulation.events.size(), 4u);
  for (int n = 0; n < 4; n++) {
    EXPECT_EQ(simulation.events[n].key.tag_i, n + 1);
    EXPECT_EQ(simulation.events[n].key.tag_j, n + 2);
    EXPECT_NEAR(simulation.events[n].key.time, times[n], 1e-14);
  }
}

TEST(EventSimulation, CollapseRuleMakesTheRestOfAStepElastic) {
  BoxOfSpheres box(2, ImpactLaw{0.1, 0.3, 0.0});
  box.simulation.rules.collapse_limit = 3;
  box.step(200.0);
  int hits = 0;
  std::vector<int> seen(9, 0);
  for (const Event& event : box.simulation.events) {
    const int before = std::max(seen[event.i], event.with_wall() ? 0 : seen[event.j]);
    EXPECT_EQ(event.elastic, before >= 3);
    if (event.elastic) {
      EXPECT_EQ(event.impact.energy_change, 0.0);
    }
    seen[event.i]++;
    if (!event.with_wall()) seen[event.j]++;
    hits += event.elastic;
  }
  EXPECT_GT(hits, 10);
}

TEST(EventSimulation, CollisionsWithinTheContactTimeAreElastic) {
  BoxOfSpheres box(2, ImpactLaw{0.5, 0.3, 0.0});
  box.simulation.rules.collapse_limit = 0;
  box.simulation.rules.contact_time = 0.7;
  box.step(50.0);
  std::vector<double> last(8, -never);
  int elastic_hits = 0;
  for (const Event& event : box.simulation.events) {
    const double before =
        event.with_wall() ? last[event.i] : std::max(last[event.i], last[event.j]);
    EXPECT_EQ(event.elastic, event.key.time - before < 0.7);
    elastic_hits += event.elastic;
    last[event.i] = event.key.time;
    if (!event.with_wall()) last[event.j] = event.key.time;
  }
  EXPECT_GT(elastic_hits, 10);
  EXPECT_LT(elastic_hits, static_cast<int>(box.simulation.events.size()) - 10);
}

// Collisions with e < 1 along the inside of a cylinder become infinitely frequent.
TEST(EventSimulation, CollapseRuleKeepsASphereOffAConcaveWall) {
  EventSimulation simulation;
  simulation.walls = {{{{Wall::z_cylinder, 1.0, 3.0}, {}}, {{ImpactLaw{0.7, 0.0, 0.0}}}}};
  HardSphere body;
  body.tag = 1;
  body.radius = 0.4;
  body.inverse_mass = 0.5;
  simulation.bodies = {body};
  simulation.flights.resize(1);
  simulation.flights[0].velocity = {1.1, 0.0, 0.25};
  simulation.flights[0].position = {0.0, 1.2, 0.0};
  simulation.reset_time(closed_box({-3.0, -3.0, -1.0}, {3.0, 3.0, 20.0}));
  simulation.set_up(never, {});
  const double dt = 0.37;
  double least = 1.0, lost = 0.0;
  std::size_t elastic_hits = 0;
  for (int n = 0; n < 200; n++) {
    simulation.begin_step(dt);
    simulation.run(simulation.end());
    for (std::size_t m = 1; m < simulation.events.size(); m++)
      if (simulation.events[m - 1].elastic)
        least = std::min(least, simulation.events[m].key.time - simulation.events[m - 1].key.time);
    for (const Event& event : simulation.events) {
      elastic_hits += event.elastic;
      lost -= event.impact.energy_change;
    }
    const Vector3 position = simulation.flights[0].at(simulation.end());
    EXPECT_LE(std::hypot(position.x, position.y), 2.6 + 1e-13);
  }
  EXPECT_GT(elastic_hits, 1000u);
  EXPECT_GT(least, (1.0 - 1e-6) * dt / simulation.rules.collapse_limit);
  const Vector3& v = simulation.flights[0].velocity;
  EXPECT_NEAR(dot(v, v) + lost, 1.1 * 1.1 + 0.25 * 0.25, 1e-15 * (100 + elastic_hits));
  EXPECT_EQ(v.z, 0.25);
}

TEST(EventSimulation, LimitStopsAndReportsThePair) {
  BoxOfSpheres box(2, ImpactLaw{});
  box.simulation.rules.event_limit = 5;
  box.step(200.0);
  const auto [i, j] = box.simulation.overrun();
  ASSERT_GE(i, 0);
  const int of_j = j < 0 ? 0 : box.simulation.bodies[j].event_state.events;
  EXPECT_EQ(std::max(box.simulation.bodies[i].event_state.events, of_j), 6);
  EXPECT_EQ(box.simulation.events.back().i, i);
  EXPECT_EQ(box.simulation.events.back().j, j);
}

TEST(EventSimulation, TagsResolveTies) {
  EventSimulation simulation;
  simulation.pairs.set(0, 0, contact(ImpactLaw{}));
  // Two pairs that collide at the same instant, the later one first in the list.
  const double x[] = {10.0, 12.0, 0.0, 2.0}, v[] = {1.0, -1.0, 1.0, -1.0};
  const int tags[] = {3, 4, 1, 2};
  for (int n = 0; n < 4; n++) {
    HardSphere body;
    body.tag = tags[n];
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    simulation.bodies.push_back(body);
    VersionedFlight flight;
    flight.position = {x[n], 0.0, 0.0};
    flight.velocity = {v[n], 0.0, 0.0};
    simulation.flights.push_back(flight);
  }
  simulation.reset_time(closed_box({-1.0, -1.0, -1.0}, {13.0, 1.0, 1.0}));
  simulation.set_up(never, {});
  simulation.begin_step(1.0);
  simulation.run(1.0);
  ASSERT_EQ(simulation.events.size(), 2u);
  EXPECT_EQ(simulation.events[0].key.time, simulation.events[1].key.time);
  EXPECT_EQ(simulation.events[0].key.tag_i, 1);
}

// Two spheres with a well of 1.5 diameters between walls, D = 1, e = 1, all on one line. After a
// collision with each other and one with each wall the state is the same except for signs, so that
// speeds recur. 1000 recurrences of 8 events round a speed by at most 1e-16 each.
TEST(EventSimulation, PairBetweenWallsIsPeriodic) {
  EventSimulation simulation;
  simulation.pairs.set(0, 0, contact({1.0, 0.0, 1.0}, 1.5));
  simulation.walls = {{{{Wall::x_plane, 1.0, -3.0}, {}}, {{ImpactLaw{}}}},
                      {{{Wall::x_plane, -1.0, 3.0}, {}}, {{ImpactLaw{}}}}};
  for (int n = 0; n < 2; n++) {
    HardSphere body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    simulation.bodies.push_back(body);
    VersionedFlight flight;
    flight.position = {n == 0 ? -2.0 : 2.0, 0.0, 0.0};
    flight.velocity = {n == 0 ? 0.7 : -0.7, 0.0, 0.0};
    simulation.flights.push_back(flight);
  }
  simulation.reset_time(closed_box({-3.0, -1.0, -1.0}, {3.0, 1.0, 1.0}));
  simulation.set_up(never, {});
  std::size_t events = 0;
  while (events < 8000) {
    simulation.begin_step(0.37);
    simulation.run(simulation.end());
    events += simulation.events.size();
    const double u = simulation.flights[0].velocity.x;
    const double inside = std::sqrt(0.7 * 0.7 + 1.0);
    const Neighbour* pair = simulation.neighbour_lists().find_neighbour(0, 1, 0);
    EXPECT_NEAR(std::abs(u), pair && pair->inside ? inside : 0.7, 1e-12);
    EXPECT_NEAR(simulation.flights[1].velocity.x, -u, 1e-12);
  }
}

}  // namespace
