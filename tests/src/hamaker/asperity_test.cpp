// SPDX-License-Identifier: BSD-3-Clause
#include "hamaker/asperity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hamaker/exact.h"
#include "hamaker/small_gap.h"

namespace cohesion::hamaker {
namespace {

const double H = 4e-10, r = 0.5e-3;
const PairGeometry plane = sphere_and_plane(r), pair = two_spheres(r, 0.2e-3);

HamakerParameters of(double asperity) { return {1e-19, 4e-10, 1e-7, asperity}; }

template <class Smooth>
class Asperity : public testing::Test {
 protected:
  const Smooth smooth{none};

  /// Attraction over that of smooth surfaces.
  double factor(double asperity, double gap, const PairGeometry& g) const {
    return Rough<Smooth>(of(asperity)).force(gap, g) / smooth.force(gap, g);
  }
};

using Forms = testing::Types<SmallGap, Exact>;
TYPED_TEST_SUITE(Asperity, Forms);

}  // namespace

TEST(AsperityOnSmallGap, IsRumpfsFormulaForSmallGaps) {
  for (const auto& g : {plane, pair})
    for (const double a : {1e-9, 2e-8, 1e-6})
      for (const double gap : {H, 1e-8}) {
        const double R = g.reduced_radius;
        const double rumpf = R * (a / ((a + R) * gap * gap) + 1.0 / ((gap + a) * (gap + a)));
        EXPECT_DOUBLE_EQ(Rough<SmallGap>(of(a)).force(gap, g), rumpf);
        EXPECT_DOUBLE_EQ(Rough<SmallGap>(of(a)).energy(gap, g),
                         -R * (a / ((a + R) * gap) + 1.0 / (gap + a)));
      }
}

TYPED_TEST(Asperity, OfRadiusZeroLeavesSmoothSurfaces) {
  const Rough<TypeParam> none_there(of(0.0));
  for (const auto& g : {plane, pair})
    for (const double gap : {H, 1e-6, 1e-2}) {
      EXPECT_EQ(none_there.force(gap, g), this->smooth.force(gap, g));
      EXPECT_EQ(none_there.energy(gap, g), this->smooth.energy(gap, g));
    }
}

TYPED_TEST(Asperity, FarBelowTheGapLeavesTheForceAsItIs) {
  // The bodies are r_a further apart: 1/(1 + r_a/H)^2; the asperity itself adds r_a/R* < 1e-11.
  for (const auto& g : {plane, pair}) EXPECT_NEAR(this->factor(1e-5 * H, H, g), 1.0 - 2e-5, 1e-9);
}

TYPED_TEST(Asperity, FarAboveTheRadiiLeavesTheForceAsItIs) {
  // A body of that size is felt alone; its R* is less by R*/r_a = 1e-6. The next orders: its
  // square, and H/R* of the force in the exact form.
  for (const auto& g : {plane, pair})
    EXPECT_NEAR(this->factor(1e6 * g.reduced_radius, H, g), 1.0 - 1e-6, 1e-11);
}

TYPED_TEST(Asperity, ReducesTheAttractionAtEverySize) {
  for (const auto& g : {plane, pair})
    for (double a = 1e-12; a < 1.0; a *= 2.0) EXPECT_LT(this->factor(a, H, g), 1.0) << a;
}

TYPED_TEST(Asperity, ReducesItMostBetweenTheTwoLimits) {
  // (H + r_a)^3 = 2 H^2 R*, where dF/dr_a = 0 for r_a << R*; there both terms together are
  // 3 (H/(2 R*))^(2/3) of the smooth force, to the order H/r_a = 1 %.
  for (const auto& g : {plane, pair}) {
    const double R = g.reduced_radius, least = std::cbrt(2.0 * H * H * R) - H;
    const double factor = this->factor(least, H, g);
    EXPECT_NEAR(factor / (3.0 * std::pow(H / (2.0 * R), 2.0 / 3.0)), 1.0, 2.0 * H / least);
    EXPECT_GT(this->factor(1.1 * least, H, g), factor);
    EXPECT_GT(this->factor(0.9 * least, H, g), factor);
  }
}

}  // namespace cohesion::hamaker
