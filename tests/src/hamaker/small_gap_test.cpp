// SPDX-License-Identifier: BSD-3-Clause
#include "hamaker/small_gap.h"

#include <limits>

#include "refuses.h"
#include "sphere.h"

namespace cohesion::hamaker {
namespace {

const double A = 7.49e-19, H_cut = 4e-10, H_out = 1e-7, r = 0.5e-3;
const SmallGap law({A, H_cut, H_out});

/// Attraction of two full spheres at any gap: the derivative of Hamaker's energy
/// -(A/6) [2/(s-4) + 2/s + ln((s-4)/s)], s = (R^2 - (r_i-r_j)^2)/(r_i r_j)
/// (H. C. Hamaker 1937; van der Hoef et al. 2006, eq. 35), with s - 4 written in terms of the gap.
long double full_sphere_force(long double ri, long double rj, long double gap) {
  const long double s_minus_4 = gap * (2 * (ri + rj) + gap) / (ri * rj), s = s_minus_4 + 4;
  const long double ds = 2 * (ri + rj + gap) / (ri * rj);
  return -A / 6 * (-2 / (s_minus_4 * s_minus_4) - 2 / (s * s) + 1 / s_minus_4 - 1 / s) * ds;
}

/// Integral of the force from `gap` to the outer cut-off by Simpson's rule in ln(H), below the
/// surface cut-off in H.
double work(double gap, double reduced) {
  const auto simpson = [](auto f, double a, double b) {
    const int n = 4000;
    double sum = f(a) + f(b);
    for (int i = 1; i < n; i++) sum += (i % 2 ? 4.0 : 2.0) * f(a + (b - a) * i / n);
    return sum * (b - a) / n / 3.0;
  };
  const auto force = [&](double h) { return law.force(h, reduced); };
  double sum = 0.0;
  double from = gap;
  if (gap < H_cut) {
    // The limit from below: at H_cut itself both branches agree.
    sum = simpson(force, gap, H_cut * (1.0 - 1e-15));
    from = H_cut;
  }
  const auto in_log = [&](double s) { return force(std::exp(s)) * std::exp(s); };
  return sum + simpson(in_log, std::log(from), std::log(H_out) - 1e-15);
}

}  // namespace

TEST(SmallGap, EqualSpheresAttractByAROver12HSquared) {
  for (const double gap : {4e-10, 1e-9, 3.7e-8})
    EXPECT_DOUBLE_EQ(law.force(gap, reduced_radius(r, r)), A * r / (12.0 * gap * gap));
}

TEST(SmallGap, TendsToTheForceBetweenFullSpheresOfAnyTwoRadii) {
  for (const double other : {r, 0.2e-3, 3e-3})
    for (const double gap : {H_cut, 1e-9, 1e-8}) {
      const double reduced = reduced_radius(r, other);
      // The next term of the expansion is of relative size 2 H/R* at most: the derivative holds
      // 1/(s-4)^2 and 1/(s-4), with s - 4 = 2 H/R*.
      EXPECT_NEAR(law.force(gap, reduced) / double(full_sphere_force(r, other, gap)), 1.0,
                  2.0 * gap / reduced)
          << other << " " << gap;
    }
}

TEST(SmallGap, PlaneAttractsTwiceAsStronglyAsAnEqualSphere) {
  EXPECT_DOUBLE_EQ(law.force(1e-9, r), 2.0 * law.force(1e-9, reduced_radius(r, r)));
  EXPECT_DOUBLE_EQ(law.energy(1e-9, r), 2.0 * law.energy(1e-9, reduced_radius(r, r)));
}

TEST(SmallGap, PlaneIsTheLimitOfALargeSphere) {
  // R* = r/(1 + r/R), so r/R = 1e-9 is also the relative difference of the force.
  EXPECT_NEAR(law.force(1e-9, reduced_radius(r, 1e9 * r)) / law.force(1e-9, r), 1.0, 2e-9);
}

TEST(SmallGap, SurfaceAdhesionIsThatOfTheSurfaceEnergy) {
  // F_ad = 2 pi gamma r_eff with gamma = A/(24 pi H_cut^2) and r_eff = r of equal spheres.
  const double gamma = A / (24.0 * pi * H_cut * H_cut);
  EXPECT_NEAR(law.adhesion_force(reduced_radius(r, r)) / (2.0 * pi * gamma * r), 1.0, 1e-15);
  EXPECT_DOUBLE_EQ(law.force(-1e-6, r), law.adhesion_force(r));
  EXPECT_DOUBLE_EQ(law.force(0.0, r), law.adhesion_force(r));
}

TEST(SmallGap, ForceIsContinuousAtTheSurfaceCutoff) {
  // Both branches are the same expression at H_cut; one ulp of H moves the force by two.
  const double below = std::nextafter(H_cut, 0.0);
  EXPECT_NEAR(law.force(below, r) / law.force(H_cut, r), 1.0, 1e-15);
}

TEST(SmallGap, ForceAndEnergyEndAtTheOuterCutoff) {
  const double inside = H_out * (1.0 - 1e-12);
  EXPECT_GT(law.force(inside, r), 0.0);
  EXPECT_EQ(law.force(H_out, r), 0.0);
  EXPECT_EQ(law.energy(H_out, r), 0.0);
  EXPECT_EQ(law.energy(1.0, r), 0.0);
  // Continuous: F(H_out) (H_out - inside), and the rounding of the difference of two A R*/(6
  // H_out).
  EXPECT_NEAR(law.energy(inside, r), 0.0, A * r / (6.0 * H_out) * 2e-12);
}

TEST(SmallGap, EnergyIsMinusTheWorkOfTheForce) {
  for (const double gap : {-1e-8, -1e-10, 0.0, 2e-10, 4e-10, 1e-9, 5e-8}) {
    // Simpson in 4000 intervals of 0.0014 in ln(H): error (0.0014)^4/180, far below 1e-12; the
    // rounding of 4000 terms is 1e-13.
    EXPECT_NEAR(law.energy(gap, r) / -work(gap, r), 1.0, 1e-12) << gap;
  }
}

TEST(SmallGap, ForceIsTheSlopeOfTheEnergy) {
  for (const double gap : {-3e-9, 1e-10, 5e-10, 2e-9, 6e-8}) {
    const double h = 1e-5 * std::abs(gap);
    // Central difference of -1/H: relative error (h/H)^2 = 1e-10, rounding 1e-16 E/(F h) = 1e-10
    // (at -3e-9: E/(F H) is of order one as well).
    const double slope = (law.energy(gap + h, r) - law.energy(gap - h, r)) / (2.0 * h);
    EXPECT_NEAR(slope / law.force(gap, r), 1.0, 1e-9) << gap;
  }
}

TEST(SmallGap, ScalesWithTheHamakerConstantAndVanishesWithoutIt) {
  const SmallGap twice({2.0 * A, H_cut, H_out});
  EXPECT_DOUBLE_EQ(twice.force(1e-9, r), 2.0 * law.force(1e-9, r));
  const SmallGap none({0.0, H_cut, H_out});
  EXPECT_EQ(none.force(-1e-9, r), 0.0);
  EXPECT_EQ(none.energy(-1e-9, r), 0.0);
}

TEST(SmallGap, ReachesTheForceToWeightRatioOfTheThesis) {
  // A = 1e-18 J on 1 mm spheres of 2650 kg/m3: "ratio 20", two digits.
  const SmallGap strong({1e-18, H_cut, H_out});
  const double weight = 2650.0 * sphere_volume(r) * 9.81;
  EXPECT_NEAR(strong.adhesion_force(reduced_radius(r, r)) / weight, 20.0, 1.0);
}

TEST(SmallGap, RefusesWhatCannotBe) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {-1e-30, nan, inf})
    expect_refused([=] { SmallGap({bad, H_cut, H_out}); }, "Hamaker constant A");
  for (const double bad : {0.0, -1e-10, nan, inf}) {
    expect_refused([=] { SmallGap({A, bad, H_out}); }, "surface cut-off H_cut");
    expect_refused([=] { SmallGap({A, H_cut, bad}); }, "outer cut-off");
  }
  expect_refused([] { SmallGap({A, 2e-9, 1e-9}); }, "smaller than the outer cut-off");
  expect_refused([] { SmallGap({A, 1e-9, 1e-9}); }, "smaller than the outer cut-off");
}

}  // namespace cohesion::hamaker
