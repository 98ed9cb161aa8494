// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "hard_sphere/event_simulation.h"
#include "hard_sphere/gas_of_spheres.h"
#include "hard_sphere/neighbour_list_check.h"

// Steps of an engine that changes flights: by forces, by moving walls, by relocation of bodies.
namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

const ImpactLaw sticky{0.9, 0.3, 0.2};
constexpr double dt = 0.02;

/// A box of walls with a moving floor, gravity and immobile spheres.
struct Shaker {
  BoxOfSpheres box{3, sticky};
  double gravity;
  double work = 0.0, dissipated = 0.0;  // work of gravity and floor; dissipation by events
  std::size_t events = 0;

  Shaker(double acceleration, bool frozen) : gravity(acceleration) {
    EventSimulation& simulation = box.simulation;
    simulation.walls[2].moves = true;
    for (std::size_t n = 0; frozen && n < simulation.bodies.size(); n += 2) {
      simulation.bodies[n].inverse_mass = simulation.bodies[n].inverse_inertia = 0.0;
      simulation.flights[n].velocity = {};
    }
    simulation.set_up(never, {});
  }

  /// The floor is at 0.05 (1 - cos(2 t)), with constant velocity in each step.
  void move_floor() {
    EventSimulation& simulation = box.simulation;
    MovingWall& floor = simulation.walls[2].motion;
    const auto height = [](double t) { return -0.05 * (1.0 - std::cos(2.0 * t)); };
    const double from = height(simulation.start()), to = height(simulation.end());
    floor.state = {{0.0, to, 0.0}, {0.0, (to - from) / dt, 0.0}};
    floor.when = simulation.end();
  }

  void accelerate() {
    EventSimulation& simulation = box.simulation;
    const int count = static_cast<int>(simulation.bodies.size());
    for (int i = 0; i < count; i++) {
      HardSphere& body = simulation.bodies[i];
      if (body.inverse_mass == 0.0) continue;
      increment_velocity(simulation, i, {0.0, -gravity * dt, 0.0});
      body.speed_increment = gravity * dt;
    }
    for (int i = 0; i < count; i++)
      if (simulation.bodies[i].inverse_mass > 0.0) simulation.predict(i);
  }

  void step() {
    EventSimulation& simulation = box.simulation;
    simulation.begin_step(dt);
    move_floor();
    const double before = box.kinetic_energy();
    if (gravity > 0.0)
      accelerate();
    else
      simulation.predict_at_moving_walls();
    work += box.kinetic_energy() - before;
    simulation.run(simulation.end());
    for (const Event& event : simulation.events) {
      dissipated -= event.impact.energy_change;
      if (event.with_wall())
        work -= dot(event.impact.impulse, simulation.walls[-1 - event.j].motion.state.velocity);
    }
    events += simulation.events.size();
  }
};

// Each event and each velocity increment rounds energies of order 1 by a few 1e-16.
TEST(Steps, EnergyBalancesWithForcesMovingWallsAndImmobileSpheres) {
  for (const double gravity : {0.0, 0.5})
    for (const bool frozen : {false, true}) {
      Shaker shaker(gravity, frozen);
      EventSimulation& simulation = shaker.box.simulation;
      const double at_start = shaker.box.kinetic_energy();
      for (int n = 0; n < 1000; n++) {
        shaker.step();
        const double rounded = static_cast<double>(shaker.events + 27 * n + 27);
        ASSERT_NEAR(shaker.box.kinetic_energy() - at_start, shaker.work - shaker.dissipated,
                    2e-15 * rounded);
        NeighbourListCheck(simulation).check();
        for (int i = 0; i < 27; i++)
          for (const HardWall& wall : simulation.walls)
            EXPECT_GT(wall.motion.wall
                          .nearest(shaker.box.position(i), wall.motion.at(simulation.end()), 0.0)
                          .distance,
                      simulation.bodies[i].radius - 1e-12);
      }
      EXPECT_GT(shaker.events, 500u);
      ASSERT_LT(simulation.overrun().first, 0);
    }
}

TEST(Steps, EventsAtAWallInUniformMotionAreIndependentOfTheStep) {
  BoxOfSpheres fine(3, sticky), coarse(3, sticky);
  for (BoxOfSpheres* box : {&fine, &coarse}) {
    box->simulation.rules.collapse_limit = 0;
    HardWall& floor = box->simulation.walls[2];
    floor.moves = true;
    floor.motion.state.velocity = {0.3, 0.05, 0.0};
    box->simulation.set_up(never, {});
  }
  for (int n = 0; n < 512; n++) fine.step(1.0 / 128.0);
  for (int n = 0; n < 2; n++) coarse.step(2.0);
  ASSERT_GT(coarse.all.size(), 100u);
  ASSERT_EQ(fine.all.size(), coarse.all.size());
  for (std::size_t n = 0; n < fine.all.size(); n++)
    EXPECT_TRUE(same_bits(fine.all[n], coarse.all[n])) << n;
}

