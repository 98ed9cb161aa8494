// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/neighbour_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "hard_sphere/event_simulation.h"
#include "hard_sphere/gas_of_spheres.h"
#include "hard_sphere/neighbour_list_check.h"

namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

TEST(PeriodicBox, FractionInvertsTheEdges) {
  const PeriodicBox::Edges h{2.0, 3.0, 5.0, -1.1, 0.7, 0.9};
  const Vector3 f{0.3, -0.6, 1.7}, back = PeriodicBox::fraction(h, h * f);
  EXPECT_NEAR(back.x, f.x, 4e-16);
  EXPECT_NEAR(back.y, f.y, 4e-16);
  EXPECT_NEAR(back.z, f.z, 4e-16);
}

TEST(PeriodicBox, InverseWidthIsTheLargestFractionOfAUnitLength) {
  const PeriodicBox::Edges h{2.0, 3.0, 5.0, -1.1, 0.7, 0.9};
  const auto inverse_widths = PeriodicBox::inverse_widths(h);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  double most[3] = {};
  for (int n = 0; n < 100000; n++) {
    const Vector3 distance{normal(random), normal(random), normal(random)};
    const Vector3 f = PeriodicBox::fraction(h, (1.0 / norm(distance)) * distance);
    const double coordinates[] = {f.x, f.y, f.z};
    for (int k = 0; k < 3; k++) most[k] = std::max(most[k], std::abs(coordinates[k]));
  }
  // One of 1e5 random directions is within 2 sqrt(1e-5) of each direction; its cosine differs by
  // 2e-5.
  for (int k = 0; k < 3; k++) {
    EXPECT_LE(most[k], inverse_widths[k] * (1.0 + 1e-15));
    EXPECT_GT(most[k], inverse_widths[k] * (1.0 - 1e-4));
  }
}

const ImpactLaw sticky{0.95, 0.2, 0.2};

TEST(PeriodicBox, GradientGivesTheFlowVelocity) {
  PeriodicBox box;
  box.edges = {2.0, 3.0, 5.0, -1.1, 0.7, 0.9};
  box.rates = {0.3, -0.2, 0.1, 0.6, -0.5, 0.8};
  const Vector3 f{0.3, -0.6, 1.7};
  const Vector3 flow = box.rates * f, by_place = box.gradient() * (box.edges * f);
  EXPECT_NEAR(by_place.x, flow.x, 1e-15);
  EXPECT_NEAR(by_place.y, flow.y, 1e-15);
  EXPECT_NEAR(by_place.z, flow.z, 1e-15);
}

/// Checks at eight times of a run that lists are complete and no cores overlap. In the middle of
/// the run all lists are rebuilt, while the box has deformed and bodies are far from their first
/// positions.
void expect_complete_lists(EventSimulation& simulation, const PeriodicBox& box, double time,
                           double round_off = 1e-12) {
  const double lifetime = box.rates.is_zero() ? never : 0.3 * time;
  simulation.reset_time(box);
  simulation.set_up(lifetime, {});
  NeighbourListCheck at_start(simulation, round_off);
  at_start.check();
  std::vector<VersionedFlight> first = simulation.flights;
  std::size_t events = 0;
  int within = 0;
  for (int n = 0; n < 16; n++) {
    simulation.begin_step(time / 16.0);
    simulation.run(simulation.end());
    events += simulation.events.size();
    if (n == 7) simulation.set_up(lifetime, simulation.bound_pairs_at_edge());
    if (n % 2 == 0) continue;
    NeighbourListCheck lists(simulation, round_off);
    lists.check();
    within += lists.within;
  }
  EXPECT_GT(within, 0);
  EXPECT_GT(events, 3 * simulation.bodies.size());
  double distance = 0.0, radius = 0.0;
  for (std::size_t n = 0; n < first.size(); n++) {
    distance += norm(simulation.flights[n].at(time) - first[n].position);
    radius += simulation.neighbour_lists().margin * simulation.bodies[n].radius;
  }
  EXPECT_GT(distance, radius) << "bodies have not left their neighbourhoods";
}

constexpr PeriodicBox::Edges cube(double length) { return {length, length, length, 0, 0, 0}; }

class NeighbourListsWithMargin : public testing::TestWithParam<double> {
 protected:
  EventSimulation simulation;

  void SetUp() override {
    simulation.neighbour_lists().margin = GetParam();
    simulation.pairs.set(0, 0, contact(sticky, 1.4));
    simulation.rules.collapse_limit = 0;
  }
};

INSTANTIATE_TEST_SUITE_P(All, NeighbourListsWithMargin, testing::Values(0.1, 0.6, 2.0));

