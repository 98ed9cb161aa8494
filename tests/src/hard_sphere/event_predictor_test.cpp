// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "hard_sphere/event_simulation.h"
#include "hard_sphere/gas_of_spheres.h"

// A prediction depends only on flights and wells: it is the same on each process and at each time.
namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

const ImpactLaw sticky{0.95, 0.2, 0.2};

/// Gives access to the predictions.
class InspectedSimulation : public EventSimulation {
 public:
  /// An event of two bodies, or of a body and a wall, with the lower number first.
  using Predicted = std::tuple<double, int, int, int, Surface>;

  std::set<Predicted> valid_events(int i) const {
    std::set<Predicted> all;
    for (PredictedEvents list = predicted_[i]; !list.empty(); list.pop())
      if (!is_stale(list.front())) all.insert(predicted(i, list.front()));
    return all;
  }
  double horizon(int i) const { return predicted_[i].horizon(); }
  double next_time(int i) const { return predicted_[i].next_time(); }
  bool next_is_valid(int i) const {
    return !predicted_[i].empty() && !is_stale(predicted_[i].front());
  }

 private:
  Predicted predicted(int i, const PredictedEvent& event) const {
    if (event.partner < 0 || i < event.partner)
      return {event.time, i, event.partner, event.image, event.surface};
    return {event.time, event.partner, i, neighbour_lists_.image(event.image).opposite,
            event.surface};
  }
};

/// Fills simulations with identical gases.
void fill(EventSimulation& simulation, const PeriodicBox& box, int count = 120) {
  simulation.pairs.set(0, 0, contact(sticky, 1.4));
  simulation.rules.collapse_limit = 0;
  GasOfSpheres{count, 0.4, 0.6}.fill(simulation, box);
  simulation.reset_time(box);
}

const PeriodicBox tilted = periodic_box({7.0, 6.5, 6.0, 1.0, -1.2, 2.1});

// Predicting again changes no bit of a predicted event. A new event was predicted by the partner
// only before, or lies beyond the horizon of one of both.
TEST(EventPredictor, PredictionIsIndependentOfItsTime) {
  InspectedSimulation gas;
  fill(gas, tilted);
  gas.set_up(never, {});
  const int count = static_cast<int>(gas.bodies.size());
  int predicted_before = 0, unchanged = 0;
  for (int n = 0; n < 50; n++) {
    gas.begin_step(0.1);
    gas.run(gas.end());
    std::vector<std::set<InspectedSimulation::Predicted> > before(count);
    std::set<InspectedSimulation::Predicted> all_before;
    std::vector<double> horizons(count);
    for (int i = 0; i < count; i++) {
      before[i] = gas.valid_events(i);
      all_before.insert(before[i].begin(), before[i].end());
      horizons[i] = gas.horizon(i);
    }
    for (int i = 0; i < count; i++) {
      const double next_time = gas.next_time(i);
      const bool was_valid = gas.next_is_valid(i);
      gas.predict(i);
      const auto after = gas.valid_events(i);
      for (const auto& event : before[i])
        EXPECT_TRUE(after.count(event) || std::get<0>(event) >= gas.horizon(i));
      for (const auto& event : after) {
        const auto [time, a, b, image, surface] = event;
        const bool was_predicted = all_before.count(event) > 0;
        EXPECT_TRUE(was_predicted || time >= horizons[a] || (b >= 0 && time >= horizons[b]));
        predicted_before += was_predicted;
      }
      EXPECT_EQ(gas.next_time(i), after.empty() ? gas.horizon(i) : std::get<0>(*after.begin()));
      // The next event is the same, unless only the partner had predicted an earlier one.
      if (was_valid && before[i].count(*after.begin())) {
        EXPECT_EQ(gas.next_time(i), next_time);
        unchanged++;
      }
    }
  }
  EXPECT_GT(predicted_before, 10000);
  EXPECT_GT(unchanged, 1000);
}

