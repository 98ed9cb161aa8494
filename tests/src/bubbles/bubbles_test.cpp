// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "bubbles/population.h"
#include "refuses.h"

namespace cohesion::bubbles {
namespace {

const BubbleBox box{{0.0, 0.0, 0.0}, {1.0, 1.0, 3.0}, {false, true, false}};
constexpr double rounding = 1e-15;

Bubble bubble(long number, const Vector3& at, double radius, const Vector3& velocity = {}) {
  return {number, at, velocity, radius, 0.4 * sphere_volume(radius)};
}

std::vector<Bubble> swarm(int n) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0.1, 0.9);
  std::vector<Bubble> all;
  for (int i = 0; i < n; i++)
    all.push_back(bubble(i + 1, {any(random), any(random), 3.0 * any(random)},
                         0.03 + 0.03 * any(random), {any(random), -any(random), any(random)}));
  return all;
}

struct Sums {
  double volume = 0.0;
  Vector3 momentum, moment;
};

Sums sums(const std::vector<Bubble>& bubbles) {
  Sums all;
  for (const Bubble& one : bubbles) {
    all.volume += one.volume();
    all.momentum += one.mass * one.velocity;
    all.moment += one.mass * one.position;
  }
  return all;
}

void expect_same(const Sums& a, const Sums& b, double tolerance) {
  EXPECT_NEAR(a.volume, b.volume, tolerance * a.volume);
  for (const auto& [p, q] : {std::pair(a.momentum, b.momentum), std::pair(a.moment, b.moment)})
    EXPECT_LE(norm(p - q), tolerance * (norm(p) + norm(q)));
}

/// The bubbles there are after a round.
std::vector<Bubble> left(const std::vector<Bubble>& bubbles, const Events& events) {
  std::vector<Bubble> all;
  for (std::size_t i = 0; i < bubbles.size(); i++)
    if (!events.gone[i]) all.push_back(bubbles[i]);
  for (const auto& fresh : events.born) all.push_back(fresh.bubble);
  return all;
}

}  // namespace

TEST(Bubbles, MergedKeepVolumeMomentumAndCentreOfMass) {
  const Bubble a = bubble(3, {0.2, 0.3, 0.4}, 0.03, {1.0, 0.0, 0.5});
  const Bubble b = bubble(8, {0.24, 0.31, 0.42}, 0.05, {-0.2, 0.7, 0.1});
  const Bubble one = merged(a, b, box);
  EXPECT_EQ(one.number, 3);
  EXPECT_NEAR(one.mass / (a.mass + b.mass), 1.0, rounding);
  expect_same(sums({a, b}), sums({one}), 4 * rounding);
}

TEST(Bubbles, MergeAcrossPeriodicBordersOnly) {
  const Bubble low = bubble(1, {0.5, 0.01, 1.0}, 0.03), high = bubble(2, {0.5, 0.98, 1.0}, 0.03);
  EXPECT_EQ(mergers({low, high}, box, 1.0, 0.0).size(), 1u);
  EXPECT_NEAR(merged(low, high, box).position.y, -0.005, rounding);
  EXPECT_TRUE(
      mergers({bubble(1, {0.01, 0.5, 1.0}, 0.03), bubble(2, {0.98, 0.5, 1.0}, 0.03)}, box, 1.0, 0.0)
          .empty());
  const BubbleBox upright{box.low, box.high, {false, false, true}};
  EXPECT_EQ(mergers({bubble(1, {0.5, 0.5, 0.01}, 0.03), bubble(2, {0.5, 0.5, 2.98}, 0.03)}, upright,
                    1.0, 0.0)
                .size(),
            1u);
}

TEST(Bubbles, TouchingAreThoseThatAllPairsFind) {
  const auto all = swarm(400);
  std::vector<std::pair<std::size_t, std::size_t>> slow;
  for (std::size_t i = 0; i < all.size(); i++)
    for (std::size_t j = i + 1; j < all.size(); j++)
      if (norm(box.between(all[i].position, all[j].position)) <= all[i].radius + all[j].radius)
        slow.emplace_back(i, j);
  EXPECT_GT(slow.size(), 20u);
  EXPECT_EQ(touching(all, box), slow);
}

TEST(Bubbles, MergeOnceARoundUpToTheLargest) {
  // In a row 1-2-3, and 4-5 too large together.
  const std::vector<Bubble> row{bubble(1, {0.5, 0.5, 1.0}, 0.03), bubble(2, {0.5, 0.5, 1.05}, 0.03),
                                bubble(3, {0.5, 0.5, 1.1}, 0.03), bubble(4, {0.5, 0.5, 2.0}, 0.05),
                                bubble(5, {0.5, 0.5, 2.05}, 0.05)};
  const auto found = mergers(row, box, 0.08, 0.0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].into, 0u);
  EXPECT_EQ(found[0].gone, 1u);
}

