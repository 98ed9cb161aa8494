// SPDX-License-Identifier: BSD-3-Clause
#include "held_directions.h"

#include <gtest/gtest.h>

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

TEST(HeldDirections, OfSeveralAddUp) {
  HeldDirections held = all_but(x, 3);
  HeldDirections other;
  other.add(x + y);
  held.add(other);
  EXPECT_TRUE(held.all());
}

}  // namespace
}  // namespace cohesion
