// SPDX-License-Identifier: BSD-3-Clause
#include "gas/compressibility.h"

#include <gtest/gtest.h>

namespace cohesion::gas {

namespace {

constexpr CriticalPoint carbon_dioxide{304.13, 7.3773e6};

}  // namespace

// At T = Tc: (P/Pc) (0.083 - 0.422).
TEST(Compressibility, IsAsPrintedAtTheCriticalTemperature) {
  EXPECT_NEAR(departure_from_ideal(carbon_dioxide, 7.3773e4, 304.13), -0.00339, 1e-15);
}

TEST(Compressibility, GrowsWithThePressureAndVanishesWithoutIt) {
  EXPECT_EQ(departure_from_ideal(carbon_dioxide, 0.0, 300.0), 0.0);
  EXPECT_DOUBLE_EQ(departure_from_ideal(carbon_dioxide, 2e5, 300.0),
                   2.0 * departure_from_ideal(carbon_dioxide, 1e5, 300.0));
}

// 0.083 = 0.422 (Tc/T)^1.6 at T = 2.7636 Tc, Boyle's temperature; hotter gases are less dense.
TEST(Compressibility, ChangesItsSignAtBoylesTemperature) {
  EXPECT_LT(departure_from_ideal(carbon_dioxide, 1e6, 2.76 * 304.13), 0.0);
  EXPECT_GT(departure_from_ideal(carbon_dioxide, 1e6, 2.77 * 304.13), 0.0);
}

}  // namespace cohesion::gas
