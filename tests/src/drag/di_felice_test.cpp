// SPDX-License-Identifier: BSD-3-Clause
#include "drag/di_felice.h"

#include <gtest/gtest.h>

#include "drag/gas_and_sphere.h"

namespace cohesion::drag {

TEST(DiFelice, BecomesDallaVallesSingleSphere) {
  for (const double reynolds : {1e-3, 1.0, 30.0, 1e3, 1e4}) {
    const double c_d = std::pow(0.63 + 4.8 / std::sqrt(reynolds), 2);
    EXPECT_NEAR(scaled_drag(&DiFelice::per_solid_volume, 1.0, reynolds) / (c_d * reynolds / 24.0),
                1.0, 1e-14)  // some twenty roundings
        << reynolds;
  }
}

TEST(DiFelice, ExponentIsTheSameAtBothEndsAndLowestInBetween) {
  EXPECT_EQ(DiFelice::exponent(0.0), 3.7);
  // exp(-(1.5 + 7.5)^2/2) = 3e-18: below the rounding of 3.7.
  EXPECT_NEAR(DiFelice::exponent(std::pow(10.0, -7.5)), 3.7, 1e-15);
  EXPECT_NEAR(DiFelice::exponent(std::pow(10.0, 10.5)), 3.7, 1e-15);
  EXPECT_NEAR(DiFelice::exponent(std::pow(10.0, 1.5)), 3.05, 1e-15);
  EXPECT_NEAR(DiFelice::exponent(10.0), DiFelice::exponent(100.0), 1e-15);  // symmetric
}

TEST(DiFelice, SuspensionsSettleByRichardsonAndZakiWithoutInertia) {
  // As in ErgunWenYu's test; xi is an exponent of F_drag, which makes xi + 1 = 4.7 of F_total.
  const auto speed = [](double eps) {
    return eps * eps / DiFelice::per_solid_volume(eps, 0.0, d, rho, mu);
  };
  for (const double eps : {0.4, 0.6, 0.9})
    EXPECT_NEAR(speed(eps) / (speed(1.0) * std::pow(eps, 4.7)), 1.0, 1e-14) << eps;
}

// A packed bed is no limit of the formula but close to Ergun's, which is good to some 25 %;
// F_total taken for F_drag would be 2.5 times as much.
TEST(DiFelice, IsCloseToErgunInAPackedBed) {
  for (const double reynolds : {1.0, 50.0, 1000.0})
    EXPECT_NEAR(scaled_drag(&DiFelice::per_solid_volume, 0.4, reynolds) /
                    scaled_drag(&ErgunWenYu::per_solid_volume, 0.4, reynolds),
                1.0, 0.25)
        << reynolds;
}

}  // namespace cohesion::drag
