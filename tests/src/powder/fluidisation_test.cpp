// SPDX-License-Identifier: BSD-3-Clause
#include "powder/fluidisation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "named_table.h"

namespace cohesion::powder {

namespace {

const Gas air{1.2, 1.8e-5};
constexpr double g = 9.81;

}  // namespace

// Slopes near the root are 1 to 5, values there are of numbers of 1 to 7: some roundings of these.
TEST(Fluidisation, RootsAreFoundToRoundOffInFewValues) {
  int values = 0;
  const auto counted = [&values](auto f) {
    values = 0;
    return [&values, f](double x) {
      values++;
      return f(x);
    };
  };
  for (const double guess : {1e-3, 1.0, 1e4}) {
    // What doubles and halves from the guess to the root takes, and twenty
    const auto few = [guess](double root) { return 22 + std::abs(std::log2(guess / root)); };
    EXPECT_NEAR(detail::root_of(counted([](double x) { return x - 0.3; }), guess), 0.3, 1e-15);
    EXPECT_LT(values, few(0.3)) << guess;
    EXPECT_NEAR(detail::root_of(counted([](double x) { return x * x * x - 2.0; }), guess),
                std::cbrt(2.0), 1e-15);
    EXPECT_LT(values, few(1.26)) << guess;
    EXPECT_NEAR(
        detail::root_of(counted([](double x) { return std::pow(x, 1.687) + x - 2.0; }), guess), 1.0,
        1e-15);
    EXPECT_LT(values, few(1.0)) << guess;
    // One that jumps over zero: there
    EXPECT_NEAR(
        detail::root_of(counted([](double x) { return x < 7.0 ? x - 7.1 : x + 500.0; }), guess),
        7.0, 2e-15);
  }
}

// 150 (1-eps)^2/eps^3 mu U/d^2 + 1.75 (1-eps)/eps^3 rho U^2/d = (1-eps) (rho_p - rho) g, solved.
TEST(Fluidisation, ByErgunIsTheRootOfItsQuadraticEquation) {
  const auto& ergun = find_by_name(drag::closures, "drag", "ergunWenYu");
  for (const double d : {3e-5, 3e-4, 3e-3})
    for (const double eps : {0.38, 0.42, 0.6}) {
      const Grain grain{d, 2500.0};
      const double a = 1.75 * air.density / (d * std::pow(eps, 3));
      const double b = 150.0 * (1.0 - eps) * air.viscosity / (d * d * std::pow(eps, 3));
      const double c = (grain.density - air.density) * g;
      const double speed = 2.0 * c / (b + std::sqrt(b * b + 4.0 * a * c));
      // Of a root to round-off, and some operations on either side
      EXPECT_NEAR(minimum_fluidisation(ergun, eps, grain, air, g), speed, 1e-13 * speed) << d;
    }
}

// At the speed found every closure carries the weight.
TEST(Fluidisation, DragOfEveryClosureCarriesTheBed) {
  const Grain grain{2e-4, 1500.0};
  const double eps = 0.45;
  for (const drag::Closure& closure : drag::closures) {
    const double slip = minimum_fluidisation(closure, eps, grain, air, g) / eps;
    const double beta = (1.0 - eps) * closure.per_solid_volume(eps, slip, grain.diameter,
                                                               air.density, air.viscosity);
    const double weight = (1.0 - eps) * (grain.density - air.density) * g;
    EXPECT_NEAR(beta * slip / eps, weight, 1e-12 * weight) << closure.name;
  }
}

// At Ar = 1e4: Re = sqrt(1135.69 + 408) - 33.7.
TEST(Fluidisation, WenAndYuIsAsPrinted) {
  const double d =
      std::cbrt(1e4 * air.viscosity * air.viscosity / (air.density * (2500.0 - air.density) * g));
  const Grain grain{d, 2500.0};
  EXPECT_NEAR(archimedes(grain, air, g), 1e4, 1e-9);
  const double reynolds = std::sqrt(1543.69) - 33.7;
  EXPECT_NEAR(wen_yu_minimum_fluidisation(grain, air, g) * air.density * d / air.viscosity,
              reynolds, 1e-12);
}

TEST(Fluidisation, FineSpheresFallAsStokesSays) {
  const Grain grain{1e-7, 2500.0};
  const double stokes =
      (grain.density - air.density) * g * grain.diameter * grain.diameter / (18.0 * air.viscosity);
  const double reynolds = air.density * stokes * grain.diameter / air.viscosity;
  EXPECT_NEAR(terminal_speed(grain, air, g) / stokes, 1.0, 0.15 * std::pow(reynolds, 0.687));
}

// In Newton's range C_D = 0.44: v^2 = 4/3 (rho_p/rho - 1) g d/0.44.
TEST(Fluidisation, CoarseSpheresFallAsNewtonSays) {
  const Grain grain{0.02, 2500.0};
  const double newton =
      std::sqrt(4.0 / 3.0 * (grain.density / air.density - 1.0) * g * grain.diameter / 0.44);
  EXPECT_NEAR(terminal_speed(grain, air, g), newton, 1e-12 * newton);
}

TEST(Fluidisation, WhatGasDoesNotLiftIsRefused) {
  const auto& closure = drag::closures.front();
  EXPECT_THROW(terminal_speed({1e-4, 1.0}, air, g), InvalidParameter);
  EXPECT_THROW(terminal_speed({0.0, 1e3}, air, g), InvalidParameter);
  EXPECT_THROW(minimum_fluidisation(closure, 1.0, {1e-4, 1e3}, air, g), InvalidParameter);
  EXPECT_THROW(minimum_fluidisation(closure, 0.4, {1e-4, 1e3}, {1.2, 0.0}, g), InvalidParameter);
}

}  // namespace cohesion::powder
