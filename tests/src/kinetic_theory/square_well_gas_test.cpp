// SPDX-License-Identifier: BSD-3-Clause
#include "kinetic_theory/square_well_gas.h"

#include <limits>

#include "kinetic_theory/radial_functions.h"
#include "kinetic_theory/second_virial.h"
#include "refuses.h"

namespace cohesion::kinetic_theory {

TEST(SquareWellGas, IsWithinWhatTheLawSaysOfTheGasesThatWereMeasured) {
  // All fifteen elastic gases of examples/compressibility: phi, y/y_HS at D/T = 0.3, 0.6, 1,
  // printed with three decimals: 0.007 and half of the last
  const struct {
    double phi, ratios[3];
  } rows[] = {{0.1, {0.930, 0.846, 0.695}},
              {0.2, {0.918, 0.825, 0.667}},
              {0.3, {0.910, 0.798, 0.630}},
              {0.4, {0.892, 0.774, 0.614}},
              {0.5, {0.888, 0.770, 0.598}}};
  const double depth = 2e-14, mass = 3e-10, depths[] = {0.3, 0.6, 1.0};
  const SquareWellGas gas(depth, 1.05, mass);
  for (const auto& row : rows)
    for (int i = 0; i < 3; i++) {
      // A hair warmer than D/T, so that 1 is inside
      const double theta = depth / mass / depths[i] * (1.0 + 1e-9);
      const auto found = gas.ratio(row.phi, theta);
      EXPECT_NEAR(found.cohesion.ratio, row.ratios[i], 0.0075) << row.phi << " " << depths[i];
      EXPECT_FALSE(found.too_cold || found.too_dense) << row.phi << " " << depths[i];
    }
}

TEST(SquareWellGas, HasTheSecondVirialCoefficientOfFewGrains) {
  const double mass = 2.0, theta = 3.0;
  for (const double lambda : {1.01, 1.05, 1.2})
    for (const double depth_over_t : {0.01, 0.2, 0.31}) {
      const SquareWellGas gas(depth_over_t * mass * theta, lambda, mass);
      const auto found = gas.ratio(0.0, theta);
      ASSERT_FALSE(found.too_cold);
      EXPECT_NEAR(found.cohesion.ratio, second_virial_of_well(lambda, depth_over_t), 1e-14);
    }
}

TEST(SquareWellGas, IsExactlyThatOfSpheresWithoutWells) {
  for (const SquareWellGas& gas : {SquareWellGas(0.0, 1.05, 1e-10), SquareWellGas(1.0, 1.0, 1.0)})
    for (const double phi : {-1e-9, 0.0, 0.3, 0.6})
      for (const double theta : {0.0, 1e-9, 1.0}) {
        const auto found = gas.ratio(phi, theta);
        EXPECT_EQ(found.cohesion.ratio, 1.0);
        EXPECT_EQ(found.cohesion.slope, 0.0);
        EXPECT_FALSE(found.too_cold || found.too_dense);
        const GranularPressure pressure{1500.0, 0.9};
        EXPECT_EQ(pressure.over_temperature(phi, 1.7, found.cohesion.ratio),
                  pressure.over_temperature(phi, 1.7));
        EXPECT_EQ(pressure.slope(phi, 1.7, 4.3, found.cohesion),
                  pressure.slope(phi, 1.7, 4.3, GranularPressure::Cohesion{}));
      }
}

TEST(SquareWellGas, StaysAtTheEndOfTheRangeAndSaysSo) {
  const SquareWellGas gas(1.0, 1.05, 1.0);
  const auto end = gas.ratio(0.5, 1.0 + 1e-12);
  for (const double theta : {0.99, 1e-3, 1e-200, 0.0}) {
    const auto cold = gas.ratio(0.5, theta);
    EXPECT_TRUE(cold.too_cold) << theta;
    EXPECT_FALSE(cold.too_dense) << theta;
    EXPECT_NEAR(cold.cohesion.ratio, end.cohesion.ratio, 1e-11) << theta;
    EXPECT_NEAR(cold.cohesion.slope, end.cohesion.slope, 1e-11) << theta;
  }
  const auto dense = gas.ratio(0.6, 2.0);
  EXPECT_TRUE(dense.too_dense);
  EXPECT_FALSE(dense.too_cold);
  EXPECT_EQ(dense.cohesion.ratio, gas.ratio(0.5, 2.0).cohesion.ratio);
  EXPECT_EQ(dense.cohesion.slope, 0.0);
  // Wider wells gather as much at less depth: (1.1^3 - 1)(exp(x) - 1) = (1.05^3 - 1)(e - 1)
  EXPECT_NEAR(SquareWellGas(1.0, 1.1, 1.0).largest_depth_over_t(),
              std::log(1.0 + 0.157625 * (std::exp(1.0) - 1.0) / 0.331), 1e-14);
}

TEST(SquareWellGas, HasItsDerivativeAsSlopeOfThePressure) {
  // Differences of fourth order, as of GranularPressure in transport_test.cpp
  const double h = 1e-4;
  for (const auto& law : radial_functions)
    for (const double phi : {0.05, 0.3, 0.45, 0.55})
      for (const double theta : {0.5, 1.0, 3.0}) {
        const SquareWellGas gas(1.0, 1.05, 1.0);
        const GranularPressure pressure{1500.0, 1.0};
        const auto at = [&](double p) {
          return pressure.over_temperature(p, law.contact_value(p),
                                           gas.ratio(p, theta).cohesion.ratio);
        };
        const double difference =
            (8.0 * (at(phi + h) - at(phi - h)) - (at(phi + 2.0 * h) - at(phi - 2.0 * h))) /
            (12.0 * h);
        EXPECT_NEAR(pressure.slope(phi, law.contact_value(phi), law.slope(phi),
                                   gas.ratio(phi, theta).cohesion) /
                        difference,
                    1.0, 1e-9);
      }
}

TEST(SquareWellGas, HasAPressureThatRisesWithTheFraction) {
  const SquareWellGas gas(1.0, 1.05, 1.0);
  for (const auto& law : radial_functions)
    for (int permille = 0; permille < 640; permille++)
      for (const double theta : {0.0, 1.0, 2.0}) {
        const double phi = permille / 1000.0;
        EXPECT_GT((GranularPressure{1.0, 1.0}.slope(phi, law.contact_value(phi), law.slope(phi),
                                                    gas.ratio(phi, theta).cohesion)),
                  0.9)
            << phi << " " << theta;
      }
}

TEST(SquareWellGas, RefusesWhatIsNoWellAndNoGrain) {
  expect_refused([] { SquareWellGas(-1.0, 1.05, 1.0); }, "depth D");
  expect_refused([] { SquareWellGas(1.0, 0.9, 1.0); }, "ratio r_out/r");
  expect_refused([] { SquareWellGas(1.0, std::numeric_limits<double>::quiet_NaN(), 1.0); },
                 "ratio r_out/r");
  expect_refused([] { SquareWellGas(1.0, 1.05, 0.0); }, "mass of a grain");
}

}  // namespace cohesion::kinetic_theory
