// SPDX-License-Identifier: BSD-3-Clause
// Pressure and collisions of a gas of grains: each against another form of itself.
#include <gtest/gtest.h>

#include "kinetic_theory/collision_rates.h"
#include "kinetic_theory/granular_pressure.h"
#include "kinetic_theory/radial_functions.h"
#include "sphere.h"

namespace cohesion::kinetic_theory {
namespace {

constexpr double density = 1500.0, diameter = 75e-6, theta = 0.01;
const double mass = density * sphere_volume(0.5 * diameter);

}  // namespace

TEST(GranularPressure, IsThatOfTheExcessCompressibility) {
  for (const double e : {1.0, 0.9, 0.5})
    for (const double phi : {0.01, 0.3, 0.6}) {
      const double chi = MaAhmadi::contact_value(phi), y = excess_compressibility(phi, chi, e);
      EXPECT_NEAR(
          (GranularPressure{density, e}.over_temperature(phi, chi)) / (density * phi * (1.0 + y)),
          1.0, 1e-15);
    }
}

TEST(GranularPressure, HasItsDerivativeAsSlope) {
  // By differences of fourth order: error (h/0.04)^4/5 at the most, 1e-12, and rounding.
  const double h = 1e-4;
  for (const auto& law : radial_functions)
    for (const double phi : {0.05, 0.3, 0.55}) {
      const GranularPressure pressure{density, 0.8};
      const auto at = [&](double p) { return pressure.over_temperature(p, law.contact_value(p)); };
      const double difference =
          (8.0 * (at(phi + h) - at(phi - h)) - (at(phi + 2.0 * h) - at(phi - 2.0 * h))) /
          (12.0 * h);
      EXPECT_NEAR(pressure.slope(phi, law.contact_value(phi), law.slope(phi), {}) / difference, 1.0,
                  1e-9);
    }
}

TEST(CollisionRates, TakeTheEnergyOfTheNormalSpeedsOfMaxwell) {
  // Normal speeds u of those that meet go with u exp(-u^2/(4 theta)), so <u^2> = 4 theta, and a
  // collision takes (1 - e^2) m u^2/4; each has two partners.
  const double phi = 0.3, chi = 2.0, e = 0.8, number = density * phi / mass;
  const double meetings = 0.5 * number * collision_frequency(phi, chi, theta, diameter);
  EXPECT_NEAR(dissipation(phi, chi, e, theta, diameter, density) /
                  (meetings * (1.0 - e * e) * mass * theta),
              1.0, 1e-14);
}

TEST(CollisionRates, AreThoseOfKineticTheoryForFewSpheres) {
  // sqrt(2) n pi d^2 <v>, <v> = sqrt(8 theta/pi)
  const double phi = 1e-3, number = density * phi / mass;
  EXPECT_NEAR(
      collision_frequency(phi, 1.0, theta, diameter) /
          (std::sqrt(2.0) * number * pi * diameter * diameter * std::sqrt(8.0 * theta / pi)),
      1.0, 1e-14);
}

TEST(CollisionRates, GiveTheCompressibilityBack) {
  for (const double phi : {0.01, 0.5}) {
    const double chi = CarnahanStarling::contact_value(phi);
    const double frequency = collision_frequency(phi, chi, theta, diameter);
    EXPECT_NEAR(
        compressibility_of_frequency(frequency, theta, diameter) / excess_compressibility(phi, chi),
        1.0, 1e-14);
  }
}

}  // namespace cohesion::kinetic_theory
