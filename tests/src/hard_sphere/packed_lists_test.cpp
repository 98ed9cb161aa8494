// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/packed_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using cohesion::hard_sphere::PackedLists;

/// Expects the contents of separate lists.
void expect_same(const PackedLists<int>& lists, const std::vector<std::vector<int> >& reference) {
  for (int n = 0; n < static_cast<int>(reference.size()); n++)
    ASSERT_TRUE(std::equal(lists.begin(n), lists.end(n), reference[n].begin(), reference[n].end()));
}

TEST(PackedLists, UseNoMemoryAtFirst) {
  PackedLists<int> lists;
  lists.reset({});
  EXPECT_EQ(lists.bytes(), 0.0);
}

TEST(PackedLists, EqualSeparateLists) {
  std::mt19937 random(2);
  PackedLists<int> lists;
  for (const int number : {1, 2, 17, 60, 5}) {
    std::vector<int> capacities(number);
    for (int& capacity : capacities) capacity = static_cast<int>(random() % 4);
    lists.reset(capacities);
    std::vector<std::vector<int> > reference(number);
    expect_same(lists, reference);
    for (int n = 0; n < 20000; n++) {
      const int list = static_cast<int>(random() % number);
      auto& expected = reference[list];
      const unsigned what = random() % 100;
      if (what < 52 || expected.empty()) {
        lists.add(list, n);
        expected.push_back(n);
      } else {
        const std::size_t at = random() % expected.size();
        lists.remove(list, lists.begin(list) + at);
        expected[at] = expected.back();
        expected.pop_back();
      }
      ASSERT_TRUE(std::equal(lists.begin(list), lists.end(list), expected.begin(), expected.end()));
      if (n % 100 == 0) expect_same(lists, reference);
    }
    expect_same(lists, reference);
  }
}

// Capacities double: the unused memory is at most as large as the used one.
TEST(PackedLists, MemoryIsAFewTimesTheirItems) {
  PackedLists<int> lists;
  lists.reset(std::vector<int>(100, 0));
  for (int n = 0; n < 100000; n++) lists.add(n % 100, n);
  EXPECT_LT(lists.bytes(), 100000 * 4 * sizeof(int) * 2 + 100 * 64);
}

}  // namespace
