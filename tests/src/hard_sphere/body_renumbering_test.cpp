// SPDX-License-Identifier: BSD-3-Clause
// EventSimulation::renumber() and add_bodies(): permutation, removal and insertion of bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "hard_sphere/gas_of_spheres.h"
#include "hard_sphere/neighbour_list_check.h"

namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

const ImpactLaw sticky{0.95, 0.2, 0.2};

PeriodicBox sheared_box() {
  PeriodicBox box = periodic_box({7.0, 6.0, 6.5, 0.0, 0.0, 1.4});
  box.rates.xy = 0.3;
  return box;
}

void set_up(EventSimulation& simulation) {
  simulation.pairs.set(0, 0, contact(sticky, 1.3));
  GasOfSpheres{90}.fill(simulation, sheared_box());
  simulation.reset_time(sheared_box());
  simulation.set_up(1.0, {});
}

void step(EventSimulation& simulation) {
  simulation.begin_step(0.1);
  simulation.run(simulation.end());
}

// A permutation changes no event.
TEST(BodyRenumbering, PermutationChangesNoEvent) {
  EventSimulation straight, mixed;
  set_up(straight);
  set_up(mixed);
  std::mt19937 random(3);
  std::size_t events = 0;
  for (int n = 0; n < 20; n++) {
    std::vector<int> old(mixed.bodies.size());
    std::iota(old.begin(), old.end(), 0);
    std::shuffle(old.begin(), old.end(), random);
    mixed.renumber(old);
    step(straight);
    step(mixed);
    ASSERT_EQ(straight.events.size(), mixed.events.size());
    for (std::size_t k = 0; k < straight.events.size(); k++)
      ASSERT_TRUE(same_bits(straight.events[k], mixed.events[k])) << k;
    events += straight.events.size();
  }
  EXPECT_GT(events, 500u);
}

void expect_same_events(const EventSimulation& a, const EventSimulation& b, std::size_t& events) {
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t k = 0; k < a.events.size(); k++)
    ASSERT_TRUE(same_bits(a.events[k], b.events[k])) << k;
  events += a.events.size();
}

/// A random permutation of all bodies without the last ones.
std::vector<int> random_subset(std::size_t bodies, std::size_t removed, std::mt19937& random) {
  std::vector<int> old(bodies);
  std::iota(old.begin(), old.end(), 0);
  std::shuffle(old.begin(), old.end(), random);
  old.resize(bodies - removed);
  return old;
}

// Ten bodies are removed and inserted again before the next step.
TEST(BodyRenumbering, RemovalAndReinsertionChangesNoEvent) {
  EventSimulation straight, changed;
  set_up(straight);
  set_up(changed);
  std::mt19937 random(5);
  std::size_t events = 0;
  for (int n = 0; n < 20; n++) {
    const std::vector<HardSphere> bodies = changed.bodies;
    const std::vector<VersionedFlight> flights = changed.flights;
    const auto inside = changed.bound_pairs_at_edge();
    const std::vector<int> old = random_subset(bodies.size(), 10, random);
    changed.renumber(old);
    NeighbourListCheck(changed).check();
    std::vector<int> again(old.size()), added;
    std::iota(again.begin(), again.end(), 0);
    std::vector<int> back;
    for (int i = 0; i < static_cast<int>(bodies.size()); i++)
      if (std::find(old.begin(), old.end(), i) == old.end()) back.push_back(i);
    for (std::size_t k = 0; k < back.size(); k++) {
      added.push_back(static_cast<int>(again.size()));
      again.push_back(-1);
    }
    changed.renumber(again);
    for (std::size_t k = 0; k < back.size(); k++) {
      changed.bodies[added[k]] = bodies[back[k]];
      changed.flights[added[k]] = flights[back[k]];
    }
    ASSERT_TRUE(changed.add_bodies(added, inside));
    NeighbourListCheck(changed).check();
    step(straight);
    step(changed);
    expect_same_events(straight, changed, events);
  }
  EXPECT_GT(events, 500u);
}

// The remaining bodies continue as in a simulation that is set up without the removed ones.
TEST(BodyRenumbering, RemovedBodiesHaveNoFurtherEvents) {
  EventSimulation kept;
  set_up(kept);
  std::mt19937 random(7);
  std::size_t events = 0;
  for (int n = 0; n < 5; n++) {
    kept.renumber(random_subset(kept.bodies.size(), 10, random));
    EventSimulation anew;
    anew.pairs = kept.pairs;
    anew.neighbour_lists().bodies_in_box = 90.0;
    anew.bodies = kept.bodies;
    anew.flights = kept.flights;
    anew.reset_time(sheared_box());
    anew.begin_step(kept.end());  // sets the same time
    anew.set_up(1.0, kept.bound_pairs_at_edge());
    for (int k = 0; k < 3; k++) {
      step(kept);
      step(anew);
      expect_same_events(anew, kept, events);
    }
  }
  EXPECT_GT(events, 100u);
}

// A new size requires set_up().
TEST(BodyRenumbering, NewSizeRequiresSetUp) {
  EventSimulation simulation;
  set_up(simulation);
  std::vector<int> old(simulation.bodies.size());
  std::iota(old.begin(), old.end(), 0);
  old.push_back(-1);
  simulation.renumber(old);
  HardSphere& body = simulation.bodies.back();
  body = simulation.bodies.front();
  body.tag = 1000;
  body.radius = 0.7;
  EXPECT_FALSE(simulation.add_bodies({static_cast<int>(old.size()) - 1}, {}));
}

}  // namespace