TEST_P(NeighbourListsWithMargin, AreCompleteInACube) {
  const PeriodicBox box = periodic_box(cube(6.5));
  GasOfSpheres{120}.fill(simulation, box);
  expect_complete_lists(simulation, box, 6.0);
}

TEST_P(NeighbourListsWithMargin, AreCompleteInATiltedBox) {
  const PeriodicBox box = periodic_box({7.0, 6.0, 6.5, 2.9, -2.1, 3.4});
  GasOfSpheres{120, 0.4, 0.6}.fill(simulation, box);
  expect_complete_lists(simulation, box, 6.0);
}

// A strain of 0.4.
TEST_P(NeighbourListsWithMargin, AreCompleteInAShearedBox) {
  PeriodicBox::Edges rates;
  rates.xy = 0.1 * 6.5;
  const PeriodicBox box = periodic_box(cube(6.5), rates);
  GasOfSpheres{120}.fill(simulation, box);
  expect_complete_lists(simulation, box, 4.0);
}

// Spheres that move with the box stay in their neighbourhoods for a strain of 0.23. Only the flow
// brings neighbourhoods together. The time origin is shifted in the middle.
void expect_complete_lists_in_flow(EventSimulation& simulation, const PeriodicBox& box) {
  simulation.pairs.set(0, 0, contact({1.0, 0.0, 1e-6}, 1.4));
  GasOfSpheres{120, 0.5, 0.5, 1e-3}.fill(simulation, box);
  simulation.reset_time(box);
  simulation.set_up(0.23, {});
  for (int n = 0; n < 20; n++) {
    simulation.begin_step(0.025);
    simulation.run(simulation.end());
    if (n == 6) simulation.shift_time_origin();
    NeighbourListCheck(simulation).check();
  }
}

TEST_P(NeighbourListsWithMargin, AreCompleteInAFlowAlongX) {
  PeriodicBox::Edges rates;
  rates.xy = 6.5;
  expect_complete_lists_in_flow(simulation, periodic_box(cube(6.5), rates));
}

TEST_P(NeighbourListsWithMargin, AreCompleteInAnyFlow) {
  const PeriodicBox box =
      periodic_box({6.5, 6.5, 6.5, -2.0, 2.2, 1.5}, {3.0, -3.0, 0.7, 4.0, -4.0, 3.0});
  expect_complete_lists_in_flow(simulation, box);
}

TEST_P(NeighbourListsWithMargin, AreCompleteInADeformingBox) {
  const PeriodicBox box =
      periodic_box({7.0, 6.5, 6.0, -1.0, 1.2, 2.0}, {0.3, -0.2, 0.1, 0.6, -0.5, -0.8});
  GasOfSpheres{100}.fill(simulation, box);
  expect_complete_lists(simulation, box, 4.0);
}

// An edge of 1.4 diameters and a box of 2.1: a sphere is in its well with several images of another
// one.
TEST_P(NeighbourListsWithMargin, ContainSeveralImagesInASmallBox) {
  const PeriodicBox box = periodic_box({2.1, 2.2, 2.3, 0.2, -0.4, 0.6});
  GasOfSpheres{4}.fill(simulation, box);
  expect_complete_lists(simulation, box, 12.0);
}

TEST_P(NeighbourListsWithMargin, ContainSeveralImagesInASmallShearedBox) {
  PeriodicBox::Edges rates;
  rates.xy = 0.1 * 2.2;
  const PeriodicBox box = periodic_box({2.1, 2.2, 2.3, 0.0, 0.0, -0.4}, rates);
  GasOfSpheres{4}.fill(simulation, box);
  expect_complete_lists(simulation, box, 4.0);
}

TEST_P(NeighbourListsWithMargin, AreCompleteForSizesFromOneToTen) {
  const PeriodicBox box = periodic_box({4.0, 4.5, 4.2, 0.0, 1.0, -1.0});
  GasOfSpheres{150, 0.1, 1.0}.fill(simulation, box);
  expect_complete_lists(simulation, box, 6.0);
}

TEST_P(NeighbourListsWithMargin, AreCompleteForSizesFromOneToTenUnderShear) {
  PeriodicBox::Edges rates;
  rates.xy = 0.1 * 4.5;
  const PeriodicBox box = periodic_box({4.0, 4.5, 4.2, 0.0, 0.0, 0.0}, rates);
  GasOfSpheres{150, 0.1, 1.0}.fill(simulation, box);
  expect_complete_lists(simulation, box, 4.0);
}

