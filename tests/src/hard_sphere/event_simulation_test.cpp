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

const Law elastic{1.0, 0.0, 0.3};
const Law rough{0.9, 0.3, 0.3};

double changes(const std::vector<Event>& events) {
  return std::accumulate(events.begin(), events.end(), 0.0,
                         [](double sum, const Event& e) { return sum + e.impact.energy_change; });
}

// Each event rounds energies of order 1 by a few 1e-16.
TEST(EventSimulation, EnergyBalances) {
  for (const Law& law : {elastic, rough}) {
    BoxOfSpheres box(3, law);
    const double before = box.kinetic_energy();
    for (int n = 0; n < 200; n++) box.step(0.05);
    ASSERT_GT(box.all.size(), 1000u);
    EXPECT_NEAR(box.kinetic_energy() - before, changes(box.all), 2e-15 * box.all.size());
  }
}

TEST(EventSimulation, NothingOverlapsAndNothingLeavesTheBox) {
  BoxOfSpheres box(3, rough);
  for (int n = 0; n < 100; n++) {
    box.step(0.1);
    const auto& bodies = box.simulation.bodies;
    for (const CandidatePair& candidate : box.simulation.candidates) {
      const Vector3& place = bodies[candidate.i].flight.end;
      const double distance =
          candidate.with_wall()
              ? box.simulation.walls[candidate.wall()].wall.nearest(place, {}, 0.0).distance
              : norm(bodies[candidate.j].flight.end - place);
      EXPECT_GT(distance, candidate.surfaces.core - 1e-13);
      EXPECT_TRUE(!candidate.inside || candidate.with_wall() ||
                  distance < candidate.surfaces.edge + 1e-13);
    }
  }
}

// The step is no parameter of the physics: the same events at the same times. Two runs differ by
// the round-off of where a step begins, 1e-16, which every collision multiplies by about (free
// path)/ (radius) ~ 5; a sphere has some 6 in the time compared.
TEST(EventSimulation, StepDoesNotMatter) {
  BoxOfSpheres fine(3, elastic), coarse(3, elastic);
  for (int n = 0; n < 200; n++) fine.step(0.01);
  for (int n = 0; n < 2; n++) coarse.step(1.0);
  ASSERT_GT(coarse.all.size(), 100u);
  ASSERT_EQ(fine.all.size(), coarse.all.size());
  for (std::size_t n = 0; n < fine.all.size(); n++) {
    EXPECT_EQ(fine.all[n].key.tag_i, coarse.all[n].key.tag_i);
    EXPECT_EQ(fine.all[n].key.tag_j, coarse.all[n].key.tag_j);
    EXPECT_EQ(fine.all[n].impact.kind, coarse.all[n].impact.kind);
  }
  EXPECT_LT(fine.farthest_from(coarse), 1e-10);
}

TEST(EventSimulation, EventsAreInOrder) {
  BoxOfSpheres box(3, rough);
  box.step(2.0);
  for (std::size_t n = 1; n < box.simulation.events.size(); n++)
    EXPECT_FALSE(box.simulation.events[n].key < box.simulation.events[n - 1].key);
}

