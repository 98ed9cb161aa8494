// SPDX-License-Identifier: BSD-3-Clause
#include "hamaker/exact.h"

#include <algorithm>
#include <limits>

#include "hamaker/exact_values.h"
#include "refuses.h"

namespace cohesion::hamaker {
namespace {

const Exact form(none);
const double eps = std::numeric_limits<double>::epsilon();

PairGeometry geometry(const ExactValue& value) {
  return value.rj == 0.0 ? sphere_and_plane(value.ri) : two_spheres(value.ri, value.rj);
}

}  // namespace

TEST(ExactHamaker, ForceHasAllDigitsAtAllGapsAndRatiosOfRadii) {
  // No differences: some twenty roundings of eps/2, those of q and the denominator squared. The
  // docstring's 2e-15 is 9 eps.
  for (const ExactValue& value : exact_values)
    EXPECT_NEAR(form.force(value.gap, geometry(value)) / value.force, 1.0, 9.0 * eps)
        << value.ri << " " << value.rj << " " << value.gap;
}

TEST(ExactHamaker, EnergyHasAllDigitsAtAllGapsAndRatiosOfRadii) {
  // At t = 1/3, where the cancellation is worst, the terms of the bracket are 0.75 and 0.69 against
  // a sum of 0.057: 13 times the rounding of a few operations of eps/2. The docstring's 4e-15 is
  // 18 eps.
  for (const ExactValue& value : exact_values)
    EXPECT_NEAR(form.energy(value.gap, geometry(value)) / value.energy, 1.0, 18.0 * eps)
        << value.ri << " " << value.rj << " " << value.gap;
}

TEST(ExactHamaker, EnergyIsContinuousWhereItChangesItsExpression) {
  // t = 1/3 at u = 4, for a plane at H = 2 r.
  const PairGeometry plane = sphere_and_plane(1.0);
  const double below = form.energy(2.0 * (1.0 - eps), plane);
  const double above = form.energy(2.0 * (1.0 + 2.0 * eps), plane);
  // The gap changes by 3 eps, the energy by less than 4 times that; rounding as above.
  EXPECT_NEAR(below / above, 1.0, 18.0 * eps + 12.0 * eps);
}

TEST(ExactHamaker, ForceIsTheSlopeOfTheEnergy) {
  for (const auto& pair : {two_spheres(5e-4, 5e-4), two_spheres(5e-4, 2e-4),
                           two_spheres(1e-6, 1e-3), two_spheres(5e-4, 1e3), sphere_and_plane(5e-4)})
    for (double gap = 1e-10; gap < 1e-1; gap *= 3.0) {
      const double h = gap / 1024.0;
      const auto e = [&](int k) { return form.energy(gap + k * h, pair); };
      const double slope =
          (45.0 * (e(1) - e(-1)) - 9.0 * (e(2) - e(-2)) + (e(3) - e(-3))) / (60.0 * h);
      // Error of the sixth order: for H^-6, the steepest that the energy becomes, 4752 (h/H)^6 =
      // 4e-15. Rounding: 18 eps of E, times 110/60 (H/h) E/(F H), of which the last is at most 1.
      EXPECT_NEAR(slope / form.force(gap, pair), 1.0, 4e-15 + 18.0 * eps * 2.0 * 1024.0)
          << pair.reduced_radius << " " << gap;
    }
}

TEST(ExactHamaker, PlaneIsTheLimitOfALargeSphere) {
  const double r = 5e-4;
  for (const double gap : {1e-9, 1e-6, 0.1 * r, r}) {
    const auto deviation = [&](double ratio) {
      return form.force(gap, two_spheres(r, ratio * r)) / form.force(gap, sphere_and_plane(r)) -
             1.0;
    };
    // Linear in r_i/r_j: at small gaps R* = r/(1 + r_i/r_j) makes it minus one times that.
    const double slope = deviation(1e6) * 1e6;
    if (gap < 1e-5 * r) {
      EXPECT_NEAR(slope, -1.0, 1e-5);
    }
    EXPECT_LT(std::abs(slope), 3.0);
    EXPECT_GT(std::abs(slope), 0.1);
    // The next order is below ten times the square, in `slope` as well; rounding of both forces.
    for (const double ratio : {1e3, 1e4, 1e5, 1e7, 1e8, 1e9})
      EXPECT_NEAR(deviation(ratio), slope / ratio,
                  10.0 / (ratio * ratio) + (1e-5 + 18e6 * eps) / ratio + 18.0 * eps)
          << gap << " " << ratio;
  }
}

TEST(ExactHamaker, DistantSpheresAttractLikePoints) {
  // E = -(A/6)(32/3)(r_i r_j)^3/R^6 to the order (r/R)^2.
  const double ri = 2.0, rj = 3.0, distance = 1e5;
  const double points = -32.0 / 3.0 * std::pow(ri * rj, 3) / std::pow(distance, 6);
  EXPECT_NEAR(form.energy(distance - ri - rj, two_spheres(ri, rj)) / points, 1.0, 1e-8);
}

TEST(ExactHamaker, DoesNotDependOnTheOrderOfTheSpheres) {
  EXPECT_EQ(form.force(0.3, two_spheres(2.0, 5.0)), form.force(0.3, two_spheres(5.0, 2.0)));
  EXPECT_EQ(form.energy(0.3, two_spheres(2.0, 5.0)), form.energy(0.3, two_spheres(5.0, 2.0)));
}

TEST(ExactHamaker, RefusesAnAsperity) {
  expect_refused([] { Exact({1e-19, 4e-10, 1e-7, 1e-8}); }, "asperity radius = 1e-08");
}

}  // namespace cohesion::hamaker