TEST_P(NeighbourListsWithMargin, AreCompleteBetweenTwoWalls) {
  PeriodicBox box = periodic_box({6.0, 7.0, 5.0, 0.0, 0.0, 1.3});
  box.periodic[2] = false;
  const HardWall::WallContact rule{sticky, 1.4};
  simulation.walls.push_back({{{Wall::z_plane, 1.0, box.origin.z}, {}}, {rule}});
  simulation.walls.push_back({{{Wall::z_plane, -1.0, box.origin.z + 5.0}, {}}, {rule}});
  GasOfSpheres{70, 0.3, 0.6}.fill(simulation, box);
  expect_complete_lists(simulation, box, 6.0);
  for (const VersionedFlight& flight : simulation.flights) {
    EXPECT_GT(flight.at(simulation.end()).z, box.origin.z + 0.3 - 1e-12);
    EXPECT_LT(flight.at(simulation.end()).z, box.origin.z + 4.7 + 1e-12);
  }
}

// Without a well no pair is closer than the edge; the check tests only that no cores overlap.
TEST_P(NeighbourListsWithMargin, AreCompleteWithoutAWell) {
  simulation.pairs.set(0, 0, contact({0.95, 0.2, 0.0}));
  const PeriodicBox box = periodic_box(cube(6.5));
  GasOfSpheres{120}.fill(simulation, box);
  simulation.reset_time(box);
  simulation.set_up(never, {});
  std::size_t events = 0;
  for (int n = 0; n < 20; n++) {
    simulation.begin_step(0.4);
    simulation.run(simulation.end());
    events += simulation.events.size();
    NeighbourListCheck(simulation).check();
  }
  EXPECT_GT(events, 500u);
}

// Neighbourhoods of adjacent spheres on a lattice touch, to round-off.
TEST(NeighbourLists, AreSymmetricWhenNeighbourhoodsJustTouch) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  for (int n = 0; n < 20; n++) {
    EventSimulation simulation;
    simulation.pairs.set(0, 0, contact({1.0, 0.0, 0.0}));
    const double space = 1.0 + simulation.neighbour_lists().margin;
    const Vector3 first{uniform(random), uniform(random), uniform(random)};
    for (int k = 0; k < 64; k++) {
      HardSphere body;
      body.tag = k + 1;
      body.radius = 0.5;
      body.inverse_mass = 1.0;
      body.inverse_inertia = 10.0;
      simulation.bodies.push_back(body);
      VersionedFlight flight;
      flight.position = first + space * Vector3{double(k % 4), double(k / 4 % 4), double(k / 16)};
      // The neighbourhood of a sphere at rest has the same centre.
      if (k % 8 == 0) flight.velocity = {normal(random), normal(random), normal(random)};
      simulation.flights.push_back(flight);
    }
    simulation.neighbour_lists().bodies_in_box = 64.0;
    simulation.reset_time(periodic_box(cube(4.0 * space)));
    simulation.set_up(never, {});
    NeighbourListCheck(simulation).check();
    if (HasFailure()) return;
    simulation.begin_step(1.0);
    simulation.run(simulation.end());
    NeighbourListCheck(simulation).check();
  }
}

// Magnitudes of small and fast particles in SI units.
TEST(NeighbourLists, AreCompleteInAFastFlow) {
  for (const double z_rate : {0.0, 0.1}) {
    EventSimulation simulation;
    simulation.pairs.set(0, 0, contact({0.95, 0.2, 0.2 * 1e16}, 1.4));
    simulation.rules.collapse_limit = 0;
    PeriodicBox::Edges rates;
    rates.xy = 0.1 * 6.5 * 1e8;
    rates.zz = z_rate * 1e8;
    const PeriodicBox box = periodic_box(cube(6.5), rates);
    GasOfSpheres{120, 0.5, 0.5, 1e8}.fill(simulation, box);
    expect_complete_lists(simulation, box, 4e-8);
  }
}

// Bodies far outside the box, as in an engine that does not wrap positions: their differences have
// larger round-off.
TEST(NeighbourLists, ContainImagesOfBodiesFarOutsideTheBox) {
  for (const double far : {1.0, 300.0, 1024.0}) {
    EventSimulation simulation;
    simulation.pairs.set(0, 0, contact(sticky, 1.4));
    const PeriodicBox box = periodic_box({7.0, 6.0, 6.5, 2.9, -2.1, 3.4});
    GasOfSpheres{100}.fill(simulation, box);
    int n = 0;
    for (VersionedFlight& flight : simulation.flights) {
      const Vector3 boxes{far * (n % 5 - 2), far * (n % 7 - 3), far * (n % 3 - 1)};
      flight.position += box.edges * boxes;
      n++;
    }
    expect_complete_lists(simulation, box, 6.0, 1e-12 * far);
  }
}

