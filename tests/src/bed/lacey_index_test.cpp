// SPDX-License-Identifier: BSD-3-Clause
#include "bed/lacey_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

using cohesion::bed::lacey_index;

namespace {

constexpr double round_off = 1e-14;  // some tens of operations on numbers of 1

TEST(LaceyIndex, IsZeroWhereEachCellHoldsOneColour) {
  EXPECT_NEAR(lacey_index({7, 0, 0, 3, 5, 0, 0, 0}, 2).index, 0.0, round_off);
  EXPECT_NEAR(lacey_index({4, 0, 0, 0, 9, 0, 0, 0, 2}, 3).index, 0.0, round_off);
}

TEST(LaceyIndex, CountsParticlesAndTheCellsThatHoldSome) {
  const auto mixing = lacey_index({7, 0, 0, 3, 5, 1, 0, 0}, 2);
  EXPECT_EQ(mixing.cells, 3);
  EXPECT_EQ(mixing.particles, 16);
}

// S^2 = 0: M = S0^2/(S0^2 - SR^2) = 1/(1 - (C - 1)/(N - 1)).
TEST(LaceyIndex, IsAboveOneWhereColoursAreSpreadEvenly) {
  EXPECT_NEAR(lacey_index({2, 4, 3, 6, 1, 2}, 2).index, 1.0 / (1.0 - 2.0 / 17.0), round_off);
}

// Two cells of four: shares of 3/4 and 1/4, S^2 = 2 (1/4)^2, S0^2 = 1/2, SR^2 = 1/14.
TEST(LaceyIndex, InBetweenIsTheRatioOfVariances) {
  EXPECT_NEAR(lacey_index({3, 1, 1, 3}, 2).index, (0.5 - 0.125) / (0.5 - 0.5 / 7.0), round_off);
}

// All ways to deal 3 + 2 + 2 colours out among cells of 1, 2 and 4 particles: the mean is 1
// exactly.
TEST(LaceyIndex, IsOneInTheMeanOverAllWaysToDealColoursOut) {
  constexpr std::size_t colours = 3;
  std::vector<std::size_t> dealt{0, 0, 0, 1, 1, 2, 2};
  constexpr std::array<std::size_t, 7> cell{0, 1, 1, 2, 2, 2, 2};
  double sum = 0.0;
  int ways = 0;
  do {
    std::vector<long> counts(3 * colours, 0);
    for (std::size_t i = 0; i < cell.size(); ++i) ++counts[cell[i] * colours + dealt[i]];
    sum += lacey_index(counts, colours).index;
    ++ways;
  } while (std::next_permutation(dealt.begin(), dealt.end()));
  EXPECT_EQ(ways, 210);
  EXPECT_NEAR(sum / ways, 1.0, round_off);
}

TEST(LaceyIndex, IsUndefinedForOneColourForSingleParticlesAndForNone) {
  EXPECT_TRUE(std::isnan(lacey_index({4, 0, 5, 0}, 2).index));
  EXPECT_TRUE(std::isnan(lacey_index({1, 0, 0, 1}, 2).index));
  EXPECT_TRUE(std::isnan(lacey_index({0, 0, 0, 0}, 2).index));
}

}  // namespace
