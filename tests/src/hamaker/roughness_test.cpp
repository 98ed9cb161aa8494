// SPDX-License-Identifier: BSD-3-Clause
#include "hamaker/roughness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../refuses.h"
#include "constants.h"
#include "hamaker/asperity.h"
#include "hamaker/exact.h"
#include "hamaker/law.h"
#include "hamaker/range_of_validity.h"
#include "hamaker/small_gap.h"

namespace cohesion::hamaker {
namespace {

const double A = 1e-19, H_cut = 4e-10, H_out = 1e-7;

HamakerParameters of(const Roughness& r) {
  const Asperity a = asperity_of(r);
  return {A, H_cut, H_out, a.radius, a.height};
}

/// Height of flat caps in closest packing over the root mean square of the heights, by the midpoint
/// rule over rings of a cap and the flat rest of its hexagon; slope: height of the cap over the
/// radius of its base.
double height_over_rms(double slope) {
  const double curvature = 2.0 * slope / (1.0 + slope * slope),
               covered = pi / (2.0 * std::sqrt(3.0));
  const int rings = 100000;
  double sum = 0.0;
  for (int k = 0; k < rings; k++) {
    const double s = (k + 0.5) / rings;
    const double drop = (1.0 - std::sqrt(1.0 - curvature * s * curvature * s)) / curvature;
    sum += (slope - drop) * (slope - drop) * 2.0 * s / rings;
  }
  return slope / std::sqrt(covered * sum);
}

}  // namespace

TEST(Roughness, GivesTheAsperityThatIsWorkedOutByHand) {
  // 5 nm and 500 nm: h_a = 1.817 * 5e-9 = 9.085e-9, r_a = 2.5e-13/(32 * 9.085e-9) = 8.59934e-7.
  const Asperity a = asperity_of({5e-9, 5e-7});
  EXPECT_DOUBLE_EQ(a.height, 9.085e-9);
  EXPECT_NEAR(a.radius, 8.59934e-7, 0.5e-12);
}

TEST(Roughness, ForceOfContactIsTheFormulaAsItIsPrinted) {
  for (const auto& g : {sphere_and_plane(1e-5), two_spheres(5e-4, 2e-5)})
    for (const double rms : {0.5e-9, 2e-9, 2e-8})
      for (const double lambda : {3e-7, 1e-6}) {
        const double R = g.reduced_radius;
        const double printed = A * R / (6.0 * H_cut * H_cut) *
                               (1.0 / (1.0 + 58.14 * R * rms / (lambda * lambda)) +
                                1.0 / std::pow(1.0 + 1.817 * rms / H_cut, 2));
        // 32 * 1.817 = 58.144, of which 58.14 are printed: 7e-5.
        EXPECT_NEAR(HamakerLaw<Rough<SmallGap>>(of({rms, lambda})).adhesion_force(g) / printed, 1.0,
                    7e-5);
      }
}

TEST(Roughness, HeightOfPeaksIsThatOfFlatCapsInClosestPacking) {
  // sqrt(6 sqrt(3)/pi) = 1.8188, of which the source prints 1.817: 1.0e-3. The rule's own error is
  // of the order of 1/rings^2.
  const double flat = std::sqrt(6.0 * std::sqrt(3.0) / pi);
  EXPECT_NEAR(height_over_rms(1e-4), flat, 1e-7);
  EXPECT_NEAR(peak_over_rms / flat, 1.0, 1.0e-3);
  // Hemispheres so packed have sqrt(4 sqrt(3)/pi) = 1.485, which the same source has for Rumpf's.
  EXPECT_NEAR(height_over_rms(1.0), std::sqrt(4.0 * std::sqrt(3.0) / pi), 1e-4);
}

TEST(Roughness, OfNoHeightIsSmooth) {
  const Asperity a = asperity_of({0.0, 1e-6});
  EXPECT_EQ(a.radius, 0.0);
  EXPECT_EQ(a.height, 0.0);
}

TEST(Roughness, FlatCapsAreFeltTwiceAndRefused) {
  // rms far below H_cut, r_a far above R*: 1/(1 + R*/r_a) + 1/(1 + h_a/H_cut)^2 -> 2; here R*/r_a =
  // 5.8e-10 and 2 h_a/H_cut = 9.1e-5.
  const PairGeometry g = two_spheres(2e-5, 2e-5);
  const HamakerParameters flat = of({1e-14, 1e-3});
  EXPECT_NEAR(HamakerLaw<Rough<SmallGap>>(flat).adhesion_force(g) /
                  HamakerLaw<SmallGap>({A, H_cut, H_out}).adhesion_force(g),
              2.0, 1e-4);
  for (const Form& form : forms) {
    expect_refused([&] { require_weakened_by_asperities(form, flat, g); },
                   "asperity height = 1.817e-14: too low for its radius of");
    EXPECT_NO_THROW(require_weakened_by_asperities(form, of({2e-9, 3e-7}), g));
    EXPECT_NO_THROW(require_weakened_by_asperities(form, {A, H_cut, H_out}, g));
    EXPECT_NO_THROW(require_weakened_by_asperities(form, {A, H_cut, H_out, 1e-12}, g));
    EXPECT_NO_THROW(require_weakened_by_asperities(form, {A, H_cut, H_out, 1.0}, g));
  }
  // A law that is off has any.
  EXPECT_NO_THROW(require_weakened_by_asperities(forms[0], {0.0, H_cut, H_out, 1.0, 1e-14}, g));
}

TEST(Roughness, CapsAreNoHigherThanHemispheres) {
  // lambda = sqrt(32) k_1 rms, where r_a = h_a.
  const double least = std::sqrt(32.0) * peak_over_rms;
  const Asperity a = asperity_of({1.0, least});
  EXPECT_DOUBLE_EQ(a.radius, a.height);
  expect_refused([&] { asperity_of({1e-9, 1e-8}); },
                 "wavelength of the roughness = 1e-08: must be at least 10.2785 times the rms");
}

TEST(Roughness, RefusesWhatIsNoLength) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {-1e-9, infinite, std::nan("")}) {
    expect_refused([&] { asperity_of({bad, 1e-6}); }, "rms roughness");
    expect_refused([&] { asperity_of({1e-9, bad}); }, "wavelength of the roughness");
  }
  expect_refused([] { asperity_of({0.0, 0.0}); }, "wavelength of the roughness");
}

