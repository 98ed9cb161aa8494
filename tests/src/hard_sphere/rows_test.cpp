// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using cohesion::hard_sphere::Rows;

/// The same as lists of their own.
void expect_same(const Rows<int>& rows, const std::vector<std::vector<int> >& reference) {
  for (int n = 0; n < static_cast<int>(reference.size()); n++)
    ASSERT_TRUE(std::equal(rows.begin(n), rows.end(n), reference[n].begin(), reference[n].end()));
}

TEST(Rows, AreNoneAtFirst) {
  Rows<int> rows;
  rows.reset({});
  EXPECT_EQ(rows.bytes(), 0.0);
}

TEST(Rows, KeepWhatListsOfTheirOwnKeep) {
  std::mt19937 random(2);
  Rows<int> rows;
  for (const int number : {1, 2, 17, 60, 5}) {
    std::vector<int> rooms(number);
    for (int& room : rooms) room = static_cast<int>(random() % 4);
    rows.reset(rooms);
    std::vector<std::vector<int> > reference(number);
    expect_same(rows, reference);
    for (int n = 0; n < 20000; n++) {
      const int row = static_cast<int>(random() % number);
      auto& list = reference[row];
      const unsigned what = random() % 100;
      if (what < 52 || list.empty()) {
        rows.add(row, n);
        list.push_back(n);
      } else {
        const std::size_t at = random() % list.size();
        rows.remove(row, rows.begin(row) + at);
        list[at] = list.back();
        list.pop_back();
      }
      ASSERT_TRUE(std::equal(rows.begin(row), rows.end(row), list.begin(), list.end()));
      if (n % 100 == 0) expect_same(rows, reference);
    }
    expect_same(rows, reference);
  }
}

// Rows double: what they leave behind is no more than what they have.
TEST(Rows, TakeNoMoreMemoryThanAFewTimesTheirItems) {
  Rows<int> rows;
  rows.reset(std::vector<int>(100, 0));
  for (int n = 0; n < 100000; n++) rows.add(n % 100, n);
  EXPECT_LT(rows.bytes(), 100000 * 4 * sizeof(int) * 2 + 100 * 64);
}

}  // namespace