/// Two identical simulations, one of which shifts its time origin from time to time. They differ by
/// the round-off of positions, 1e-16 of a box of 7, which every collision multiplies by about (free
/// path)/(radius) ~ 2; a sphere has some 10 collisions in the run.
template <class Fill>
void expect_same_events_after_origin_shift(const Fill& fill, double lifetime) {
  EventSimulation one, other;
  for (EventSimulation* gas : {&one, &other}) {
    gas->rules.collapse_limit = 0;
    fill(*gas);
    gas->set_up(lifetime, {});
  }
  double origin = 0.0;
  std::size_t events = 0;
  for (int n = 0; n < 50; n++) {
    for (EventSimulation* gas : {&one, &other}) {
      gas->begin_step(2.0 * dt);
      gas->run(gas->end());
    }
    ASSERT_EQ(one.events.size(), other.events.size()) << n;
    for (std::size_t k = 0; k < one.events.size(); k++) {
      const Event &a = one.events[k], &b = other.events[k];
      ASSERT_EQ(a.key.tag_i, b.key.tag_i) << n << ' ' << k;
      ASSERT_EQ(a.key.tag_j, b.key.tag_j) << n << ' ' << k;
      ASSERT_EQ(a.impact.kind, b.impact.kind);
      ASSERT_NEAR(a.key.time, b.key.time + origin, 1e-9);
    }
    events += one.events.size();
    for (std::size_t i = 0; i < one.flights.size(); i++)
      ASSERT_LT(norm(one.flights[i].at(one.end()) - other.flights[i].at(other.end())), 1e-9);
    if (n % 3 == 0) {
      origin += other.end();
      other.shift_time_origin();
      EXPECT_EQ(other.end(), 0.0);
    }
    if (n % 10 == 0) NeighbourListCheck(other).check();
  }
  EXPECT_GT(events, 200u);
}

TEST(Steps, ShiftOfTheTimeOriginChangesNoEvent) {
  expect_same_events_after_origin_shift(
      [](EventSimulation& gas) {
        gas.pairs.set(0, 0, contact(sticky, 1.4));
        const PeriodicBox box = periodic_box({7.0, 6.5, 6.0, 1.0, -1.2, 2.1});
        GasOfSpheres{100, 0.4, 0.6}.fill(gas, box);
        gas.reset_time(box);
      },
      never);
}

TEST(Steps, ShiftOfTheTimeOriginChangesNoEventUnderShear) {
  expect_same_events_after_origin_shift(
      [](EventSimulation& gas) {
        gas.pairs.set(0, 0, contact(sticky, 1.4));
        PeriodicBox::Edges rates;
        rates.xy = 0.2 * 6.5;
        const PeriodicBox box = periodic_box({6.5, 6.5, 6.5}, rates);
        GasOfSpheres{100, 0.4, 0.6}.fill(gas, box);
        gas.reset_time(box);
      },
      0.7);
}

TEST(Steps, ShiftOfTheTimeOriginKeepsMovingWalls) {
  for (const double shear : {0.0, 0.2})
    expect_same_events_after_origin_shift(
        [shear](EventSimulation& gas) {
          gas.pairs.set(0, 0, contact(sticky, 1.4));
          PeriodicBox::Edges rates;
          rates.xy = shear * 6.0;
          PeriodicBox box = periodic_box({6.0, 6.0, 5.0}, rates);
          box.periodic[2] = false;
          const HardWall::WallContact rule{sticky, 1.4};
          const WallState rising{{}, {0.0, 0.0, 0.3}};
          const double floor = box.origin.z;
          gas.walls.push_back({{{Wall::z_plane, 1.0, floor}, rising}, {rule}, -1, true});
          gas.walls.push_back({{{Wall::z_plane, -1.0, floor + 5.0}, {}}, {rule}});
          GasOfSpheres{60, 0.4, 0.6}.fill(gas, box);
          gas.reset_time(box);
        },
        shear > 0.0 ? 0.7 : never);
}

/// Changes the flights of random bodies, the same ones in identical simulations.
class Changes {
 public:
  explicit Changes(bool relocate) : relocate_(relocate) {}

