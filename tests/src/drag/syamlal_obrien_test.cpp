// SPDX-License-Identifier: BSD-3-Clause
#include "drag/syamlal_obrien.h"

#include <gtest/gtest.h>

#include "sphere.h"

namespace cohesion::drag {
namespace {

const double d = 1e-3, rho = 1.205, mu = 1.75e-5;

/// The terminal velocity ratio as the positive root of the implicit law it was derived from,
///   V^2 + (0.06 Re - A) V - 0.06 Re B = 0,  found by bisection.
double terminal_ratio(double void_fraction, double reynolds) {
  const double a = std::pow(void_fraction, 4.14);
  const double b =
      void_fraction > 0.85 ? std::pow(void_fraction, 2.65) : 0.8 * std::pow(void_fraction, 1.28);
  double low = 0.0, high = 2.0;
  for (int i = 0; i < 200; i++) {
    const double v = 0.5 * (low + high);
    (v * v + (0.06 * reynolds - a) * v - 0.06 * reynolds * b > 0.0 ? high : low) = v;
  }
  return 0.5 * (low + high);
}

double independent(double void_fraction, double slip) {
  const double reynolds = d * slip * rho / mu;
  const double v = terminal_ratio(void_fraction, reynolds);
  const double c = 0.63 + 4.8 / std::sqrt(reynolds / v);
  return 3.0 * void_fraction * rho * slip * c * c / (4.0 * v * v * d);
}

}  // namespace

TEST(SyamlalOBrien, AgreesWithAnIndependentEvaluation) {
  for (const double void_fraction : {0.38, 0.45, 0.6, 0.85, 0.95})
    for (const double slip : {1e-3, 0.05, 0.8, 5.0}) {
      // Bisection and powers: some 1e-15 each, squared and divided.
      EXPECT_NEAR(SyamlalOBrien::per_solid_volume(void_fraction, slip, d, rho, mu) /
                      independent(void_fraction, slip),
                  1.0, 1e-12)
          << void_fraction << " " << slip;
    }
}

TEST(SyamlalOBrien, BecomesTheDragOfASingleSphere) {
  for (const double slip : {1e-4, 0.1, 2.0}) {
    const double reynolds = d * slip * rho / mu;
    const double c_d = std::pow(0.63 + 4.8 / std::sqrt(reynolds), 2);
    const double force = 0.5 * c_d * rho * slip * slip * pi / 4.0 * d * d;
    const double found =
        SyamlalOBrien::per_solid_volume(1.0, slip, d, rho, mu) * sphere_volume(d / 2.0) * slip;
    EXPECT_NEAR(found / force, 1.0, 1e-12) << slip;
  }
}

TEST(SyamlalOBrien, TendsToTheStokesRangeWithoutSlip) {
  // (4.8/sqrt(Re))^2 = 23.04/Re: b = 23.04/8 pi mu d for a single sphere.
  const double b = SyamlalOBrien::per_solid_volume(1.0, 0.0, d, rho, mu) * sphere_volume(d / 2.0);
  EXPECT_NEAR(b / (23.04 / 8.0 * pi * mu * d), 1.0, 1e-14);
}

TEST(SyamlalOBrien, StaysFiniteWithoutSlipInASuspension) {
  for (const double void_fraction : {0.4, 0.8}) {
    // V_t -> A, C_Ds |u - v| -> 4.8^2 A mu/(d rho), and 0.75 * 4.8^2 = 17.28.
    const double still = 17.28 * void_fraction * mu / (std::pow(void_fraction, 4.14) * d * d);
    EXPECT_NEAR(SyamlalOBrien::per_solid_volume(void_fraction, 0.0, d, rho, mu) / still, 1.0,
                1e-14);
    // At a slip of 1e-20 the ratio of 0.63 sqrt(slip) to 4.8 sqrt(A mu/(d rho)) is below 1e-9 for
    // A > 0.02; it counts twice.
    EXPECT_NEAR(SyamlalOBrien::per_solid_volume(void_fraction, 1e-20, d, rho, mu) / still, 1.0,
                2e-9);
  }
}

// The coefficient itself may fall with slip: V_t grows from A to B > A with Re and enters as
// V_t^-2.
TEST(SyamlalOBrien, DragForceRisesWithSlipAndWithSolidContent) {
  for (double slip = 1e-3; slip < 10.0; slip *= 2.0)
    for (double void_fraction = 0.35; void_fraction < 0.99; void_fraction += 0.05) {
      const auto force = [](double e, double s) {
        return SyamlalOBrien::per_solid_volume(e, s, d, rho, mu) * s;
      };
      EXPECT_GT(force(void_fraction, 2.0 * slip), force(void_fraction, slip));
      EXPECT_GT(force(void_fraction, slip), force(void_fraction + 0.01, slip));
    }
}

TEST(SyamlalOBrien, CarriesTheSpheresOfTheBedAtItsMinimumFluidisation) {
  // Drag and pressure gradient carry a sphere of 2650 kg/m3: beta/(1 - eps) slip/eps = weight per
  // volume, solved for the superficial velocity with 50 digits. (Ergun: 0.697 m/s at 0.43.)
  const double weight = 2650.0 * 9.81;
  struct {
    double void_fraction, velocity;
  } const rows[] = {{0.43, 0.70257744242955295}, {0.46, 0.82011359366385017}};
  for (const auto& [eps, velocity] : rows) {
    const double slip = velocity / eps;
    const double carried = SyamlalOBrien::per_solid_volume(eps, slip, d, rho, mu) * slip / eps;
    // V_t is half of A - 0.06 Re plus a root of nearly that size: 0.06 Re = 3 against V_t >= 0.2,
    // which makes 15 of each rounding of 1.1e-16, some five of them, and its square twice that.
    EXPECT_NEAR(carried / weight, 1.0, 2e-14) << eps;
  }
}

TEST(SyamlalOBrien, JumpsLittleWhereItsTwoBranchesMeet) {
  // B rises from 0.8 0.85^1.28 = 0.649750 to 0.85^2.65 = 0.650070, by 4.93e-4; the drag goes with
  // B to a power between 0 and -2.
  const double below = SyamlalOBrien::per_solid_volume(0.85, 1.0, d, rho, mu);
  const double above = SyamlalOBrien::per_solid_volume(std::nextafter(0.85, 1.0), 1.0, d, rho, mu);
  EXPECT_LT(above, below);
  EXPECT_GT(above / below, 1.0 - 2.0 * 4.93e-4);
}

}  // namespace cohesion::drag
