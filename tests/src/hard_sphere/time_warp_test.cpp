// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/time_warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "hard_sphere/box_of_spheres.h"

namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

/// Several simulations of the same bodies. Each owns a part of them and has remote copies of the
/// others. They exchange messages as processes do.
class PartitionedSimulation {
 public:
  int rounds = 0;

  PartitionedSimulation(const EventSimulation& whole, int parts, double lifetime = never)
      : simulations_(parts) {
    for (int p = 0; p < parts; p++) {
      TimeWarp& part = simulations_[p];
      part.single_process = false;
      part.bodies = whole.bodies;
      part.flights = whole.flights;
      part.pairs = whole.pairs;
      part.walls = whole.walls;
      part.rules = whole.rules;
      for (HardSphere& body : part.bodies) body.remote = owner(body.tag - 1) != p;
      part.neighbour_lists().bodies_in_box = static_cast<double>(whole.bodies.size());
      part.neighbour_lists().margin = whole.neighbour_lists().margin;
      part.reset_time(whole.box());
      part.set_up(lifetime, {});
    }
  }

  void step(double dt, int windows) {
    for (TimeWarp& part : simulations_) part.begin_step(dt);
    const double start = simulations_[0].start(), end = simulations_[0].end();
    double from = start;
    for (int n = 1; n <= windows; n++) {
      const double until = n == windows ? end : start + n * dt / windows;
      run_window(from, until);
      from = until;
    }
  }

  const VersionedFlight& flight(int body) const { return simulations_[owner(body)].flights[body]; }
  const EventState& event_state(int body) const {
    return simulations_[owner(body)].bodies[body].event_state;
  }

  /// The events of all parts in this step, sorted; an event of two parts is included once.
  std::vector<Event> events() const {
    std::vector<Event> all;
    for (std::size_t p = 0; p < simulations_.size(); p++)
      for (const Event& event : simulations_[p].events)
        if (owner(event.i) == static_cast<int>(p)) all.push_back(event);
    std::sort(all.begin(), all.end(), [](const Event& a, const Event& b) { return a.key < b.key; });
    return all;
  }

  /// Expects the same flights of all bodies in each part.
  void expect_agreement() const {
    for (const TimeWarp& part : simulations_)
      for (std::size_t n = 0; n < part.bodies.size(); n++) {
        EXPECT_TRUE(same(part.flights[n], flight(static_cast<int>(n)))) << n;
        EXPECT_TRUE(same(part.bodies[n].event_state.spin, event_state(static_cast<int>(n)).spin))
            << n;
      }
  }

 private:
  int owner(std::int64_t body) const {
    return static_cast<int>(body % static_cast<std::int64_t>(simulations_.size()));
  }

  void run_window(double from, double until) {
    for (TimeWarp& part : simulations_) part.begin_window(from);
    for (;; rounds++) {
      for (TimeWarp& part : simulations_) part.run_window(until);
      for (std::size_t p = 0; p < simulations_.size(); p++)
        for (const int body : simulations_[p].take_changed_bodies())
          send_messages(static_cast<int>(p), body);
      VirtualTime gvt;
      for (TimeWarp& part : simulations_) gvt = std::min(gvt, part.rollback_time());
      if (gvt.time == never) break;
      for (TimeWarp& part : simulations_) part.roll_back_and_accept(gvt);
      ASSERT_LT(rounds, 100000);
    }
    for (TimeWarp& part : simulations_) part.end_window();
  }

  void send_messages(int from, int body) {
    std::vector<EventMessage> messages;
    simulations_[from].collect_messages(body, messages);
    for (int p = 0; p < static_cast<int>(simulations_.size()); p++) {
      if (p == from) continue;
      std::vector<EventMessage>& received = simulations_[p].begin_receiving(body);
      for (const EventMessage& message : messages)
        if (message.partner < 0 || owner(message.partner) != p) received.push_back(message);
    }
  }

  std::vector<TimeWarp> simulations_;
};

void expect_same_events(EventSimulation& whole, PartitionedSimulation& split, int steps, double dt,
                        int windows, std::size_t& events) {
  for (int n = 0; n < steps; n++) {
    whole.begin_step(dt);
    whole.run(whole.end());
    split.step(dt, windows);
    split.expect_agreement();
    const std::vector<Event> found = split.events();
    ASSERT_EQ(found.size(), whole.events.size());
    for (std::size_t k = 0; k < found.size(); k++)
      ASSERT_TRUE(same_bits(found[k], whole.events[k])) << k;
    events += found.size();
  }
  for (std::size_t n = 0; n < whole.bodies.size(); n++)
    ASSERT_TRUE(same(whole.flights[n], split.flight(static_cast<int>(n)))) << n;
}

// Neighbours nearly always belong to different parts, so that nearly every event involves two
// parts.
TEST(TimeWarp, PartsHaveTheSameEventsInABox) {
  for (const ImpactLaw& law :
       {ImpactLaw{0.9, 0.3, 0.3}, ImpactLaw{1.0, 0.0, 0.3}, ImpactLaw{0.9, 0.3, 0.0}})
    for (const int parts : {2, 3, 5})
      for (const int windows : {1, 4}) {
        BoxOfSpheres whole(3, law);
        PartitionedSimulation split(whole.simulation, parts);
        std::size_t events = 0;
        expect_same_events(whole.simulation, split, 20, 0.3, windows, events);
        EXPECT_GT(events, 100u);
      }
}

