// SPDX-License-Identifier: BSD-3-Clause
#include "square_well/sight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "square_well/parameters.h"
#include "vector3.h"

namespace cohesion::square_well {

TEST(Sight, EndsTheMarginBeyondTheWidestWell) {
  EXPECT_EQ(sight(1.5, 0.25, 2.0), 1.5);
  EXPECT_EQ(sight(1.0, 0.25, 2.0), 0.5);
  // At the edge of the widest well the margin is left, whatever the radii.
  const SquareWellParameters widest = well(1.0, 1.5);
  EXPECT_EQ(sight(1.5, 0.25, 1.0 + 3.0) - width(widest, 1.0, 3.0), 0.25 * (1.0 + 3.0));
}

TEST(Sight, IsLeftByThePairWhoseNextGapIsBeyondIt) {
  EXPECT_FALSE(flies_out_of_sight(1.0, -1.0, 0.5, 1.5));  // just as far
  EXPECT_TRUE(flies_out_of_sight(1.0, -1.0, 0.5078125, 1.5));
  EXPECT_TRUE(flies_out_of_sight(1.0, -1.0078125, 0.5, 1.5));
  EXPECT_FALSE(flies_out_of_sight(1.0, 8.0, 0.5, 1.5));  // comes nearer
}

TEST(Sight, OfThoseThatStayInItNoneLeaves) {
  // Pairs at the edge of their own well, that of the first two the widest, fly the margin in a
  // step, all but one part in 1e12, in any direction.
  const double margin = 0.01, step = 1e-5, ri = 5e-4;
  for (const SquareWellParameters& p :
       {well(1.0, 1.2), SquareWellParameters{1.0, 1.2, 1.01}, well(1.0, 1.0)})
    for (const double rj : {1e-5, 5e-4, 2e-2})
      for (int n = 0; n <= 12; n++) {
        const double radii = ri + rj, speed = margin * radii / step * (1.0 - 1e-12);
        const double angle = n * std::acos(-1.0) / 12;
        const Vector3 r{edge(p, ri, rj), 0.0, 0.0};
        const Vector3 w{speed * std::cos(angle), speed * std::sin(angle), 0.0};
        ASSERT_TRUE(stays_in_sight(dot(w, w), step, margin, radii * radii));
        const double far = sight(1.2, margin, radii);
        EXPECT_LE(norm(r + step * w) - radii, far);
        EXPECT_FALSE(flies_out_of_sight(norm(r) - radii, -w.x, step, far));
      }
}

TEST(Sight, IsNotSureOfThoseThatFlyFarther) {
  const double margin = 0.01, step = 1e-5, radii = 1e-3;
  const double speed = margin * radii / step * (1.0 + 1e-12);
  EXPECT_FALSE(stays_in_sight(speed * speed, step, margin, radii * radii));
  // One at the edge of the widest well does leave.
  const double gap = width(well(1.0, 1.2), 0.5 * radii, 0.5 * radii);
  EXPECT_TRUE(flies_out_of_sight(gap, -1.001 * speed, step, sight(1.2, margin, radii)));
}

}  // namespace cohesion::square_well
