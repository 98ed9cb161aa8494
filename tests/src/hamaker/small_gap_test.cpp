// SPDX-License-Identifier: BSD-3-Clause
#include "hamaker/small_gap.h"

#include "hamaker/exact.h"
#include "hamaker/law.h"
#include "refuses.h"

namespace cohesion::hamaker {
namespace {

const double A = 7.49e-19, H_cut = 4e-10, H_out = 1e-7, r = 0.5e-3;
const SmallGap form(none);

}  // namespace

TEST(SmallGap, EqualSpheresAttractByAROver12HSquared) {
  const HamakerLaw<SmallGap> law({A, H_cut, H_out});
  for (const double gap : {4e-10, 1e-9, 3.7e-8})
    EXPECT_DOUBLE_EQ(law.force(gap, two_spheres(r, r)), A * r / (12.0 * gap * gap));
}

TEST(SmallGap, ExceedsTheExactForceByHOverReducedRadius) {
  const Exact exact(none);
  for (const auto& pair : {two_spheres(r, r), two_spheres(r, 0.2e-3), two_spheres(r, 3e-3),
                           two_spheres(r, 1e6), sphere_and_plane(r)})
    for (const double x : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
      const double gap = x * pair.reduced_radius;
      // With b = H/(r_i + r_j) <= x/4 the ratio is (1 + b/2)^2 (1 + (x/2)(1 + b/2))^2/(1 + b),
      // which exceeds 1 + x by 0.4 x^2 at most; rounding of ten operations.
      EXPECT_NEAR(form.force(gap, pair) / exact.force(gap, pair) - 1.0, x, x * x + 1e-15);
      // The next terms of the energy are H/R* times 1/2 + ln(H/(2 R*)) of the first.
      EXPECT_NEAR(form.energy(gap, pair) / exact.energy(gap, pair), 1.0, x * (1.0 - std::log(x)));
    }
}

TEST(SmallGap, PlaneAttractsTwiceAsStronglyAsAnEqualSphere) {
  EXPECT_DOUBLE_EQ(form.force(1e-9, sphere_and_plane(r)),
                   2.0 * form.force(1e-9, two_spheres(r, r)));
  EXPECT_DOUBLE_EQ(form.energy(1e-9, sphere_and_plane(r)),
                   2.0 * form.energy(1e-9, two_spheres(r, r)));
}

TEST(SmallGap, SurfaceAdhesionIsThatOfTheSurfaceEnergy) {
  // F_ad = 2 pi gamma r_eff with gamma = A/(24 pi H_cut^2) and r_eff = r of equal spheres.
  const HamakerLaw<SmallGap> law({A, H_cut, H_out});
  const double gamma = A / (24.0 * pi * H_cut * H_cut);
  EXPECT_NEAR(law.adhesion_force(two_spheres(r, r)) / (2.0 * pi * gamma * r), 1.0, 1e-15);
}

TEST(SmallGap, ReachesTheForceToWeightRatioOfTheThesis) {
  // A = 1e-18 J on 1 mm spheres of 2650 kg/m3: "ratio 20", two digits.
  const HamakerLaw<SmallGap> strong({1e-18, H_cut, H_out});
  const double weight = 2650.0 * sphere_volume(r) * 9.81;
  EXPECT_NEAR(strong.adhesion_force(two_spheres(r, r)) / weight, 20.0, 1.0);
}

TEST(SmallGap, RefusesAnAsperity) {
  expect_refused([] { SmallGap({A, H_cut, H_out, 1e-8}); }, "asperity radius = 1e-08");
}

}  // namespace cohesion::hamaker
