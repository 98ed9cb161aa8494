// SPDX-License-Identifier: BSD-3-Clause
#include "liquid/lift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sphere.h"

namespace cohesion::liquid {
namespace {

constexpr double d = 2e-3, rho = 1000.0, mu = 1e-2;

/// The flow of a Reynolds number and of Mei's a = d |omega|/(2 |u - v|).
ShearedFlow flow(double reynolds, double a) {
  const double slip = reynolds * mu / (rho * d);
  return {2.0 * a * slip / d, slip, d, rho, mu};
}

}  // namespace

TEST(Lift, OfInviscidFluidIsAHalf) { EXPECT_EQ(inviscid_lift(flow(100.0, 0.1)), 0.5); }

TEST(Lift, OfSaffmanHasHisForceAtSmallReynoldsNumbers) {
  // F = 1.615 mu d |u - v| sqrt(rho d^2 |omega|/mu), the factor of Mei being 1 - Re/10 (1 - root)
  // and more: within Re/10.
  const ShearedFlow at = flow(1e-6, 0.1);
  const double force = 1.615 * mu * d * at.slip * std::sqrt(rho * d * d * at.vorticity / mu);
  const double found = saffman_mei_lift(at) * rho * sphere_volume(d / 2.0) * at.slip * at.vorticity;
  EXPECT_NEAR(found / force, 1.0, 1e-7);
}

TEST(Lift, OfMeiHasThePublishedFactors) {
  // Over Saffman's, by hand: Re = 10, a = 0.25: root = 0.1657, 0.8343/e + 0.1657 = 0.472622;
  // Re = 100, a = 0.16: 0.0524 * 4 = 0.2096.
  struct {
    double reynolds, a, factor;
  } const rows[] = {{10.0, 0.25, 0.472622}, {100.0, 0.16, 0.2096}};
  for (const auto& [reynolds, a, factor] : rows) {
    const ShearedFlow at = flow(reynolds, a);
    const double saffman = 1.615 * 6.0 / pi * std::sqrt(mu / (rho * d * d * at.vorticity));
    EXPECT_NEAR(saffman_mei_lift(at) / saffman, factor, 1e-6) << reynolds;
  }
}

TEST(Lift, OfMeiMeetsItselfAtForty) {
  // exp(-4) = 0.0183 of it is left below, as the fit has it.
  const double below = saffman_mei_lift(flow(39.999999, 0.1));
  const double above = saffman_mei_lift(flow(40.000001, 0.1));
  EXPECT_NEAR((below - above) / above, std::exp(-4.0) * (1.0 / (0.3314 * std::sqrt(0.1)) - 1.0),
              1e-3);
}

TEST(Lift, IsFiniteWithoutShearOrSlip) {
  EXPECT_EQ(saffman_mei_lift({0.0, 0.3, d, rho, mu}), 0.0);
  EXPECT_TRUE(std::isfinite(saffman_mei_lift({10.0, 0.0, d, rho, mu})));
  EXPECT_GT(saffman_mei_lift({10.0, 0.0, d, rho, mu}), 0.0);
}

}  // namespace cohesion::liquid