TEST(Roughness, IsFoundAgainFromTheAsperity) {
  for (const double rms : {3e-10, 7e-9})
    for (const double lambda : {1.1e-7, 2e-5}) {
      const Roughness r = roughness_of(of({rms, lambda}));
      EXPECT_DOUBLE_EQ(r.rms, rms);
      EXPECT_DOUBLE_EQ(r.wavelength, lambda);
    }
}

template <class Smooth>
class AsperityHeight : public testing::Test {};
using Forms = testing::Types<SmallGap, Exact>;
TYPED_TEST_SUITE(AsperityHeight, Forms);

TYPED_TEST(AsperityHeight, OfTheRadiusIsRumpfsHemisphere) {
  const Rough<TypeParam> hemisphere({A, H_cut, H_out, 2e-8}), cap({A, H_cut, H_out, 2e-8, 2e-8});
  for (const auto& g : {sphere_and_plane(5e-4), two_spheres(5e-4, 2e-4)})
    for (const double gap : {H_cut, 1e-8}) {
      EXPECT_EQ(cap.force(gap, g), hemisphere.force(gap, g));
      EXPECT_EQ(cap.energy(gap, g), hemisphere.energy(gap, g));
    }
}

TYPED_TEST(AsperityHeight, HoldsTheBodiesApart) {
  const TypeParam smooth(none);
  const double radius = 8e-7, height = 9e-9;
  const Rough<TypeParam> cap({A, H_cut, H_out, radius, height});
  for (const auto& g : {sphere_and_plane(5e-4), two_spheres(5e-4, 2e-4)}) {
    const PairGeometry tip = two_spheres(radius, g.reduced_radius);
    for (const double gap : {H_cut, 1e-8}) {
      EXPECT_EQ(cap.force(gap, g), smooth.force(gap, tip) + smooth.force(gap + height, g));
      EXPECT_EQ(cap.energy(gap, g), smooth.energy(gap, tip) + smooth.energy(gap + height, g));
    }
  }
}

TYPED_TEST(AsperityHeight, ForceIsTheSlopeOfTheEnergy) {
  // Central difference with h = gap/1000: h^2/6 F''/F = (h/gap)^2 = 1e-6 at most; rounding of the
  // energy, 2e-16 of it over h F = gap F/1000 <= E/1000: 2e-13.
  const Rough<TypeParam> cap({A, H_cut, H_out, 8e-7, 9e-9});
  const PairGeometry g = two_spheres(5e-4, 2e-4);
  for (const double gap : {H_cut, 5e-9, 1e-7}) {
    const double h = 1e-3 * gap;
    const double slope = (cap.energy(gap + h, g) - cap.energy(gap - h, g)) / (2.0 * h);
    EXPECT_NEAR(slope / cap.force(gap, g), 1.0, 1.1e-6);
  }
}

TEST(AsperityHeightOfParameters, IsChecked) {
  EXPECT_NO_THROW(require_valid({A, H_cut, H_out, 2e-8, 2e-8}));
  expect_refused([] { require_valid({A, H_cut, H_out, 2e-8, -1e-9}); }, "asperity height = -1e-09");
  expect_refused([] { require_valid({A, H_cut, H_out, 2e-8, 3e-8}); },
                 "asperity height = 3e-08: must not be above the asperity radius");
}

TEST(AsperityHeightOfParameters, OfUnlikeMaterialsIsTheHigherWithItsRadius) {
  const HamakerParameters smooth{A, H_cut, H_out}, hemisphere{A, H_cut, H_out, 1e-8};
  const HamakerParameters low = of({1e-9, 1e-6}), high = of({1e-8, 1e-6});
  const auto expect_mixed = [](const HamakerParameters& a, const HamakerParameters& b,
                               const HamakerParameters& wanted) {
    for (const HamakerParameters& m : {mixed(a, b), mixed(b, a)}) {
      EXPECT_EQ(m.asperity_radius, wanted.asperity_radius);
      EXPECT_EQ(m.asperity_height, wanted.asperity_height);
    }
  };
  expect_mixed(smooth, low, low);
  expect_mixed(low, high, high);  // though its radius is the smaller one
  expect_mixed(low, hemisphere, hemisphere);
  expect_mixed(high, hemisphere, high);
}

}  // namespace cohesion::hamaker
