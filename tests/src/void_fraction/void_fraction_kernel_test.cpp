// SPDX-License-Identifier: BSD-3-Clause
#include "void_fraction/void_fraction_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "box_cell.h"
#include "void_fraction/void_fraction.h"

namespace cohesion::void_fraction {

namespace {

const BoxCell unit_cell({{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}});
const BoxCell half_space({{0.0, -infinity, -infinity}, {infinity, infinity, infinity}});

/// No box: whatever is on the near side of a plane.
class HalfSpace : public Cell {
 public:
  HalfSpace(const Vector3& normal, double distance) : normal_(normal), distance_(distance) {}
  const Box* box() const override { return nullptr; }
  bool contains(const Vector3& p) const override { return dot(p, normal_) <= distance_; }

 private:
  Vector3 normal_;
  double distance_;
};

}  // namespace

TEST(VoidFractionKernels, GiveAllToACellThatHoldsAll) {
  for (const Kernel& kernel : kernels) {
    const double radius = 0.3 / std::max(1.0, kernel.reach);  // the nearest face is at 0.4
    EXPECT_EQ(kernel.share({{0.5, 0.6, 0.4}, radius}, unit_cell), 1.0) << kernel.name;
  }
}

TEST(VoidFractionKernels, GiveNothingBeyondTheirReach) {
  for (const Kernel& kernel : kernels) {
    const double radius = 0.3;
    const double distance = 1.0000001 * kernel.reach * radius + 1e-9;
    EXPECT_EQ(kernel.share({{0.5, 0.5, 1.0 + distance}, radius}, unit_cell), 0.0) << kernel.name;
  }
}

TEST(ParticleCentre, GivesAllOfAParticleToItsCell) {
  EXPECT_EQ(ParticleCentre::share({{0.01, 0.5, 0.5}, 0.3}, unit_cell), 1.0);
  EXPECT_EQ(ParticleCentre::share({{-0.01, 0.5, 0.5}, 0.3}, unit_cell), 0.0);
}

TEST(DividedVolume, PointsAreDistinctAndBalanceInEveryDirection) {
  std::set<std::tuple<double, double, double>> distinct;
  Vector3 first;
  Vector3 second;
  for (const Vector3& p : DividedVolume::points()) {
    distinct.insert({p.x, p.y, p.z});
    first += p;
    second += {p.x * p.x, p.y * p.y, p.z * p.z};
  }
  EXPECT_EQ(distinct.size(), DividedVolume::parts);
  EXPECT_NEAR(norm(first), 0.0, 1e-14);
  EXPECT_NEAR(second.x, second.y, 1e-14);
  EXPECT_NEAR(second.y, second.z, 1e-14);
  // A sphere has the mean square 1/5. The points of shells that thin lie within 2 % of it: the
  // inner shell is twice as wide as far out, b/a = (15)^(1/3), and its mean distance squared is
  // below its mean square.
  EXPECT_NEAR(second.x / DividedVolume::parts, 0.2, 0.02 * 0.2);
}

TEST(DividedVolume, CountsThePartsInTheCell) {
  // Through the centre: the centre and the points with x = 0 are on the plane and count. Those are
  // 4 face directions of 6 and none of the corners, in each of two shells.
  EXPECT_DOUBLE_EQ(DividedVolume::share({{0.0, 0.0, 0.0}, 1.0}, half_space), (1 + 8 + 10) / 29.0);
  EXPECT_DOUBLE_EQ(DividedVolume::share({{1e-9, 0.0, 0.0}, 1.0}, half_space), (1 + 8 + 10) / 29.0);
  EXPECT_DOUBLE_EQ(DividedVolume::share({{-1e-9, 0.0, 0.0}, 1.0}, half_space), 10 / 29.0);
}

TEST(SphereOverlap, ByPointsIsNearTheExactShareOnAnyPlane) {
  // Its stated error: 3 % of the sphere where one plane cuts it, at any angle and depth.
  double worst = 0.0;
  for (int i = 0; i < 12; i++) {
    const double polar = 0.13 * i + 0.05, azimuth = 0.7 * i + 0.02;
    const Vector3 normal{std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                         std::cos(polar)};
    for (double a = -0.975; a < 1.0; a += 0.05) {
      const double exact = 1.0 - 0.25 * (1.0 - a) * (1.0 - a) * (2.0 + a);
      const double found = SphereOverlap::share({{}, 1.0}, HalfSpace(normal, a));
      worst = std::max(worst, std::abs(found - exact));
    }
  }
  EXPECT_LT(worst, 0.03);
  // Among so many planes one is off by a point, 1/500, at least by half of it: it is the points
  // that were counted.
  EXPECT_GT(worst, 0.001);
}

TEST(VoidFraction, OfAnEmptyCellIsOne) { EXPECT_EQ(void_fraction(0.0, 2.0, 1.0), 1.0); }

TEST(VoidFraction, CountsTheDepthOfTheParticlesNotTheThicknessOfTheMesh) {
  // One sphere of unit diameter in a cell of area 2: in a mesh of thickness 10 the cell has volume
  // 20, and the slab of depth 1 a volume of 2.
  EXPECT_DOUBLE_EQ(void_fraction(pi / 6.0, 20.0, 0.1), 1.0 - pi / 12.0);
}

}  // namespace cohesion::void_fraction
