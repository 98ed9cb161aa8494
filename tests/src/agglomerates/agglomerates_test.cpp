// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "agglomerates/disjoint_sets.h"
#include "agglomerates/fragment.h"
#include "agglomerates/membership.h"
#include "agglomerates/size_statistics.h"

namespace cohesion::agglomerates {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

}  // namespace

TEST(DisjointSets, AreThoseOfAWalkOverTheBonds) {
  std::mt19937 random(11);
  const int n = 500;
  std::uniform_int_distribution<int> any(0, n - 1);
  DisjointSets sets;
  sets.reset(3);
  sets.reset(n);
  std::vector<std::vector<int>> partners(n);
  for (int k = 0; k < 300; k++) {
    const int i = any(random), j = any(random);
    sets.join(i, j);
    partners[i].push_back(j);
    partners[j].push_back(i);
  }
  std::vector<int> set_of(n, -1);
  for (int first = 0; first < n; first++) {
    if (set_of[first] >= 0) continue;
    std::vector<int> members{first};
    set_of[first] = first;
    for (std::size_t k = 0; k < members.size(); k++)
      for (const int j : partners[members[k]])
        if (set_of[j] < 0) {
          set_of[j] = first;
          members.push_back(j);
        }
    for (const int i : members) {
      EXPECT_EQ(sets.root(i), sets.root(first));
      EXPECT_EQ(sets.size(i), static_cast<int>(members.size()));
    }
  }
  for (int k = 0; k < 2000; k++) {
    const int i = any(random), j = any(random);
    EXPECT_EQ(sets.root(i) == sets.root(j), set_of[i] == set_of[j]);
  }
}

TEST(DisjointSets, AChainOfAnyLengthIsOne) {
  DisjointSets sets;
  const int n = 1000000;  // joined end to end: without halving a walk of n for every look
  sets.reset(n);
  for (int i = n - 1; i > 0; i--) sets.join(i, i - 1);
  for (int i = 0; i < n; i++) ASSERT_EQ(sets.root(i), sets.root(0));
  EXPECT_EQ(sets.size(7), n);
}

TEST(Fragments, OfTwoRanksMergeToThatOfOne) {
  const std::vector<Vector3> places{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}};
  Fragment whole{4.0};
  for (const Vector3& position : places) whole.add(position);
  std::vector<Fragment> parts;
  for (const Vector3& position : places) {
    parts.push_back({4.0});
    parts.back().add(position);
    parts.push_back({2.0});
    parts.back().add(Vector3{5.0, 5.0, 5.0});
  }
  parts[2].wraps = 1.0;
  const std::vector<Fragment> together = merge_fragments(parts);
  ASSERT_EQ(together.size(), 2u);
  EXPECT_EQ(together[0].label, 2.0);
  EXPECT_EQ(together[0].count, 4.0);
  // The root of a difference of squares: of the rounding of 75.
  EXPECT_NEAR(radius_of_gyration(together[0]), 0.0, std::sqrt(4 * 75 * eps));
  EXPECT_EQ(together[1].count, 4.0);
  EXPECT_EQ(together[1].wraps, 1.0);
  EXPECT_EQ(radius_of_gyration(together[1]), radius_of_gyration(whole));
  EXPECT_EQ(extent(together[1]).gyration, Extent::endless);
  EXPECT_EQ(extent(whole).gyration, radius_of_gyration(whole));
  EXPECT_EQ(extent(whole).count, 4.0);
  // Variances of 0, 1, 2, 2 and of 0, 0, 0, 1.
  EXPECT_NEAR(radius_of_gyration(whole), std::sqrt(0.6875 + 0.1875), 4 * eps);
}

TEST(Membership, LastsFromTheFirstPartnerToTheLossOfTheLast) {
  Membership m = Membership::at_first(false);
  EXPECT_LT(m.update(false, 1.0), 0.0);
  EXPECT_LT(m.update(true, 2.0), 0.0);
  EXPECT_LT(m.update(true, 3.0), 0.0);  // whatever partners came and went
  EXPECT_EQ(m.update(false, 5.5), 3.5);
  EXPECT_LT(m.update(false, 6.0), 0.0);
  EXPECT_LT(m.update(true, 7.0), 0.0);
  EXPECT_EQ(m.update(false, 8.0), 1.0);
}

TEST(Membership, WhoseBeginningWasNotSeenDoesNotCount) {
  Membership m = Membership::at_first(true);
  EXPECT_LT(m.update(true, 0.0), 0.0);
  EXPECT_LT(m.update(false, 4.0), 0.0);
  EXPECT_LT(m.update(true, 5.0), 0.0);
  EXPECT_EQ(m.update(false, 6.0), 1.0);
}

TEST(SizeDistribution, PutsLargeOnesInTheLastEntry) {
  SizeDistribution d(4);
  for (const double size : {1.0, 2.0, 2.0, 4.0, 9.0}) d.add(size);
  EXPECT_EQ(d.current(), (std::vector<double>{1.0, 2.0, 0.0, 2.0}));
  d.add_time(0.5);
  d.clear();
  d.add(3.0, 7.0);
  d.add_time(2.0);
  EXPECT_EQ(d.sums(), (std::vector<double>{0.5, 1.0, 14.0, 1.0}));
}

TEST(TimeWeightedSize, LeavesOutTimesWithoutAgglomerates) {
  TimeWeightedSize size;
  EXPECT_EQ(size.mean(), 0.0);
  size.add_time(1.0, 2.0, 6.0);
  size.add_time(5.0, 0.0, 0.0);
  size.add_time(3.0, 1.0, 7.0);
  EXPECT_EQ(size.mean(), 6.0);
}

}  // namespace cohesion::agglomerates
