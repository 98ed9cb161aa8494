// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cohesion::statistics {

/// Sums of numbers that are the same to the last bit in whatever order, and on however many
/// processes, they are added: each number is rounded to a whole multiple of one unit, and whole
/// numbers are added. The unit leaves room for the largest of all, and for as many of it as there
/// are: a sum of n numbers is known to n/2 units, at worst 2^-61 n^2 of the largest number.
class OrderFreeSum {
 public:
  /// largest: no smaller than the magnitude of any number that will be added; count: no smaller
  /// than how many.
  OrderFreeSum(double largest, std::int64_t count) {
    if (largest == 0.0) return;
    const int room = std::ilogb(largest) + 1 +
                     std::ilogb(static_cast<double>(std::max<std::int64_t>(count, 1))) + 1;
    exponent_ = room - 62;
  }

  /// In units; what is added.
  std::int64_t units(double number) const { return std::llrint(std::ldexp(number, -exponent_)); }

  /// What so many units are.
  double value(std::int64_t units) const {
    return std::ldexp(static_cast<double>(units), exponent_);
  }

 private:
  int exponent_ = 0;
};

}  // namespace cohesion::statistics
