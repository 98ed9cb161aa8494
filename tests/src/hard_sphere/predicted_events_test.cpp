// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/predicted_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace cohesion::hard_sphere;

constexpr int capacity = 4;

bool by_partner(const PredictedEvent& a, const PredictedEvent& b) { return a.partner < b.partner; }

TEST(PredictedEvents, AreWholeCacheLines) {
  EXPECT_EQ(sizeof(PredictedEvents) % 64, 0u);
  EXPECT_EQ(alignof(PredictedEvents), 64u);
}

TEST(PredictedEvents, EndAtTheHorizon) {
  PredictedEvents events;
  EXPECT_TRUE(events.empty());
  EXPECT_EQ(events.next_time(), never);
  events.reset(2.0);
  EXPECT_EQ(events.next_time(), 2.0);
  events.add({2.0, 0, 0, 0, Surface::core}, by_partner);
  events.add({3.0, 1, 0, 0, Surface::core}, by_partner);
  EXPECT_TRUE(events.empty());
  EXPECT_EQ(events.horizon(), 2.0);
  events.add({1.0, 2, 5, 6, Surface::edge_outward}, by_partner);
  EXPECT_EQ(events.next_time(), 1.0);
  EXPECT_EQ(events.front().partner, 2);
  EXPECT_EQ(events.front().version, 5u);
  EXPECT_EQ(events.front().image, 6);
  EXPECT_EQ(events.front().surface, Surface::edge_outward);
  events.pop();
  EXPECT_TRUE(events.empty());
  EXPECT_EQ(events.next_time(), 2.0);
}

// In any order of insertion, with any number of ties: the list contains the first events before the
// horizon, and the first one beyond the capacity is the new horizon.
TEST(PredictedEvents, KeepTheFirstOfASortedMap) {
  std::mt19937 random(5);
  PredictedEvents events;
  for (int n = 0; n < 100000; n++) {
    const int count = static_cast<int>(random() % 12), times = 1 + static_cast<int>(random() % 8);
    const double horizon = random() % 3 ? static_cast<double>(random() % 9) : never;
    std::vector<int> partners(count);
    for (int k = 0; k < count; k++) partners[k] = k - 2;
    std::shuffle(partners.begin(), partners.end(), random);
    std::multimap<std::pair<double, int>, int> reference;
    events.reset(horizon);
    for (const int partner : partners) {
      const double time = static_cast<double>(random() % times);
      events.add({time, partner, 0, 0, Surface::core}, by_partner);
      if (time < horizon) reference.insert({{time, partner}, partner});
    }
    double next_horizon = horizon;
    if (reference.size() > capacity) {
      const auto first_left_out = std::next(reference.begin(), capacity);
      next_horizon = first_left_out->first.first;
      reference.erase(first_left_out, reference.end());
    }
    ASSERT_EQ(events.horizon(), next_horizon);
    for (const auto& [key, partner] : reference) {
      ASSERT_FALSE(events.empty());
      ASSERT_EQ(events.next_time(), key.first);
      ASSERT_EQ(events.front().partner, partner);
      events.pop();
    }
    ASSERT_TRUE(events.empty());
    ASSERT_EQ(events.next_time(), next_horizon);
  }
}

}  // namespace
