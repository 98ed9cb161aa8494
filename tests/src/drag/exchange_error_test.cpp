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
      // The gas's mass is 1: a step charges it with R g u, and with what was pending, R (x - g) u.
      const double g = -std::expm1(-x);
      double u = 1.0, before = 0.0, pending = 0.0;
      for (int i = 0; i < 3; i++) {
        before = u;
        u = (u - pending) / (1.0 + loading * g);
        pending = loading * (x - g) * u;
      }
      EXPECT_NEAR(held_growth(x, loading), std::abs(u / before), 1e-12 * std::abs(u / before));
    }
  // Stable with light or slow particles, R (x - 2 g) < 2
  EXPECT_LT(held_growth(3.0, 1.0), 1.0);
  EXPECT_GT(held_growth(4.0, 1.0), 1.0);
}

TEST(ExchangeError, PressureAndFreeParticlesGrowAsTheyDoStepByStep) {
  for (const bool free : {false, true})
    for (const double x : {0.05, 0.4, 1.0, 5.0, 1e3})
      for (const double eps : {0.3, 0.45, 0.62, 0.8, 0.95}) {
        // The cell's momentum: eps/(1 - eps) of the particles' pressure, and what the gas is
        // charged with, are zero together while its flux stays.
        const double g = -std::expm1(-x), c = free ? g : x;
        double v = 1.0, pending = 0.3, before = 0.0;
        const int n = 4000;
        double log_size = 0.0;
        for (int i = 0; i < n; i++) {
          const double charged = -c * v;
          const double pressure = -(1.0 - eps) / eps * (charged + pending);
          const double follows = -pressure / x;
          const double then = v;
          v = follows + (v - follows) * (1.0 - g);
          pending = (v - then + pressure) - charged;
          const double size = std::hypot(x * v, pending);
          v /= size;
          pending /= size;
          if (i >= n / 2) log_size += std::log(size);
          before = size;
        }
        EXPECT_GT(before, 0.0);
        // The mean over n/2 steps; the direction turns, its size by less than a factor of 1e4.
        EXPECT_NEAR(std::log(pressure_growth(x, eps, free)), 2.0 * log_size / n,
                    std::log(1e4) / (0.5 * n));
      }
}

// For particles taken to be held, the eigenvalue is -1 where (2 - g)/(2 + g - 2 g/x) = k.
TEST(ExchangeError, PressureAndFreeParticlesGrowFromAStepOn) {
  for (const double eps : {0.2, 0.3, 0.4, 0.5, 0.62, 0.7}) {
    const double x = longest_pressure_step(eps, false);
    const double g = -std::expm1(-x);
    // x is found to 1e-6 of it, and where the growth is 1 + 1e-6.
    EXPECT_NEAR((2.0 - g) / (2.0 + g - 2.0 * g / x), (1.0 - eps) / eps, 1e-5 / eps);
  }
  for (const bool free : {false, true})
    for (const double eps : {0.2, 0.3, 0.4, 0.49}) {
      const double limit = longest_pressure_step(eps, free);
      for (const double share : {0.01, 0.1, 0.5, 0.99})
        EXPECT_LT(pressure_growth(share * limit, eps, free), 1.0);
      for (const double share : {1.01, 2.0, 10.0, 1e6})
        EXPECT_GT(pressure_growth(share * limit, eps, free), 1.0);
    }
  for (const double eps : {0.76, 0.9, 1.0})
    EXPECT_TRUE(std::isinf(longest_pressure_step(eps, false)));
  EXPECT_TRUE(std::isinf(longest_pressure_step(0.51, true)));
}

TEST(ExchangeError, PressureAndStiffFreeParticlesGrowBelowAVoidFraction) {
  EXPECT_NEAR(pressure_growth(1e9, 0.75, false), 1.0, 1e-6);
  EXPECT_NEAR(pressure_growth(1e9, 0.5, true), 1.0, 1e-6);
  EXPECT_NEAR(pressure_growth(1e-9, 0.3, false), 1.0, 1e-8);
  EXPECT_EQ(pressure_growth(0.0, 0.3, false), 1.0);
  // One step and the drag is done, nothing else: exp(-x)
  EXPECT_NEAR(pressure_growth(1.0, 1.0, false), std::exp(-1.0), 1e-15);
}

TEST(ExchangeError, StepAndLoadingOfABedOfPowder) {
  // 6 particles of 2 mg and 1 mm^3 in 10 mm^3 of bed: 12 mg beside 4 mm^3 of gas at 0.001 mg/mm^3.
  EXPECT_NEAR(mass_loading(0.4, 2.0, 1.0, 0.001), 12.0 / 0.004, 3000 * 1e-15);
  EXPECT_EQ(mass_loading(1.0, 2.0, 1.0, 0.001), 0.0);
  // Under the drag alone the slip falls to exp(-x) in a step.
  EXPECT_EQ(exchange_step(4.0, 2.0, 0.25), 0.5);
}

}  // namespace cohesion::drag
