// SPDX-License-Identifier: BSD-3-Clause
#include "gas/ideal_gas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "refuses.h"

namespace cohesion::gas {

// Dry air of 28.9647 kg/kmol at 101325 Pa and 0 C: 1.2922 kg/m3 in the tables, to the last digit.
TEST(IdealGas, AirHasItsDensity) {
  EXPECT_NEAR(IdealGas(101325.0, 273.15, 28.9647).density(), 1.2922, 1.0e-4);
}

// c^2 = P/rho; the adiabatic 331.3 m/s of air at 0 C is sqrt(1.4) times it, to a digit of 1.400.
TEST(IdealGas, SoundTravelsAtTheRootOfPressureOverDensity) {
  const IdealGas air(101325.0, 273.15, 28.9647);
  EXPECT_NEAR(air.sound_speed(), std::sqrt(101325.0 / air.density()), 1e-12);
  EXPECT_NEAR(air.sound_speed() * std::sqrt(1.4), 331.3, 331.3 * 0.5 * 0.001);
}

TEST(IdealGas, DensityFollowsPressure) {
  const IdealGas low(1.0e5, 300.0, 28.9), high(2.5e5, 300.0, 28.9);
  const double p = 1.5e5 / low.density();
  EXPECT_NEAR(low.density() * (1.0 + low.compressibility() * p), high.density(), 1e-15);
}

TEST(IdealGas, RefusesWhatNoGasHas) {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    expect_refused([bad] { IdealGas(bad, 300.0, 28.9); }, "pressure = ");
    expect_refused([bad] { IdealGas(1e5, bad, 28.9); }, "temperature = ");
    expect_refused([bad] { IdealGas(1e5, 300.0, bad); }, "molWeight = ");
  }
}

}  // namespace cohesion::gas
