// SPDX-License-Identifier: BSD-3-Clause
#include "drag/rong.h"

#include <gtest/gtest.h>

#include "drag/gas_and_sphere.h"

namespace cohesion::drag {

TEST(Rong, BecomesDallaVallesSingleSphere) {
  for (const double reynolds : {1e-3, 1.0, 30.0, 1e3, 1e4}) {
    const double c_d = std::pow(0.63 + 4.8 / std::sqrt(reynolds), 2);
    EXPECT_NEAR(scaled_drag(&Rong::per_solid_volume, 1.0, reynolds) / (c_d * reynolds / 24.0), 1.0,
                1e-14)  // some twenty roundings
        << reynolds;
  }
}

TEST(Rong, ExponentIsThatOfBothEndsAndLowestInBetween) {
  for (const double eps : {0.4, 0.7, 1.0}) {
    const double still = 2.65 * (1.0 + eps);
    EXPECT_EQ(Rong::exponent(eps, 0.0), still);
    // exp(-(1.5 + 7.5)^2/2) = 3e-18: below the rounding of beta.
    EXPECT_NEAR(Rong::exponent(eps, std::pow(10.0, -7.5)), still, 2e-15);
    EXPECT_NEAR(Rong::exponent(eps, std::pow(10.0, 10.5)), still, 2e-15);
    EXPECT_NEAR(Rong::exponent(eps, 10.0), Rong::exponent(eps, 100.0), 2e-15);  // symmetric
  }
  // By hand: 2.65 * 1.5 - (5.3 - 1.75)/4 = 3.0875, and 5.3 - 1.8 = 3.5.
  EXPECT_NEAR(Rong::exponent(0.5, std::pow(10.0, 1.5)), 3.0875, 2e-15);
  EXPECT_NEAR(Rong::exponent(1.0, std::pow(10.0, 1.5)), 3.5, 2e-15);
}

TEST(Rong, StokesLimitIsThePowerOfTheVoidFraction) {
  for (const double eps : {0.4, 0.6, 0.8})
    EXPECT_NEAR(Rong::per_solid_volume(eps, 0.0, d, rho, mu) * d * d / (18.0 * mu),
                0.96 * std::pow(eps, 1.0 - 2.65 * (1.0 + eps)), 1e-13)  // of up to 12, roundings
        << eps;
}

// Ergun's equation is good to some 25 %; F_total taken for F_drag would be 2.5 times as much.
TEST(Rong, IsCloseToErgunInAPackedBed) {
  for (const double reynolds : {1e-3, 1.0, 50.0, 1000.0})
    EXPECT_NEAR(scaled_drag(&Rong::per_solid_volume, 0.4, reynolds) /
                    scaled_drag(&ErgunWenYu::per_solid_volume, 0.4, reynolds),
                1.0, 0.25)
        << reynolds;
}

}  // namespace cohesion::drag