// Bodies that have left the box in all directions have neighbours with very many different images.
TEST(NeighbourLists, HandleVeryManyImages) {
  EventSimulation near, far;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<int> boxes_gone(-100, 100);
  const int edge = 20;
  const double space = 1.3;
  const PeriodicBox box = periodic_box(cube(edge * space));
  for (EventSimulation* gas : {&near, &far}) {
    gas->pairs.set(0, 0, contact(ImpactLaw{}));
    gas->neighbour_lists().margin = 0.65;
    for (int k = 0; k < edge * edge * edge; k++) {
      HardSphere body;
      body.tag = k + 1;
      body.radius = 0.5;
      body.inverse_mass = 1.0;
      gas->bodies.push_back(body);
      VersionedFlight flight;
      flight.position =
          space * Vector3{double(k % edge), double(k / edge % edge), double(k / edge / edge)};
      if (gas == &far) {
        const Vector3 boxes{double(boxes_gone(random)), double(boxes_gone(random)),
                            double(boxes_gone(random))};
        flight.position += box.edges * boxes;
      }
      gas->flights.push_back(flight);
    }
    gas->neighbour_lists().bodies_in_box = static_cast<double>(gas->bodies.size());
    gas->reset_time(box);
    gas->set_up(never, {});
  }
  const auto neighbours = [](EventSimulation& gas, int i) {
    std::map<int, double> all;
    const auto& lists = gas.neighbour_lists();
    for (const Neighbour* n = lists.begin(i); n != lists.end(i); n++)
      all[n->body] = gas.distance(i, *n, 0.0);
    return all;
  };
  for (int i = 0; i < edge * edge * edge; i++) {
    const auto near_neighbours = neighbours(near, i), far_neighbours = neighbours(far, i);
    ASSERT_EQ(near_neighbours.size(), 6u);
    ASSERT_EQ(far_neighbours.size(), 6u);
    for (const auto& [body, distance] : near_neighbours) {
      ASSERT_TRUE(far_neighbours.count(body));
      ASSERT_NEAR(far_neighbours.at(body), distance, 1e-10);
    }
  }
}

TEST(NeighbourLists, OmitExcludedPairs) {
  EventSimulation simulation;
  simulation.pairs = PairRules(3);
  for (int i = 0; i < 3; i++)
    for (int j = i; j < 3; j++) simulation.pairs.set(i, j, contact(sticky, 1.4));
  simulation.pairs.exclude(0, 2);
  simulation.pairs.exclude_groups(1, 2);
  std::vector<TagPair> bonded;
  for (std::int64_t tag = 0; tag < 200; tag++) bonded.push_back({tag, tag + 7});
  simulation.pairs.exclude_pairs(bonded);
  const PeriodicBox box = periodic_box(cube(6.5));
  GasOfSpheres{100}.fill(simulation, box);
  for (std::size_t n = 0; n < simulation.bodies.size(); n++) {
    HardSphere& body = simulation.bodies[n];
    body.material = static_cast<int>(n % 3);
    body.group_bits = 1 << n % 4;
    if (n % 5 == 0) body.inverse_mass = body.inverse_inertia = 0.0;
    if (n % 5 == 0) simulation.flights[n].velocity = {};
  }
  simulation.reset_time(box);
  simulation.set_up(never, {});
  const auto forbidden = [&](int i, int j) {
    const HardSphere &a = simulation.bodies[i], &b = simulation.bodies[j];
    return std::abs(a.tag - b.tag) == 7 ||
           (std::min(a.material, b.material) == 0 && std::max(a.material, b.material) == 2) ||
           (a.group_bits | b.group_bits) == 3 || a.inverse_mass + b.inverse_mass == 0.0;
  };
  for (int n = 0; n < 20; n++) {
    simulation.begin_step(0.2);
    simulation.run(simulation.end());
    const auto& lists = simulation.neighbour_lists();
    for (int i = 0; i < 100; i++)
      for (const Neighbour* b = lists.begin(i); b != lists.end(i); b++)
        EXPECT_FALSE(forbidden(i, b->body));
    for (int i = 0; i < 100; i++)
      for (int j = 0; j < i; j++)
        if (!forbidden(i, j))
          for_each_image(
              box, simulation.end(),
              simulation.flights[j].at(simulation.end()) -
                  simulation.flights[i].at(simulation.end()),
              1, [&](const Vector3&, const Vector3& r) { EXPECT_GT(norm(r), 1.0 - 1e-12); });
  }
}

}  // namespace