TEST(Bubbles, RestBeforeTheyMerge) {
  auto a = bubble(1, {0.5, 0.5, 1.0}, 0.03);
  a.rests_until = 2.0;
  const auto b = bubble(2, {0.5, 0.5, 1.05}, 0.03);
  EXPECT_TRUE(mergers({a, b}, box, 1.0, 1.9).empty());
  EXPECT_EQ(mergers({a, b}, box, 1.0, 2.0).size(), 1u);
}

TEST(Bubbles, BreakIntoHalvesThatKeepItsSumsAndFitTheBox) {
  for (long number = 1; number < 40; number++) {
    const Bubble whole = bubble(number, {0.05, 0.5, 1.0}, 0.04, {0.3, 0.2, 0.7});
    const auto halves = broken(whole, 99, box, 5.0);
    ASSERT_TRUE(halves);
    expect_same(sums({whole}), sums({halves->first, halves->second}), 8 * rounding);
    EXPECT_NEAR(
        norm(halves->first.position - halves->second.position) / (2.2 * halves->first.radius), 1.0,
        1e-14);
    EXPECT_EQ(halves->second.number, 99);
    EXPECT_EQ(halves->first.rests_until, 5.0);
    EXPECT_GE(halves->first.position.x, halves->first.radius);
    EXPECT_GE(halves->second.position.x, halves->second.radius);
  }
  EXPECT_FALSE(broken(bubble(1, {0.5, 0.5, 0.01}, 0.04), 2, box, 0.0));
}

TEST(Bubbles, RoundsKeepCountAndVolume) {
  Rules rules;
  rules.top = 2.5;
  rules.merge_up_to = 0.14;
  rules.break_above = 0.12;
  rules.rest = 0.05;
  rules.density = 0.4;
  rules.velocity = {0.0, 0.0, 0.5};
  Nozzles nozzles(3, 3, {0.5, 0.5, 0.1}, 0.2, 0.02, sphere_volume(0.04));
  nozzles.grow_up_to(sphere_volume(0.06));
  std::vector<Bubble> bubbles;
  BubbleTotals totals;
  long next = 1;
  double time = 0.0;
  for (int round = 0; round < 4000; round++) {
    time += 0.005;
    nozzles.flow_on(0.005);
    const Events events = round_of_events(bubbles, rules, box, &nozzles, time, next, totals);
    bubbles = left(bubbles, events);
    std::sort(bubbles.begin(), bubbles.end(),
              [](const Bubble& a, const Bubble& b) { return a.number < b.number; });
    for (Bubble& one : bubbles) {
      // Some of them meet.
      const double phase = static_cast<double>(one.number) + time;
      one.position += 0.005 * Vector3{0.3 * std::sin(phase), 0.3 * std::cos(3.0 * phase), 0.4};
      one.position.x = std::clamp(one.position.x, one.radius, 1.0 - one.radius);
    }
  }
  EXPECT_GT(totals.removed, 100.0);
  EXPECT_GT(totals.merged, 50.0);
  EXPECT_GT(totals.broken, 20.0);
  EXPECT_EQ(static_cast<double>(bubbles.size()),
            totals.injected - totals.removed - totals.merged + totals.broken);
  // Each of some 1e4 events rounds a radius, and so three times its volume.
  EXPECT_NEAR((sums(bubbles).volume + totals.removed_volume) / totals.injected_volume, 1.0, 1e-12);
  // The flow is what was given and what is pending, but for what was pending at the start.
  double pending = 0.0;
  for (const double of_one : nozzles.pending()) pending += of_one;
  EXPECT_NEAR(totals.injected_volume + pending, 0.02 * time, 9.0 * nozzles.volume());
}

TEST(Bubbles, NozzlesGiveTheFlowInTurnAndWaitWhereTheyAreBlocked) {
  const double volume = sphere_volume(0.04);
  Nozzles nozzles(2, 1, {0.5, 0.5, 0.1}, 0.4, 10.0 * volume, volume);
  EXPECT_NEAR(nozzles.place(0).x, 0.3, rounding);
  const std::vector<Bubble> blocking{bubble(1, {0.3, 0.5, 0.15}, 0.04)};
  int first = 0, second = 0;
  for (int k = 0; k < 100; k++) {
    nozzles.flow_on(0.01);
    first += nozzles.gives(0, blocking, box) > 0.0;
    second += nozzles.gives(1, blocking, box) > 0.0;
  }
  EXPECT_EQ(first, 0);
  EXPECT_EQ(second, 5);
  EXPECT_NEAR(nozzles.pending()[0] / volume, 5.0, 1e-12);
}

