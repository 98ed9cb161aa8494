// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/event_order.h"

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
TEST(EventOrder, EnergyBalances) {
  for (const Law& law : {elastic, rough}) {
    BoxOfSpheres box(3, law);
    const double before = box.kinetic_energy();
    for (int n = 0; n < 200; n++) box.step(0.05);
    ASSERT_GT(box.all.size(), 1000u);
    EXPECT_NEAR(box.kinetic_energy() - before, changes(box.all), 2e-15 * box.all.size());
  }
}

TEST(EventOrder, NothingOverlapsAndNothingLeavesTheBox) {
  BoxOfSpheres box(3, rough);
  for (int n = 0; n < 100; n++) {
    box.step(0.1);
    const auto& bodies = box.order.bodies;
    for (const CandidatePair& candidate : box.order.candidates) {
      const Vector3& place = bodies[candidate.i].flight.end;
      const double distance =
          candidate.with_wall()
              ? box.order.walls[candidate.wall()].wall.nearest(place, {}, 0.0).distance
              : norm(bodies[candidate.j].flight.end - place);
      EXPECT_GT(distance, candidate.at.core - 1e-13);
      EXPECT_TRUE(!candidate.inside || candidate.with_wall() ||
                  distance < candidate.at.edge + 1e-13);
    }
  }
}

// The step is no parameter of the physics: the same events at the same times. Two runs differ by
// the round-off of where a step begins, 1e-16, which every collision multiplies by about (free
// path)/ (radius) ~ 5; a sphere has some 6 in the time compared.
TEST(EventOrder, StepDoesNotMatter) {
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

TEST(EventOrder, EventsAreInOrder) {
  BoxOfSpheres box(3, rough);
  box.step(2.0);
  for (std::size_t n = 1; n < box.order.events.size(); n++)
    EXPECT_FALSE(box.order.events[n].key < box.order.events[n - 1].key);
}

// Several orders, each with its own part of the spheres: those owned and all that they may meet.
// News go from owner to follower until none change. As processes do it.
class Parts {
 public:
  Parts(const BoxOfSpheres& whole, int parts) : parts_(parts), orders_(parts, whole.order) {
    for (int p = 0; p < parts; p++) {
      auto& candidates = orders_[p].candidates;
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                      [&](const CandidatePair& candidate) {
                                        return owner(candidate.i) != p &&
                                               (candidate.with_wall() || owner(candidate.j) != p);
                                      }),
                       candidates.end());
      orders_[p].rules.reports = true;
      orders_[p].connect();
    }
  }

  void step(double dt, int stretches) {
    for (EventOrder& order : orders_) {
      for (auto& body : order.bodies) {
        const Flight& known = orders_[owner(body.tag - 1)].bodies[body.tag - 1].flight;
        if (&known != &body.flight) body.flight = known;
      }
    }
    for (EventOrder& order : orders_) {
      for (auto& body : order.bodies) {
        Flight& f = body.flight;
        f = {f.end + dt * f.velocity, f.velocity, 0.0, f.spin};
      }
      order.begin_step(dt);
      for (int n = 0; n < static_cast<int>(order.candidates.size()); n++) order.predict(n);
      order.sort();
    }
    for (int n = 1; n <= stretches; n++) stretch(n == stretches ? dt : n * dt / stretches);
  }

  const Flight& flight(int body) const { return orders_[owner(body)].bodies[body].flight; }
  int rounds = 0;

 private:
  int owner(std::int64_t body) const { return static_cast<int>(body) % parts_; }

  void stretch(double until) {
    for (EventOrder& order : orders_) {
      order.begin_stretch();
      order.run(until);
    }
    for (double from = 0.0; from < never; rounds++) {
      std::vector<std::vector<News> > told(parts_);
      std::vector<double> differs(parts_);
      for (int p = 0; p < parts_; p++) {
        told[p] = told_to(p, from);
        differs[p] = orders_[p].first_difference(from, told[p]);
      }
      from = *std::min_element(differs.begin(), differs.end());
      for (int p = 0; p < parts_; p++)
        if (differs[p] < never) orders_[p].run_again(differs[p], told[p], until);
    }
  }

  std::vector<News> told_to(int part, double from) const {
    std::vector<News> all;
    for (int p = 0; p < parts_; p++)
      for (const News& news : orders_[p].news)
        if (p != part && owner(news.body) == p && news.key.time >= from &&
            (news.partner < 0 || owner(news.partner) != part))
          all.push_back(news);
    std::stable_sort(all.begin(), all.end(),
                     [](const News& a, const News& b) { return a.key < b.key; });
    return all;
  }

  int parts_;
  std::vector<EventOrder> orders_;
};

TEST(EventOrder, PartsThatExchangeNewsDoWhatOneOrderDoes) {
  for (const int parts : {2, 3, 5})
    for (const int stretches : {1, 4}) {
      BoxOfSpheres whole(3, rough);
      Parts split(whole, parts);
      for (int n = 0; n < 20; n++) {
        whole.step(0.3);
        split.step(0.3, stretches);
      }
      ASSERT_GT(whole.all.size(), 500u);
      for (int body = 0; body < 27; body++)
        EXPECT_TRUE(same(whole.order.bodies[body].flight, split.flight(body))) << body;
    }
}