// Several simulations, each with its own part of the spheres: those owned and all that they may
// meet. Updates go from the owner to those that simulate a sphere too, until none differ. As
// processes do it.
class Parts {
 public:
  Parts(const BoxOfSpheres& whole, int parts)
      : parts_(parts), simulations_(parts, whole.simulation) {
    for (int p = 0; p < parts; p++) {
      auto& candidates = simulations_[p].candidates;
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                      [&](const CandidatePair& candidate) {
                                        return owner(candidate.i) != p &&
                                               (candidate.with_wall() || owner(candidate.j) != p);
                                      }),
                       candidates.end());
      simulations_[p].rules.distributed = true;
      simulations_[p].index_candidates();
    }
  }

  void step(double dt, int windows) {
    for (EventSimulation& simulation : simulations_) {
      for (auto& body : simulation.bodies) {
        const Flight& known = simulations_[owner(body.tag - 1)].bodies[body.tag - 1].flight;
        if (&known != &body.flight) body.flight = known;
      }
    }
    for (EventSimulation& simulation : simulations_) {
      for (auto& body : simulation.bodies) {
        Flight& f = body.flight;
        f = {f.end + dt * f.velocity, f.velocity, 0.0, f.spin};
      }
      simulation.begin_step(dt);
      for (int n = 0; n < static_cast<int>(simulation.candidates.size()); n++)
        simulation.predict(n);
      simulation.order_queue();
    }
    for (int n = 1; n <= windows; n++) run_window(n == windows ? dt : n * dt / windows);
  }

  const Flight& flight(int body) const { return simulations_[owner(body)].bodies[body].flight; }
  int rounds = 0;

 private:
  int owner(std::int64_t body) const { return static_cast<int>(body) % parts_; }

  void run_window(double until) {
    for (EventSimulation& simulation : simulations_) {
      simulation.begin_window();
      simulation.run(until);
    }
    for (double from = 0.0; from < never; rounds++) {
      std::vector<std::vector<RemoteUpdate> > incoming(parts_);
      std::vector<double> differs(parts_);
      for (int p = 0; p < parts_; p++) {
        incoming[p] = updates_for(p, from);
        differs[p] = simulations_[p].first_difference(from, incoming[p]);
      }
      from = *std::min_element(differs.begin(), differs.end());
      for (int p = 0; p < parts_; p++)
        if (differs[p] < never) simulations_[p].rollback_and_run(differs[p], incoming[p], until);
    }
  }

  std::vector<RemoteUpdate> updates_for(int part, double from) const {
    std::vector<RemoteUpdate> all;
    for (int p = 0; p < parts_; p++)
      for (const RemoteUpdate& update : simulations_[p].outgoing)
        if (p != part && owner(update.body) == p && update.key.time >= from &&
            (update.partner < 0 || owner(update.partner) != part))
          all.push_back(update);
    std::stable_sort(all.begin(), all.end(),
                     [](const RemoteUpdate& a, const RemoteUpdate& b) { return a.key < b.key; });
    return all;
  }

  int parts_;
  std::vector<EventSimulation> simulations_;
};

TEST(EventSimulation, ProcessesThatExchangeUpdatesDoWhatOneDoes) {
  for (const int parts : {2, 3, 5})
    for (const int windows : {1, 4}) {
      BoxOfSpheres whole(3, rough);
      Parts split(whole, parts);
      for (int n = 0; n < 20; n++) {
        whole.step(0.3);
        split.step(0.3, windows);
      }
      ASSERT_GT(whole.all.size(), 500u);
      for (int body = 0; body < 27; body++)
        EXPECT_TRUE(same(whole.simulation.bodies[body].flight, split.flight(body))) << body;
    }
}

// A blow runs down a row of touching spheres in no time: events of one instant, one causing the
// next, with tags that do not rise along the row.
TEST(EventSimulation, PartsAgreeOnEventsOfOneInstant) {
  BoxOfSpheres whole(1, Law{});
  auto& simulation = whole.simulation;
  simulation.bodies.clear();
  simulation.candidates.clear();
  const int places[] = {3, 0, 4, 1, 5, 2};
  int at[6];
  for (int n = 0; n < 6; n++) {
    Body body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    body.flight.end = {(places[n] > 0 ? 1.0 : 0.0) + places[n], 0.0, 0.0};
    if (places[n] == 0) body.flight.velocity = {2.0, 0.0, 0.0};
    simulation.bodies.push_back(body);
    at[places[n]] = n;
  }
  for (int n = 0; n < 5; n++)
    simulation.candidates.push_back(
        {std::min(at[n], at[n + 1]), std::max(at[n], at[n + 1]), 0, 0, {1.0, 1.0}});
  simulation.index_candidates();
  for (const int parts : {2, 3}) {
    BoxOfSpheres one = whole;
    Parts split(whole, parts);
    one.step(1.0);
    split.step(1.0, 1);
    ASSERT_EQ(one.simulation.events.size(), 5u);
    for (int n = 0; n < 5; n++) EXPECT_EQ(one.simulation.events[n].key.causal_depth, n);
    for (int body = 0; body < 6; body++)
      EXPECT_TRUE(same(one.simulation.bodies[body].flight, split.flight(body))) << body;
  }
}

