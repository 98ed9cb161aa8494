// SPDX-License-Identifier: BSD-3-Clause
#include "sphere.h"

#include <gtest/gtest.h>

namespace cohesion {

TEST(Sphere, VolumeOfUnitDiameterIsPiOverSix) { EXPECT_DOUBLE_EQ(sphere_volume(0.5), pi / 6.0); }

TEST(Sphere, ReducedRadiusOfEqualSpheresIsHalf) { EXPECT_DOUBLE_EQ(reduced_radius(3.0, 3.0), 1.5); }

TEST(Sphere, ReducedRadiusTendsToTheSphereBesideAPlane) {
  // R* = r/(1 + r/R): with r/R = 1e-12 the difference is 1e-12 r.
  EXPECT_NEAR(reduced_radius(2.0, 2e12), 2.0, 4e-12);
}

TEST(Sphere, PlaneIsTheGeometryOfALargeSphere) {
  const PairGeometry large = two_spheres(2.0, 2e12), plane = sphere_and_plane(2.0);
  EXPECT_NEAR(large.reduced_radius, plane.reduced_radius, 4e-12);
  EXPECT_NEAR(large.inverse_contact_distance, plane.inverse_contact_distance, 1e-12);
  EXPECT_DOUBLE_EQ(two_spheres(3.0, 1.0).inverse_contact_distance, 0.25);
}

TEST(Sphere, ReducedMassIsSymmetricAndBelowBoth) {
  EXPECT_DOUBLE_EQ(reduced_mass(1.0, 4.0), 0.8);
  EXPECT_DOUBLE_EQ(reduced_mass(4.0, 1.0), 0.8);
}

}  // namespace cohesion
