// SPDX-License-Identifier: BSD-3-Clause
#include "drag/exchange_error.h"

#include <gtest/gtest.h>

namespace cohesion::drag {

TEST(ExchangeError, VanishesWithTheStepAndWithTheGas) {
  EXPECT_EQ(exchange_error(0.0, 10.0, false), 0.0);
  EXPECT_EQ(exchange_error(5.0, 0.0, false), 0.0);
  // Second order in the step: the series of both gains begin with x, and then
  // x - x^2 (1 + R)/2 against x - x^2 (1/2 + R): off by R x^2/2. The next order is some 1e-4 of it.
  for (const double loading : {0.5, 2.0, 20.0}) {
    const double x = 1e-4 / (1.0 + loading);
    EXPECT_NEAR(exchange_error(x, loading, false) / (0.5 * loading * x * x), 1.0, 1e-3);
  }
}

TEST(ExchangeError, OfAStiffStepIsTheShareOfTheLighterParticles) {
  for (const double loading : {0.1, 1.0, 100.0})
    EXPECT_NEAR(exchange_error(1e9, loading, false), 1.0 / (1.0 + loading), 1e-7 / loading);
}

TEST(ExchangeError, IsThatOfTheExchangeStepByStep) {
  for (const double x : {0.03, 0.7, 4.0})
    for (const double loading : {0.2, 3.0}) {
      // Gas at 1, particles at 0; the gas first, by x R per unit of its mass, then the particles.
      const double gas = 1.0 / (1.0 + loading * x);
      double particles = 0.0;
      const int n = 2000;
      for (int i = 0; i < n; i++) particles = (particles + x / n * gas) / (1.0 + x / n);
      // Together, in as many small steps
      double u = 1.0, v = 0.0;
      for (int i = 0; i < n; i++) {
        const double exchanged = x / n * (u - v) / (1.0 + x / n * (1.0 + loading));
        u -= loading * exchanged;
        v += exchanged;
      }
      // Implicit steps are off by half their size times the rate, of what is exchanged.
      const double error = x * (1.0 + loading) / n;
      EXPECT_NEAR(exchange_error(x, loading, false), std::abs(v - particles), error);
    }
}

TEST(ExchangeError, IsLateInStepsLongerThanTheTimeOfAParticleAlone) {
  for (const bool free : {false, true}) {
    EXPECT_EQ(late_exchange_error(1.0, 0.2, free), 0.0);
    EXPECT_EQ(late_exchange_error(1.001, 0.2, free), exchange_error(1.001, 0.2, free));
  }
  // With light particles worth a warning, with heavy ones not: 1/(1 + R) in a stiff step
  EXPECT_GT(late_exchange_error(1e6, 18.0, false), exchange_error_limit);
  EXPECT_LT(late_exchange_error(1e6, 20.0, false), exchange_error_limit);
}

TEST(ExchangeError, WithParticlesThatFollowIsSmallAtBothEnds) {
  for (const double loading : {0.1, 1.0, 100.0}) {
    EXPECT_NEAR(exchange_error(1e9, loading, true), 0.0, 1e-15);
    // x - x^2 (1 + R)/2 against x - x^2 (1/2 + R) again
    const double x = 1e-4 / (1.0 + loading);
    EXPECT_NEAR(exchange_error(x, loading, true) / (0.5 * loading * x * x), 1.0, 1e-3);
  }
}

TEST(ExchangeError, GasBetweenHeldParticlesGrowsAsItDoesStepByStep) {
  for (const double x : {0.1, 3.0, 200.0})
    for (const double loading : {0.01, 1.0, 50.0}) {
      // The gas's mass is 1: a step charges it with R g u, and with what was deferred, R (x - g) u.
      const double g = -std::expm1(-x);
      double u = 1.0, before = 0.0, deferred = 0.0;
      for (int i = 0; i < 3; i++) {
        before = u;
        u = (u - deferred) / (1.0 + loading * g);
        deferred = loading * (x - g) * u;
      }
      EXPECT_NEAR(fixed_bed_growth(x, loading), std::abs(u / before), 1e-12 * std::abs(u / before));
    }
  // Stable with light or slow particles, R (x - 2 g) < 2
  EXPECT_LT(fixed_bed_growth(3.0, 1.0), fixed_bed_growth_limit);
  EXPECT_GT(fixed_bed_growth(4.0, 1.0), fixed_bed_growth_limit);
}

TEST(ExchangeError, StepAndLoadingOfABedOfPowder) {
  // 6 particles of 2 mg and 1 mm^3 in 10 mm^3 of bed: 12 mg beside 4 mm^3 of gas at 0.001 mg/mm^3.
  EXPECT_NEAR(mass_loading(0.4, 2.0, 1.0, 0.001), 12.0 / 0.004, 3000 * 1e-15);
  EXPECT_EQ(mass_loading(1.0, 2.0, 1.0, 0.001), 0.0);
  // Under the drag alone the slip falls to exp(-x) in a step.
  EXPECT_EQ(exchange_step(4.0, 2.0, 0.25), 0.5);
}

}  // namespace cohesion::drag
