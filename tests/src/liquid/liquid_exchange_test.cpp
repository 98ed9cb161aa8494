// SPDX-License-Identifier: BSD-3-Clause
#include "liquid/liquid_exchange.h"

#include <gtest/gtest.h>

#include "drag/viscous_waves.h"
#include "liquid/sphere_in_liquid.h"

namespace cohesion::liquid {

TEST(LiquidExchange, WithoutAddedMassIsThatOfAGasToTheLastDigit) {
  for (const bool free : {false, true})
    for (const double b : {1e-9, 0.3, 1e6}) {
      EXPECT_EQ(source_coefficient(b, 0.7, 0.0, 0.01, free),
                drag::source_coefficient(b, 0.7, 0.01, free));
      EXPECT_EQ(transmitted_volume(b, 0.7, 0.0, 0.2, 0.01),
                drag::transmitted_volume(b, 0.7, 0.2, 0.01));
      EXPECT_EQ(source_inertia(b, 0.7, 0.0, 0.01, free), 0.0);
    }
}

TEST(LiquidExchange, ChargesWhatAFreeSphereFeels) {
  // Of slip, acceleration and pressure gradient, one by one: c, c_a and W are what the sphere feels
  // of drag and added mass, m a + V grad p, in a step of sphere_in_liquid.h.
  const double b = 1.3, mass = 0.02, added = 0.5, volume = 1.0, dt = 0.4;
  const SphereInLiquid sphere{b, 0.0, mass, added, {}};
  const auto felt = [&](double slip, double du, double gradient) {
    const Vector3 force{added * du - volume * gradient, 0.0, 0.0};
    return mass * acceleration(sphere, {slip, 0.0, 0.0}, force, dt).x + volume * gradient;
  };
  // A few roundings of numbers up to 1.
  EXPECT_NEAR(source_coefficient(b, mass, added, dt, true), felt(1.0, 0.0, 0.0), 2e-15);
  EXPECT_NEAR(source_inertia(b, mass, added, dt, true), felt(0.0, 1.0, 0.0), 2e-15);
  EXPECT_NEAR(transmitted_volume(b, mass, added, volume, dt), felt(0.0, 0.0, 1.0), 2e-15);
}

TEST(LiquidExchange, ASphereWithoutMassHandsOnItsPressureAlone) {
  EXPECT_EQ(source_coefficient(1.3, 0.0, 0.5, 0.1, true), 0.0);
  EXPECT_EQ(source_inertia(1.3, 0.0, 0.5, 0.1, true), 0.0);
  EXPECT_EQ(transmitted_volume(1.3, 0.0, 0.5, 2.0, 0.1), 2.0);
}

TEST(LiquidExchange, WavesHaveTheKappaOfTheGasWithoutAddedMass) {
  EXPECT_NEAR(displaced_with_added_mass(0.7, 0.1, 0.0), 0.3 / (0.7 * 0.1), 1e-14);
  EXPECT_EQ(viscous_share(0.7, 0.0), 1.0);
}

TEST(LiquidExchange, WavesOfSpheresWithoutMassDoNotGrowUpToTheStatedShares) {
  // kappa = (1 - eps)/eps (eps + C)/C against 2 S/(S + 1), of viscous_waves.h without viscosity.
  struct {
    int steps;
    double solid;
  } const rows[] = {{1, 0.29}, {5, 0.44}};
  for (const auto& [steps, solid] : rows)
    for (const double off : {-0.01, 0.01}) {
      const double eps = 1.0 - (solid + off);
      const drag::ViscousStep step{displaced_with_added_mass(eps, 1e-9, 0.5), 0.0,
                                   static_cast<double>(steps)};
      EXPECT_EQ(drag::viscous_waves_grow(step), off > 0.0) << steps << " " << off;
    }
}

}  // namespace cohesion::liquid
