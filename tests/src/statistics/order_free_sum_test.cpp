// SPDX-License-Identifier: BSD-3-Clause
#include "statistics/order_free_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace cohesion::statistics {
namespace {

double sum_of(const std::vector<double>& numbers, double largest) {
  const OrderFreeSum grid(largest, static_cast<std::int64_t>(numbers.size()));
  std::int64_t units = 0;
  for (const double number : numbers) units += grid.units(number);
  return grid.value(units);
}

}  // namespace

TEST(OrderFreeSum, IsTheSameInAnyOrderAndTheSum) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<double> numbers(1372);
  for (double& number : numbers) number = std::exp(5.0 * normal(random)) * normal(random);
  double largest = 0.0;
  for (const double number : numbers) largest = std::max(largest, std::abs(number));
  const double once = sum_of(numbers, largest);
  const long double exact = [&] {
    long double sum = 0.0L;
    for (const double number : numbers) sum += number;
    return sum;
  }();
  EXPECT_NEAR(once, static_cast<double>(exact), 0x1p-61 * 1372.0 * 1372.0 * largest);
  std::sort(numbers.begin(), numbers.end());
  EXPECT_EQ(sum_of(numbers, largest), once);
  double plain = 0.0;
  std::vector<double> shuffled = numbers;
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  for (const double number : shuffled) plain += number;
  double sorted = 0.0;
  for (const double number : numbers) sorted += number;
  EXPECT_NE(plain, sorted);  // what a plain sum does
}

TEST(OrderFreeSum, HasRoomForAsManyOfTheLargest) {
  for (const double largest : {1e-300, 0.75, 1.0, 1e300})
    for (const int count : {1, 2, 3, 1000, 4096}) {
      // Half a unit of each, over the number, and the rounding of the quotient.
      const double room = 0x1p-61 * count + 0x1p-52;
      const std::vector<double> all(count, largest);
      EXPECT_NEAR(sum_of(all, largest) / (count * largest), 1.0, room) << largest << " " << count;
      const std::vector<double> negative(count, -largest);
      EXPECT_NEAR(sum_of(negative, largest) / (count * largest), -1.0, room);
    }
}

TEST(OrderFreeSum, OfNothingIsZero) {
  EXPECT_EQ(sum_of({0.0, 0.0}, 0.0), 0.0);
  EXPECT_EQ(sum_of({}, 1.0), 0.0);
}

}  // namespace cohesion::statistics