/// Runs two identical simulations; `rebuild` discards predictions of one of them from time to time.
template <class Rebuild>
void expect_the_same_events(EventSimulation& one, EventSimulation& other, double dt, int steps,
                            const Rebuild& rebuild) {
  std::size_t events = 0;
  for (int n = 0; n < steps; n++) {
    for (EventSimulation* simulation : {&one, &other}) {
      simulation->begin_step(dt);
      simulation->run(simulation->end());
    }
    ASSERT_EQ(one.events.size(), other.events.size());
    for (std::size_t k = 0; k < one.events.size(); k++)
      ASSERT_TRUE(same_bits(one.events[k], other.events[k])) << n << ' ' << k;
    for (std::size_t k = 0; k < one.flights.size(); k++)
      ASSERT_TRUE(same(one.flights[k], other.flights[k]));
    events += one.events.size();
    rebuild(other, n);
  }
  EXPECT_GT(events, 2000u);
}

TEST(EventPredictor, EventsAreTheSameAfterRebuildingLists) {
  for (const double margin : {0.1, 0.6, 1.5}) {
    EventSimulation one, other;
    for (EventSimulation* simulation : {&one, &other}) {
      fill(*simulation, tilted);
      simulation->set_up(never, {});
    }
    expect_the_same_events(one, other, 0.037, 200, [&](EventSimulation& gas, int n) {
      if (n % 3) return;
      gas.neighbour_lists().margin = n % 2 ? margin : 0.5;
      gas.set_up(never, gas.bound_pairs_at_edge());
    });
  }
}

TEST(EventPredictor, EventsAreTheSameAfterPredictingAgain) {
  EventSimulation one, other;
  for (EventSimulation* simulation : {&one, &other}) {
    fill(*simulation, tilted);
    simulation->set_up(never, {});
  }
  expect_the_same_events(one, other, 0.037, 200, [](EventSimulation& gas, int) {
    for (int i = 0; i < static_cast<int>(gas.bodies.size()); i++) gas.predict(i);
  });
}

TEST(EventPredictor, EventsAreTheSameUnderShear) {
  PeriodicBox::Edges rates;
  rates.xy = 0.1 * 6.5;
  const PeriodicBox box = periodic_box({6.5, 6.5, 6.5}, rates);
  EventSimulation one, other;
  for (EventSimulation* simulation : {&one, &other}) {
    fill(*simulation, box);
    simulation->set_up(1.3, {});
  }
  expect_the_same_events(one, other, 0.04, 100, [](EventSimulation& gas, int n) {
    if (n % 3 == 0) gas.set_up(1.3, gas.bound_pairs_at_edge());
  });
}

TEST(EventPredictor, EventsAreTheSameInABoxOfWalls) {
  BoxOfSpheres one(4, {1.0, 0.3, 0.3}), other(4, {1.0, 0.3, 0.3});
  expect_the_same_events(one.simulation, other.simulation, 0.05, 200,
                         [](EventSimulation& gas, int n) {
                           if (n % 3 == 0) gas.set_up(never, gas.bound_pairs_at_edge());
                         });
}

// A step ends at the instant of an event at an edge, where only the flag shows whether the pair is
// in its well.
TEST(EventPredictor, EventsAreTheSameAfterAStepEndsAtAnEdge) {
  int at_edge = 0;
  for (const bool rebuilt : {false, true}) {
    EventSimulation one, other;
    for (EventSimulation* simulation : {&one, &other}) {
      fill(*simulation, tilted, 80);
      simulation->rules.rest_factor =
          0.0;  // depends on the collisions in a step, but the steps of both differ
      simulation->set_up(never, {});
    }
    for (int n = 0; n < 100; n++) {
      one.begin_step(0.5);
      one.run(one.end());
      ASSERT_FALSE(one.events.empty());
      const double until = one.events[n % one.events.size()].key.time;
      const std::size_t count = one.events.size();
      other.begin_step(until - other.end());
      other.run(other.end());
      const auto inside = other.bound_pairs_at_edge();
      at_edge += !inside.empty();
      if (rebuilt) other.set_up(never, inside);
      std::vector<Event> events = other.events;
      other.begin_step(one.end() - other.end());
      other.run(other.end());
      events.insert(events.end(), other.events.begin(), other.events.end());
      ASSERT_EQ(events.size(), count);
      for (std::size_t k = 0; k < count; k++)
        ASSERT_TRUE(same_bits(events[k], one.events[k])) << n << ' ' << k;
    }
  }
  EXPECT_GT(at_edge, 50);
}

}  // namespace