constexpr double neighbourhood_lifetime = 0.5;  // short: several lifetimes in a run
constexpr double small_margin =
    0.15;  // small: bodies leave their neighbourhoods after a fraction of a flight

/// A gas with wells in a periodic box.
void set_gas(EventSimulation& gas, int edge, double space, const ImpactLaw& law, double ratio,
             double rate) {
  std::mt19937 random(7);
  std::normal_distribution<> normal;
  gas.pairs.set(0, 0, contact(law, ratio));
  PeriodicBox box;
  box.edges.xx = box.edges.yy = box.edges.zz = edge * space;
  box.rates.xy = rate * edge * space;
  box.periodic = {true, true, true};
  for (int n = 0; n < edge * edge * edge; n++) {
    HardSphere body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    body.inverse_inertia = 10.0;
    gas.bodies.push_back(body);
    VersionedFlight flight;
    flight.position = {space * (n % edge + 0.5), space * (n / edge % edge + 0.5),
                       space * (n / edge / edge + 0.5)};
    flight.velocity = {normal(random) + rate * (flight.position.y - 0.5 * edge * space),
                       normal(random), normal(random)};
    gas.flights.push_back(flight);
  }
  gas.neighbour_lists().bodies_in_box = static_cast<double>(gas.bodies.size());
  gas.reset_time(box);
  gas.set_up(neighbourhood_lifetime, {});
}

TEST(TimeWarp, PartsHaveTheSameEventsInPeriodicBoxes) {
  for (const double rate : {0.0, 0.2})
    for (const int parts : {2, 5})
      for (const double dt : {0.05, 0.4}) {
        EventSimulation whole;
        set_gas(whole, 5, 1.3, {0.95, 0.2, 0.5}, 1.3, rate);
        PartitionedSimulation split(whole, parts, neighbourhood_lifetime);
        std::size_t events = 0;
        expect_same_events(whole, split, dt < 0.1 ? 16 : 3, dt, 2, events);
        EXPECT_GT(events, 500u);
      }
}

// In one window bodies fly through several neighbourhoods. Bodies after a rollback meet others at
// positions in neighbourhoods that these have left since, and rolled-back partners have their
// neighbourhoods elsewhere.
TEST(TimeWarp, PartsHaveTheSameEventsWhenBodiesLeaveNeighbourhoods) {
  for (const double friction : {0.0, 0.2})
    for (const double rate : {0.0, 0.2})
      for (const int parts : {2, 5}) {
        EventSimulation whole;
        whole.neighbour_lists().margin = small_margin;
        set_gas(whole, 6, 1.6, {1.0, friction, 0.5}, 1.1, rate);
        PartitionedSimulation split(whole, parts, neighbourhood_lifetime);
        std::size_t events = 0;
        expect_same_events(whole, split, 2, 0.6, 1, events);
        EXPECT_GT(events, 500u);
      }
}

// Spheres bound by narrow wells so deep that the rule of rest acts from the start.
TEST(TimeWarp, PartsHaveTheSameEventsInABoundCluster) {
  for (const int parts : {2, 3}) {
    EventSimulation whole;
    set_gas(whole, 3, 1.005, {0.5, 0.2, 1e4}, 1.01, 0.0);
    PartitionedSimulation split(whole, parts, neighbourhood_lifetime);
    std::size_t events = 0;
    expect_same_events(whole, split, 10, 0.05, 4, events);
    EXPECT_GT(events, 1000u);
    EXPECT_GT(std::count_if(whole.events.begin(), whole.events.end(),
                            [](const Event& event) { return event.impact.rest_rule_energy > 0.0; }),
              0);
  }
}

// Momentum passes through a row of touching spheres at one instant: a chain of events, each the
// cause of the next, with tags in another order than the row.
TEST(TimeWarp, PartsHaveTheSameEventsAtOneInstant) {
  EventSimulation whole;
  whole.pairs.set(0, 0, contact({}));
  const int positions[] = {3, 0, 4, 1, 5, 2};
  for (int n = 0; n < 6; n++) {
    HardSphere body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    whole.bodies.push_back(body);
    VersionedFlight flight;
    flight.position = {static_cast<double>(positions[n]), 0.0, 0.0};
    if (positions[n] == 0) {
      flight.velocity = {2.0, 0.0, 0.0};
      flight.position.x = -1.0;
    }
    whole.flights.push_back(flight);
  }
  whole.neighbour_lists().bodies_in_box = 6;
  for (const int parts : {2, 3}) {
    EventSimulation one;
    one.pairs = whole.pairs, one.bodies = whole.bodies, one.flights = whole.flights;
    one.neighbour_lists().bodies_in_box = 6;
    one.reset_time(closed_box({-2.0, -1.0, -1.0}, {9.0, 1.0, 1.0}));
    one.set_up(never, {});
    PartitionedSimulation split(one, parts);
    std::size_t events = 0;
    expect_same_events(one, split, 1, 1.0, 1, events);
    ASSERT_EQ(events, 5u);
    for (int n = 0; n < 5; n++) EXPECT_EQ(one.events[n].key.causal_depth, n);
  }
}

}  // namespace