  void make(EventSimulation& gas, const PeriodicBox& box) {
    const int count = static_cast<int>(gas.bodies.size());
    std::uniform_real_distribution<double> uniform;
    std::vector<int> changed;
    for (int i = 0; i < count; i++) {
      const bool put = relocate_ && random_() % 20 == 0;
      if (!put && random_() % 5) continue;
      const VersionedFlight flight = gas.flights[i];
      const Vector3 change{uniform(random_) - 0.5, uniform(random_) - 0.5, uniform(random_) - 0.5};
      Vector3 position = flight.at(gas.start());
      for (bool free = !put; !free;) {
        position =
            box.origin + box.edges * Vector3{uniform(random_), uniform(random_), uniform(random_)};
        free = GasOfSpheres::is_free(gas, box, gas.start(), position, gas.bodies[i].radius, i);
      }
      change_flight(gas, i, position, flight.velocity + 0.3 * change, put);
      changed.push_back(i);
    }
    for (const int i : changed) gas.predict(i);
  }

 private:
  bool relocate_;
  std::mt19937 random_{9};
};

/// One simulation keeps its lists, the other one rebuilds them before each step. Expects the same
/// events to the last bit.
void expect_same_events_as_with_new_lists(const ImpactLaw& law, bool relocate) {
  const PeriodicBox box = periodic_box({7.0, 6.5, 6.0, 1.0, -1.2, 2.1});
  EventSimulation one, other;
  Changes changes_of_one(relocate), changes_of_other(relocate);
  for (EventSimulation* gas : {&one, &other}) {
    gas->pairs.set(0, 0, contact(law, 1.4));
    gas->rules.collapse_limit = 0;
    GasOfSpheres{100, 0.4, 0.6}.fill(*gas, box);
    gas->reset_time(box);
    gas->set_up(never, {});
  }
  std::size_t events = 0;
  for (int n = 0; n < 200; n++) {
    other.set_up(never, other.bound_pairs_at_edge());
    for (EventSimulation* gas : {&one, &other}) {
      gas->begin_step(dt);
      (gas == &one ? changes_of_one : changes_of_other).make(*gas, box);
      gas->run(gas->end());
    }
    ASSERT_EQ(one.events.size(), other.events.size()) << n;
    for (std::size_t k = 0; k < one.events.size(); k++)
      ASSERT_TRUE(same_bits(one.events[k], other.events[k])) << n << ' ' << k;
    events += one.events.size();
    if (n % 10 == 0) NeighbourListCheck(one).check();
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(events, 300u);
}

TEST(Steps, ListsStayCompleteWithForces) { expect_same_events_as_with_new_lists(sticky, false); }

TEST(Steps, ListsContainRelocatedBodies) {
  expect_same_events_as_with_new_lists({0.9, 0.3, 0.0}, true);
}

TEST(Steps, WellsOfRelocatedBodiesAreUpdated) {
  expect_same_events_as_with_new_lists(sticky, true);
}

// One body of a bound pair is relocated far away, and later back.
TEST(Steps, RelocatedBodyLeavesItsWellWithoutAnEvent) {
  EventSimulation simulation;
  simulation.pairs.set(0, 0, contact(sticky, 1.5));
  for (int n = 0; n < 2; n++) {
    HardSphere body;
    body.tag = n + 1;
    body.radius = 0.5;
    body.inverse_mass = 1.0;
    body.inverse_inertia = 10.0;
    simulation.bodies.push_back(body);
    simulation.flights.emplace_back();
    simulation.flights[n].position = {1.2 * n, 0.0, 0.0};
  }
  simulation.reset_time(closed_box({-1.0, -1.0, -1.0}, {20.0, 1.0, 1.0}));
  simulation.set_up(never, {});
  const auto is_inside = [&](int i) {
    const Neighbour* pair = simulation.neighbour_lists().find_neighbour(i, 1 - i, 0);
    return pair && pair->inside;
  };
  EXPECT_TRUE(is_inside(0) && is_inside(1));
  for (const int relocated : {1, 0}) {
    for (const double away : {15.0, 0.0}) {
      simulation.begin_step(1.0);
      const double x = relocated == 1 ? 1.2 + away : away > 0.0 ? 16.2 : 0.0;
      change_flight(simulation, relocated, {x, 0.0, 0.0}, {}, true);
      simulation.predict(relocated);
      EXPECT_EQ(is_inside(0), away == 0.0) << relocated;
      EXPECT_EQ(is_inside(1), away == 0.0) << relocated;
      // The other body moves away and returns: there is no well any more.
      change_flight(simulation, 1 - relocated, simulation.flights[1 - relocated].position,
                    {0.0, away > 0.0 ? 0.1 : 0.0, 0.0});
      simulation.predict(1 - relocated);
      simulation.run(simulation.end());
      EXPECT_EQ(simulation.events.size(), 0u);
      simulation.begin_step(1.0);
      change_flight(simulation, 1 - relocated,
                    simulation.flights[1 - relocated].at(simulation.start()),
                    {0.0, away > 0.0 ? -0.1 : 0.0, 0.0});
      simulation.predict(1 - relocated);
      simulation.run(simulation.end());
      EXPECT_EQ(simulation.events.size(), 0u);
    }
  }
}

}  // namespace
