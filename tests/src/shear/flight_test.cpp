// SPDX-License-Identifier: BSD-3-Clause
#include "shear/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "constants.h"
#include "shear/nonaffine_displacements.h"

namespace cohesion::shear {

TEST(LongestFlight, IsTheBoundOfPairsInAFlowAndIsAttained) {
  const double reach = 1.3, own = 0.7, time = 0.02;
  for (const double rate : {-3.0, 0.0, 0.5}) {
    const BoxShear flow{rate, 5.0};
    const double bound = 2.0 * longest_flight(own, rate, reach, time);
    double farthest = 0.0;
    for (int n = 0; n < 400; n++)
      for (int k = 0; k < 400; k++) {
        const double place = 2.0 * pi * n / 400, motion = 2.0 * pi * k / 400;
        // The lower one flies one way of its own, the upper one the other.
        const double low = 4.0, high = low + reach * std::sin(place);
        const double along = 2.0 * own * std::cos(motion) + flow.affine(high) - flow.affine(low);
        farthest = std::max(farthest, time * std::hypot(along, 2.0 * own * std::sin(motion)));
      }
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * bound;
    EXPECT_LE(farthest, bound + rounding);
    // Both directions are among those tried: one above the other, flying along the flow.
    EXPECT_GE(farthest, bound - rounding);
  }
}

}  // namespace cohesion::shear
