// SPDX-License-Identifier: BSD-3-Clause
#include "shear/nonaffine_displacements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cohesion::shear {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

}  // namespace

TEST(BoxShear, CarriesEachHeightWithTheBox) {
  const BoxShear shear{0.5, 4.0};
  EXPECT_EQ(shear.affine(4.0), 0.0);
  EXPECT_EQ(shear.affine(6.0), 1.0);
  EXPECT_EQ(shear.nonaffine(1.0, 6.0), 0.0);
  EXPECT_EQ(shear.nonaffine(1.0, 2.0), 2.0);
}

/// A particle carried with the box has no nonaffine displacement; nor has its image, which stands a
/// box higher, is shifted by the tilt, and is carried further.
TEST(NonaffineDisplacements, AreZeroOfWhatTheBoxCarries) {
  const double height = 8.0, middle = 4.0, tilt = 1.5, strain = -0.3,
               later = tilt + strain * height;
  const double places[] = {2.0, 7.0, 1.0, 2.0 + tilt, 7.0 + height, 1.0};
  NonaffineDisplacements list;
  list.set_reference(places, 2, tilt);
  ASSERT_EQ(list.count(), 2u);
  const BoxShear shear = list.shear_since_reference(later, height, middle);
  EXPECT_NEAR(shear.amount, strain, 4 * eps);
  const double moved = strain * (7.0 - middle);
  EXPECT_NEAR(list.squared(0, {2.0 + moved, 7.0, 1.0}, shear), 0.0, 1e-28);
  EXPECT_NEAR(list.squared(1, {2.0 + moved + later, 15.0, 1.0}, shear), 0.0, 1e-28);
}

TEST(NonaffineDisplacements, AreTheSameForAParticleAndItsImage) {
  const double height = 8.0, tilt = -2.0, strain = 0.4, later = tilt + strain * height;
  const double places[] = {2.0, 7.0, 1.0, 2.0 - tilt, 7.0 - height, 1.0};
  NonaffineDisplacements list;
  list.set_reference(places, 2, tilt);
  const BoxShear shear = list.shear_since_reference(later, height, 4.0);
  const Vector3 own{0.3, -0.4, 1.2};
  const Vector3 now = Vector3{2.0 + strain * (7.0 - 4.0), 7.0, 1.0} + own;
  const Vector3 image = now - Vector3{later, height, 0.0};
  EXPECT_NEAR(list.squared(0, now, shear), 1.69, 1.69 * 8 * eps);
  EXPECT_NEAR(list.squared(1, image, shear), 1.69, 1.69 * 16 * eps);
}

}  // namespace cohesion::shear