TEST(Bubbles, BubblesThatWaitGrowAsFarAsThereIsRoomUpToALimit) {
  const double volume = sphere_volume(0.04);
  const auto one_nozzle = [&] {
    Nozzles nozzles(1, 1, {0.5, 0.5, 0.1}, 0.4, 10.0 * volume, volume);
    nozzles.grow_up_to(2.0 * volume);
    return nozzles;
  };
  auto free = one_nozzle(), close = one_nozzle(), blocked = one_nozzle();
  EXPECT_EQ(free.most(), 2.0 * volume);
  for (Nozzles* nozzles : {&free, &close, &blocked}) nozzles->flow_on(0.15);
  // It began with none: the golden section has no turn for the first.
  EXPECT_NEAR(free.gives(0, {}, box) / volume, 1.5, 4 * rounding);
  EXPECT_NEAR(free.pending()[0] / volume, 0.0, 4 * rounding);
  const double room = 0.042;
  const std::vector<Bubble> near{bubble(1, {0.5, 0.5, 0.1 + room + 0.03}, 0.03)};
  // Of the sum that is the height, and three times in the volume.
  EXPECT_NEAR(close.gives(0, near, box) / sphere_volume(room), 1.0, 100 * rounding);
  const std::vector<Bubble> touching{bubble(1, {0.5, 0.5, 0.1 + 0.039 + 0.03}, 0.03)};
  EXPECT_EQ(blocked.gives(0, touching, box), 0.0);
  blocked.flow_on(0.15);
  EXPECT_NEAR(blocked.gives(0, {}, box) / volume, 2.0, 4 * rounding);
  EXPECT_NEAR(blocked.pending()[0] / volume, 1.0, 8 * rounding);
}

TEST(Bubbles, NozzlesBlowIntoTheNearestThatMayMerge) {
  const double volume = sphere_volume(0.04);
  Nozzles nozzles(1, 1, {0.5, 0.5, 0.1}, 0.4, 10.0 * volume, volume);
  nozzles.flow_on(0.25);
  std::vector<Bubble> all{bubble(1, {0.5, 0.5, 0.19}, 0.06), bubble(2, {0.5, 0.5, 0.16}, 0.04),
                          bubble(3, {0.5, 0.52, 0.11}, 0.04)};
  all[2].rests_until = 1.0;
  const std::vector<bool> gone(3, false);
  // Room for a bubble more in the second alone, but it is not all there.
  EXPECT_FALSE(nozzles.feeds(0, all, gone, box, 1.9 * volume, 0.0));
  EXPECT_FALSE(nozzles.feeds(0, all, {true, true, false}, box, 100.0 * volume, 0.0));
  const auto fed = nozzles.feeds(0, all, gone, box, 100.0 * volume, 0.0);
  ASSERT_TRUE(fed);
  EXPECT_EQ(fed->bubble, 1U);
  EXPECT_EQ(fed->volume, volume);
  EXPECT_NEAR(nozzles.pending()[0] / volume, 1.5, 8 * rounding);
  EXPECT_EQ(nozzles.feeds(0, all, gone, box, 100.0 * volume, 2.0)->bubble, 2U);
}

TEST(Bubbles, WhatNozzlesBlowIntoABubbleKeepsTheSums) {
  const double volume = sphere_volume(0.04);
  Nozzles nozzles(1, 1, {0.5, 0.5, 0.1}, 0.4, 10.0 * volume, volume);
  nozzles.flow_on(0.15);
  Rules rules;
  rules.density = 0.4;
  rules.velocity = {0.0, 0.0, 0.8};
  rules.merge_up_to = 0.3;
  std::vector<Bubble> all{bubble(1, {0.5, 0.52, 0.15}, 0.05, {0.1, 0.0, -0.2})};
  std::vector<Bubble> apart = all;
  apart.push_back(bubble(2, nozzles.place(0), 0.04, rules.velocity));
  BubbleTotals totals;
  long next = 2;
  const Events events = round_of_events(all, rules, box, &nozzles, 0.0, next, totals);
  ASSERT_EQ(events.fed.size(), 1U);
  EXPECT_TRUE(events.born.empty());
  expect_same(sums(all), sums(apart), 4 * rounding);
  EXPECT_EQ(totals.injected, 1.0);
  EXPECT_EQ(totals.merged, 1.0);
}

TEST(Bubbles, NozzlesRefuseWhatCannotBe) {
  expect_refused([] { Nozzles(0, 1, {}, 0.1, 1.0, 1.0); }, "nozzles along x = 0");
  expect_refused([] { Nozzles(1, 1, {}, 0.1, -1.0, 1.0); }, "flow of the nozzles = -1");
  expect_refused([] { Nozzles(1, 1, {}, 0.1, 1.0, 0.0); }, "volume of a bubble = 0");
  expect_refused([] { Nozzles(1, 1, {}, 0.1, 1.0, 1.0).grow_up_to(0.5); },
                 "volume that bubbles grow to = 0.5");
}

}  // namespace cohesion::bubbles