// A blow runs down a row of touching spheres in no time: events of one instant, one causing the
// next, with tags that do not rise along the row.
TEST(EventOrder, PartsAgreeOnEventsOfOneInstant) {
  BoxOfSpheres whole(1, Law{});
  auto& order = whole.order;
  order.bodies.clear();
  order.candidates.clear();
  const int places[] = {3, 0, 4, 1, 5, 2};
  int at[6];
  for (int n = 0; n < 6; n++) {
    Body body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    body.flight.end = {(places[n] > 0 ? 1.0 : 0.0) + places[n], 0.0, 0.0};
    if (places[n] == 0) body.flight.velocity = {2.0, 0.0, 0.0};
    order.bodies.push_back(body);
    at[places[n]] = n;
  }
  for (int n = 0; n < 5; n++)
    order.candidates.push_back(
        {std::min(at[n], at[n + 1]), std::max(at[n], at[n + 1]), 0, 0, {1.0, 1.0}});
  order.connect();
  for (const int parts : {2, 3}) {
    BoxOfSpheres one = whole;
    Parts split(whole, parts);
    one.step(1.0);
    split.step(1.0, 1);
    ASSERT_EQ(one.order.events.size(), 5u);
    for (int n = 0; n < 5; n++) EXPECT_EQ(one.order.events[n].key.depth, n);
    for (int body = 0; body < 6; body++)
      EXPECT_TRUE(same(one.order.bodies[body].flight, split.flight(body))) << body;
  }
}

// A row of five spheres, each with its neighbours only: 1 is fast, 2 to 4 are at rest, 5 comes from
// the other side. Of 4, 5 and all their neighbours the earliest event is 4-5 at 1.0; but the blow
// of 1 runs down the row and reaches 4 before. So an event may not be carried out on the ground
// that it is the earliest among the neighbours.
TEST(EventOrder, ABlowFromBeyondTheNeighboursComesFirst) {
  EventOrder order;
  order.laws = {Law{}};
  const double x[] = {0.0, 1.2, 2.4, 3.6, 6.6}, v[] = {10.0, 0.0, 0.0, 0.0, -2.0};
  for (int n = 0; n < 5; n++) {
    Body body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    body.flight.velocity = {v[n], 0.0, 0.0};
    body.flight.end = {x[n] + 1.1 * v[n], 0.0, 0.0};
    order.bodies.push_back(body);
    if (n > 0) order.candidates.push_back({n - 1, n, 0, 0, {1.0, 1.0}});
  }
  order.connect();
  order.begin_step(1.1);
  for (int n = 0; n < 4; n++) order.predict(n);
  order.sort();
  order.run(1.1);
  const double times[] = {0.02, 0.04, 0.06, 0.06 + (3.0 - 0.12 - 1.0) / 12.0};
  ASSERT_GE(order.events.size(), 4u);
  for (int n = 0; n < 4; n++) {
    EXPECT_EQ(order.events[n].key.tag_i, n + 1);
    EXPECT_EQ(order.events[n].key.tag_j, n + 2);
    EXPECT_NEAR(order.events[n].key.time, times[n], 1e-14);
  }
}

