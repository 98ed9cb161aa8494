// SPDX-License-Identifier: BSD-3-Clause
#include "gas/sutherland.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cohesion::gas {

namespace {

constexpr Sutherland air{1.716e-5, 273.0, 111.0};

}  // namespace

TEST(Sutherland, IsTheReferenceAtItsTemperature) { EXPECT_DOUBLE_EQ(air.at(273.0), 1.716e-5); }

// (T/T0)^(3/2) (T0 + S)/S for T << S, and (T/T0)^(1/2) (1 + S/T0) for T >> S: to S/T and T/S.
TEST(Sutherland, TendsToItsTwoPowers) {
  const double cold = 1e-6 * 111.0, hot = 1e6 * 111.0;
  EXPECT_NEAR(air.at(cold) / (1.716e-5 * std::pow(cold / 273.0, 1.5) * 384.0 / 111.0), 1.0, 2e-6);
  EXPECT_NEAR(air.at(hot) / (1.716e-5 * std::sqrt(hot / 273.0) * 384.0 / 273.0), 1.0, 2e-6);
}

// Twice the reference temperature: 2 sqrt(2) (273 + 111)/(546 + 111).
TEST(Sutherland, IsAsPrinted) {
  EXPECT_NEAR(air.at(546.0), 1.716e-5 * std::sqrt(8.0) * 384.0 / 657.0, 1e-19);
}

}  // namespace cohesion::gas