// A row of five spheres, each with its neighbours only: 1 is fast, 2 to 4 are at rest, 5 comes from
// the other side. Of 4, 5 and all their neighbours the earliest event is 4-5 at 1.0; but the blow
// of 1 runs down the row and reaches 4 before. So an event may not be carried out on the ground
// that it is the earliest among the neighbours.
TEST(EventSimulation, ABlowFromBeyondTheNeighboursComesFirst) {
  EventSimulation simulation;
  simulation.laws = {Law{}};
  const double x[] = {0.0, 1.2, 2.4, 3.6, 6.6}, v[] = {10.0, 0.0, 0.0, 0.0, -2.0};
  for (int n = 0; n < 5; n++) {
    Body body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    body.flight.velocity = {v[n], 0.0, 0.0};
    body.flight.end = {x[n] + 1.1 * v[n], 0.0, 0.0};
    simulation.bodies.push_back(body);
    if (n > 0) simulation.candidates.push_back({n - 1, n, 0, 0, {1.0, 1.0}});
  }
  simulation.index_candidates();
  simulation.begin_step(1.1);
  for (int n = 0; n < 4; n++) simulation.predict(n);
  simulation.order_queue();
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
  BoxOfSpheres box(2, Law{0.1, 0.3, 0.0});
  box.simulation.rules.collapse = 3;
  box.step(200.0);
  int hits = 0;
  std::vector<int> seen(9, 0);
  for (const Event& event : box.simulation.events) {
    const CandidatePair& candidate = box.simulation.candidates[event.candidate];
    const int before = std::max(seen[candidate.i], candidate.with_wall() ? 0 : seen[candidate.j]);
    EXPECT_EQ(event.elastic, before >= 3);
    if (event.elastic) {
      EXPECT_EQ(event.impact.energy_change, 0.0);
    }
    seen[candidate.i]++;
    if (!candidate.with_wall()) seen[candidate.j]++;
    hits += event.elastic;
  }
  EXPECT_GT(hits, 10);
}

TEST(EventSimulation, CollisionsWithinTheContactTimeAreElastic) {
  BoxOfSpheres box(2, Law{0.5, 0.3, 0.0});
  box.simulation.rules.collapse = 0;
  box.simulation.rules.contact_time = 0.7;
  box.step(50.0);
  std::vector<double> last(8, -never);
  int elastic_hits = 0;
  for (const Event& event : box.simulation.events) {
    const CandidatePair& candidate = box.simulation.candidates[event.candidate];
    const double before =
        candidate.with_wall() ? last[candidate.i] : std::max(last[candidate.i], last[candidate.j]);
    EXPECT_EQ(event.elastic, event.key.time - before < 0.7);
    elastic_hits += event.elastic;
    last[candidate.i] = event.key.time;
    if (!candidate.with_wall()) last[candidate.j] = event.key.time;
  }
  EXPECT_GT(elastic_hits, 10);
  EXPECT_LT(elastic_hits, static_cast<int>(box.simulation.events.size()) - 10);
}

// Along the inside of a cylinder collisions with e < 1 come faster and faster without end.
TEST(EventSimulation, CollapseRuleKeepsASphereOffAConcaveWall) {
  EventSimulation simulation;
  simulation.laws = {Law{0.7, 0.0, 0.0}};
  simulation.walls = {{{Wall::z_cylinder, 1.0, 3.0}, {}, 0.0}};
  Body body;
  body.tag = 1;
  body.radius = 0.4;
  body.inverse_mass = 0.5;
  body.flight.velocity = {1.1, 0.0, 0.25};
  body.flight.end = {0.0, 1.2, 0.0};
  simulation.bodies = {body};
  simulation.candidates = {{0, -1, 0, 0, {0.4, 0.4}}};
  simulation.index_candidates();
  const double dt = 0.37;
  double least = 1.0, lost = 0.0;
  std::size_t elastic_hits = 0;
  for (int n = 0; n < 200; n++) {
    Flight& f = simulation.bodies[0].flight;
    f = {f.end + dt * f.velocity, f.velocity, 0.0, {}};
    simulation.begin_step(dt);
    simulation.predict(0);
    simulation.order_queue();
    simulation.run(dt);
    for (std::size_t m = 1; m < simulation.events.size(); m++)
      if (simulation.events[m - 1].elastic)
        least = std::min(least, simulation.events[m].key.time - simulation.events[m - 1].key.time);
    for (const Event& event : simulation.events) {
      elastic_hits += event.elastic;
      lost -= event.impact.energy_change;
    }
    EXPECT_LE(std::hypot(f.end.x, f.end.y), 2.6 + 1e-13);
  }
  EXPECT_GT(elastic_hits, 1000u);
  EXPECT_GT(least, (1.0 - 1e-6) * dt / simulation.rules.collapse);
  const Vector3& v = simulation.bodies[0].flight.velocity;
  EXPECT_NEAR(dot(v, v) + lost, 1.1 * 1.1 + 0.25 * 0.25, 1e-15 * (100 + elastic_hits));
  EXPECT_EQ(v.z, 0.25);
}

