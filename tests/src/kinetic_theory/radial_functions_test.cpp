// SPDX-License-Identifier: BSD-3-Clause
#include "kinetic_theory/radial_functions.h"

#include <gtest/gtest.h>

namespace cohesion::kinetic_theory {
namespace {

/// y_ES as M. A. van der Hoef et al., Adv. Chem. Eng. 31 (2006) 65 plot it, evaluated there by
/// hand: four digits and more.
struct Row {
  double phi, carnahan_starling, ma_ahmadi, unit;  // unit: the last printed place
};
constexpr Row table[] = {{0.05, 0.2274, 0.2275, 1e-4},  {0.1, 0.5213, 0.5215, 1e-4},
                         {0.2, 1.4062, 1.4045, 1e-4},   {0.3, 2.9738, 2.9480, 1e-4},
                         {0.4, 5.926, 5.827, 1e-3},     {0.45, 8.385, 8.285, 1e-3},
                         {0.494, 11.485, 11.590, 1e-3}, {0.5, 12.00, 12.17, 1e-2},
                         {0.55, 17.50, 19.29, 1e-2},    {0.6, 26.25, 38.00, 1e-2}};

/// The derivative by differences: of sixth order, whose error is of the order of (h/0.04)^6/30 of
/// it nearest to a pole, 1e-14, and rounding, 1e-16/h of it, 1e-12.
double difference(double (*f)(double), double at) {
  const double h = 1e-4;
  return (45.0 * (f(at + h) - f(at - h)) - 9.0 * (f(at + 2.0 * h) - f(at - 2.0 * h)) +
          (f(at + 3.0 * h) - f(at - 3.0 * h))) /
         (60.0 * h);
}

}  // namespace

TEST(RadialFunctions, AreThoseOfTheTableToAllItsDigits) {
  for (const Row& row : table) {
    EXPECT_NEAR(excess_compressibility(row.phi, CarnahanStarling::contact_value(row.phi)),
                row.carnahan_starling, 0.5001 * row.unit)
        << row.phi;
    EXPECT_NEAR(excess_compressibility(row.phi, MaAhmadi::contact_value(row.phi)), row.ma_ahmadi,
                0.5001 * row.unit)
        << row.phi;
  }
}

TEST(RadialFunctions, SlopesAreTheirDerivatives) {
  for (const auto& law : radial_functions)
    for (const double phi : {0.001, 0.1, 0.3, 0.5, 0.55, 0.6}) {
      const double slope = law.slope(phi);
      EXPECT_NEAR(law.slope(phi) / difference(law.contact_value, phi), 1.0, 1e-10)
          << law.name << " " << phi << " " << slope;
    }
}

TEST(RadialFunctions, HaveTheVirialCoefficientsOfFewSpheres) {
  // chi = 1 + 5/2 phi + 4.59 phi^2 + ..., the third within the two per cent of Carnahan and
  // Starling's 4.5; what follows is some 7 phi^3.
  for (const auto& law : radial_functions) {
    EXPECT_DOUBLE_EQ(law.contact_value(0.0), 1.0) << law.name;
    EXPECT_DOUBLE_EQ(law.slope(0.0), 2.5) << law.name;
    const double phi = 1e-4, third = ((law.contact_value(phi) - 1.0) / phi - 2.5) / phi;
    EXPECT_NEAR(third, 4.59, 0.1) << law.name;
  }
}

TEST(RadialFunctions, GrowBeyondBoundsWhereTheyEnd) {
  for (const auto& law : radial_functions) {
    const double nearly = law.largest_fraction * (1.0 - 1e-9);
    EXPECT_GT(law.contact_value(nearly), 1e4) << law.name;
    EXPECT_LT(law.contact_value(nearly), 1e30) << law.name;
  }
}

TEST(ExcessCompressibility, FallsWithTheRestitutionAsTheMomentumOfACollision) {
  const double elastic = excess_compressibility(0.3, 2.0);
  EXPECT_DOUBLE_EQ(elastic, 2.4);
  EXPECT_DOUBLE_EQ(excess_compressibility(0.3, 2.0, 1.0), elastic);
  EXPECT_DOUBLE_EQ(excess_compressibility(0.3, 2.0, 0.8), 0.9 * elastic);
  EXPECT_DOUBLE_EQ(excess_compressibility(0.3, 2.0, 0.0), 0.5 * elastic);
}

}  // namespace cohesion::kinetic_theory
