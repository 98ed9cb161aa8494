// SPDX-License-Identifier: BSD-3-Clause
#include "held_directions.h"

#include <gtest/gtest.h>

#include <vector>

namespace cohesion {
namespace {

const Vector3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};

TEST(HeldDirections, AreAllOnceTheySpanTheSpace) {
  HeldDirections held;
  EXPECT_TRUE(held.none());
  held.add(2.0 * x);
  held.add(x + y);
  EXPECT_FALSE(held.none());
  EXPECT_FALSE(held.all());
  held.add(z + x);
  EXPECT_TRUE(held.all());
}

TEST(HeldDirections, CountADirectionOnce) {
  const Vector3 oblique{0.1, 0.7, -0.3};
  HeldDirections held;
  held.add(oblique);
  held.add(-3.7 * oblique);
  held.add(x + oblique);
  held.add(x);
  EXPECT_EQ(held.end() - held.begin(), 2);
}

TEST(HeldDirections, AreAtRightAnglesAndOfUnitLength) {
  HeldDirections held;
  held.add({0.1, 0.7, -0.3});
  held.add({5.0, 1.0, 2.0});
  held.add({-1.0, 1.0, 1.0});
  for (const Vector3& a : held)
    for (const Vector3& b : held) EXPECT_NEAR(dot(a, b), &a == &b ? 1.0 : 0.0, 1e-14);
}

TEST(HeldDirections, InTwoDimensionsNeedNoThird) {
  HeldDirections held(2);
  held.add(z);
  EXPECT_TRUE(held.none());
  held.add(x);
  held.add(y);
  EXPECT_TRUE(held.all());
}

TEST(HeldDirections, AcrossALineLeaveThatAlone) {
  const Vector3 line{1.0, 2.0, -2.0};
  const HeldDirections held = all_but(line, 3);
  EXPECT_EQ(held.end() - held.begin(), 2);
  for (const Vector3& direction : held) EXPECT_NEAR(dot(direction, line), 0.0, 1e-14);
  EXPECT_TRUE(all_but(z, 2).all());
}

TEST(HeldDirections, OfSeveralLeaveNothingOrSomeForce) {
  HeldDirections along_x, along_both;
  along_x.add(x);
  along_both.add(x + y);
  const HeldDirections across_x = all_but(x, 3), across_both = all_but(x + y, 3);
  const auto nothing = [](std::vector<const HeldDirections*> some) { return leave_nothing(some); };
  EXPECT_TRUE(nothing({&across_x, &along_x}));
  EXPECT_TRUE(nothing({&along_x, &across_x}));
  // Both directions of the plane are held, each after the other: half of the first comes back.
  EXPECT_FALSE(nothing({&along_x, &across_both}));
  EXPECT_NEAR(norm(along_x.left_of(across_both.left_of(x))), 0.5, 1e-14);
  EXPECT_FALSE(nothing({&along_x}));
  HeldDirections flat_x(2), flat_y(2);
  flat_x.add(x);
  flat_y.add(y);
  EXPECT_TRUE(nothing({&flat_x, &flat_y}));
}

}  // namespace
}  // namespace cohesion