TEST(EventSimulation, LimitStopsAndNamesTheCandidatePair) {
  BoxOfSpheres box(2, Law{});
  box.simulation.rules.limit = 5;
  box.step(200.0);
  ASSERT_GE(box.simulation.overrun(), 0);
  const CandidatePair& candidate = box.simulation.candidates[box.simulation.overrun()];
  const int of_j = candidate.with_wall() ? 0 : box.simulation.bodies[candidate.j].flight.events;
  EXPECT_EQ(std::max(box.simulation.bodies[candidate.i].flight.events, of_j), 6);
  EXPECT_EQ(box.simulation.events.back().candidate, box.simulation.overrun());
}

TEST(EventSimulation, TiesGoByTags) {
  EventSimulation simulation;
  simulation.laws = {Law{}};
  // Two pairs that collide at the same instant, the later one first in the list.
  const double x[] = {0.0, 2.0, 10.0, 12.0}, v[] = {1.0, -1.0, 1.0, -1.0};
  for (int n = 0; n < 4; n++) {
    Body body;
    body.tag = n + 1;
    body.inverse_mass = 1.0;
    body.flight.velocity = {v[n], 0.0, 0.0};
    body.flight.end = {x[n] + v[n], 0.0, 0.0};
    simulation.bodies.push_back(body);
  }
  simulation.candidates = {{2, 3, 0, 0, {1.0, 1.0}}, {0, 1, 0, 0, {1.0, 1.0}}};
  simulation.index_candidates();
  simulation.begin_step(1.0);
  simulation.predict(0);
  simulation.predict(1);
  simulation.order_queue();
  simulation.run(1.0);
  ASSERT_EQ(simulation.events.size(), 2u);
  EXPECT_EQ(simulation.events[0].key.time, simulation.events[1].key.time);
  EXPECT_EQ(simulation.events[0].key.tag_i, 1);
}

// Two spheres in a well of 1.5 diameters between walls, D = 1, e = 1, and all on one line: after a
// collision with each other and one with each wall everything is as it was but for signs, so that
// speeds return for ever. 1000 returns of 8 events round a speed by at most 1e-16 each.
TEST(EventSimulation, PairBetweenWallsReturns) {
  EventSimulation simulation;
  simulation.laws = {Law{1.0, 0.0, 1.0}, Law{}};
  simulation.walls = {{{Wall::x_plane, 1.0, -3.0}, {}, 0.0}, {{Wall::x_plane, -1.0, 3.0}, {}, 0.0}};
  for (int n = 0; n < 2; n++) {
    Body body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    body.flight.velocity = {n == 0 ? 0.7 : -0.7, 0.0, 0.0};
    body.flight.end = {n == 0 ? -2.0 : 2.0, 0.0, 0.0};
    simulation.bodies.push_back(body);
    simulation.candidates.push_back({n, -1 - n, 0, 1, {0.5, 0.5}});
  }
  simulation.candidates.push_back({0, 1, 0, 0, {1.0, 1.5}});
  simulation.index_candidates();
  std::size_t events = 0;
  while (events < 8000) {
    for (Body& body : simulation.bodies) {
      Flight& f = body.flight;
      f = {f.end + 0.37 * f.velocity, f.velocity, 0.0, {}};
    }
    simulation.begin_step(0.37);
    for (int n = 0; n < 3; n++) simulation.predict(n);
    simulation.order_queue();
    simulation.run(0.37);
    events += simulation.events.size();
    const double u = simulation.bodies[0].flight.velocity.x;
    const double inside = std::sqrt(0.7 * 0.7 + 1.0);
    EXPECT_NEAR(std::abs(u), simulation.candidates[2].inside ? inside : 0.7, 1e-12);
    EXPECT_NEAR(simulation.bodies[1].flight.velocity.x, -u, 1e-12);
  }
}

}  // namespace