TEST(EventOrder, CollapseRuleMakesTheRestOfAStepElastic) {
  BoxOfSpheres box(2, Law{0.1, 0.3, 0.0});
  box.order.rules.collapse = 3;
  box.step(200.0);
  int hits = 0;
  std::vector<int> seen(9, 0);
  for (const Event& event : box.order.events) {
    const CandidatePair& candidate = box.order.candidates[event.candidate];
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

TEST(EventOrder, CollisionsWithinTheContactTimeAreElastic) {
  BoxOfSpheres box(2, Law{0.5, 0.3, 0.0});
  box.order.rules.collapse = 0;
  box.order.rules.contact_time = 0.7;
  box.step(50.0);
  std::vector<double> last(8, -never);
  int elastic_hits = 0;
  for (const Event& event : box.order.events) {
    const CandidatePair& candidate = box.order.candidates[event.candidate];
    const double before =
        candidate.with_wall() ? last[candidate.i] : std::max(last[candidate.i], last[candidate.j]);
    EXPECT_EQ(event.elastic, event.key.time - before < 0.7);
    elastic_hits += event.elastic;
    last[candidate.i] = event.key.time;
    if (!candidate.with_wall()) last[candidate.j] = event.key.time;
  }
  EXPECT_GT(elastic_hits, 10);
  EXPECT_LT(elastic_hits, static_cast<int>(box.order.events.size()) - 10);
}

// Along the inside of a cylinder collisions with e < 1 come faster and faster without end.
TEST(EventOrder, CollapseRuleKeepsASphereOffAConcaveWall) {
  EventOrder order;
  order.laws = {Law{0.7, 0.0, 0.0}};
  order.walls = {{{Wall::z_cylinder, 1.0, 3.0}, {}, 0.0}};
  Body body;
  body.tag = 1;
  body.radius = 0.4;
  body.inverse_mass = 0.5;
  body.flight.velocity = {1.1, 0.0, 0.25};
  body.flight.end = {0.0, 1.2, 0.0};
  order.bodies = {body};
  order.candidates = {{0, -1, 0, 0, {0.4, 0.4}}};
  order.connect();
  const double dt = 0.37;
  double least = 1.0, lost = 0.0;
  std::size_t elastic_hits = 0;
  for (int n = 0; n < 200; n++) {
    Flight& f = order.bodies[0].flight;
    f = {f.end + dt * f.velocity, f.velocity, 0.0, {}};
    order.begin_step(dt);
    order.predict(0);
    order.sort();
    order.run(dt);
    for (std::size_t m = 1; m < order.events.size(); m++)
      if (order.events[m - 1].elastic)
        least = std::min(least, order.events[m].key.time - order.events[m - 1].key.time);
    for (const Event& event : order.events) {
      elastic_hits += event.elastic;
      lost -= event.impact.energy_change;
    }
    EXPECT_LE(std::hypot(f.end.x, f.end.y), 2.6 + 1e-13);
  }
  EXPECT_GT(elastic_hits, 1000u);
  EXPECT_GT(least, (1.0 - 1e-6) * dt / order.rules.collapse);
  const Vector3& v = order.bodies[0].flight.velocity;
  EXPECT_NEAR(dot(v, v) + lost, 1.1 * 1.1 + 0.25 * 0.25, 1e-15 * (100 + elastic_hits));
  EXPECT_EQ(v.z, 0.25);
}

TEST(EventOrder, LimitStopsAndNamesTheCandidatePair) {
  BoxOfSpheres box(2, Law{});
  box.order.rules.limit = 5;
  box.step(200.0);
  ASSERT_GE(box.order.overrun(), 0);
  const CandidatePair& candidate = box.order.candidates[box.order.overrun()];
  const int of_j = candidate.with_wall() ? 0 : box.order.bodies[candidate.j].flight.events;
  EXPECT_EQ(std::max(box.order.bodies[candidate.i].flight.events, of_j), 6);
  EXPECT_EQ(box.order.events.back().candidate, box.order.overrun());
}

TEST(EventOrder, TiesGoByTags) {
  EventOrder order;
  order.laws = {Law{}};
  // Two pairs that collide at the same instant, the later one first in the list.
  const double x[] = {0.0, 2.0, 10.0, 12.0}, v[] = {1.0, -1.0, 1.0, -1.0};
  for (int n = 0; n < 4; n++) {
    Body body;
    body.tag = n + 1;
    body.inverse_mass = 1.0;
    body.flight.velocity = {v[n], 0.0, 0.0};
    body.flight.end = {x[n] + v[n], 0.0, 0.0};
    order.bodies.push_back(body);
  }
  order.candidates = {{2, 3, 0, 0, {1.0, 1.0}}, {0, 1, 0, 0, {1.0, 1.0}}};
  order.connect();
  order.begin_step(1.0);
  order.predict(0);
  order.predict(1);
  order.sort();
  order.run(1.0);
  ASSERT_EQ(order.events.size(), 2u);
  EXPECT_EQ(order.events[0].key.time, order.events[1].key.time);
  EXPECT_EQ(order.events[0].key.tag_i, 1);
}

// Two spheres in a well of 1.5 diameters between walls, D = 1, e = 1, and all on one line: after a
// collision with each other and one with each wall everything is as it was but for signs, so that
// speeds return for ever. 1000 returns of 8 events round a speed by at most 1e-16 each.
TEST(EventOrder, PairBetweenWallsReturns) {
  EventOrder order;
  order.laws = {Law{1.0, 0.0, 1.0}, Law{}};
  order.walls = {{{Wall::x_plane, 1.0, -3.0}, {}, 0.0}, {{Wall::x_plane, -1.0, 3.0}, {}, 0.0}};
  for (int n = 0; n < 2; n++) {
    Body body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    body.flight.velocity = {n == 0 ? 0.7 : -0.7, 0.0, 0.0};
    body.flight.end = {n == 0 ? -2.0 : 2.0, 0.0, 0.0};
    order.bodies.push_back(body);
    order.candidates.push_back({n, -1 - n, 0, 1, {0.5, 0.5}});
  }
  order.candidates.push_back({0, 1, 0, 0, {1.0, 1.5}});
  order.connect();
  std::size_t events = 0;
  while (events < 8000) {
    for (Body& body : order.bodies) {
      Flight& f = body.flight;
      f = {f.end + 0.37 * f.velocity, f.velocity, 0.0, {}};
    }
    order.begin_step(0.37);
    for (int n = 0; n < 3; n++) order.predict(n);
    order.sort();
    order.run(0.37);
    events += order.events.size();
    const double u = order.bodies[0].flight.velocity.x;
    const double inside = std::sqrt(0.7 * 0.7 + 1.0);
    EXPECT_NEAR(std::abs(u), order.candidates[2].inside ? inside : 0.7, 1e-12);
    EXPECT_NEAR(order.bodies[1].flight.velocity.x, -u, 1e-12);
  }
}

}  // namespace
