// SPDX-License-Identifier: BSD-3-Clause
#include "drag/ergun_wen_yu.h"

#include <gtest/gtest.h>

#include "drag/ergun_rowe_henwood.h"
#include "drag/gas_and_sphere.h"

namespace cohesion::drag {
namespace {

const double rounding = 1e-14;  // some ten operations on either side

}  // namespace

TEST(ErgunWenYu, LosesErgunsPressureInAPackedBed) {
  for (const double eps : {0.38, 0.45, 0.6, 0.79})
    for (const double velocity : {1e-3, 0.3, 3.0}) {
      const double solid = 1.0 - eps;
      const double gradient = 150.0 * solid * solid / (eps * eps * eps) * mu * velocity / (d * d) +
                              1.75 * solid / (eps * eps * eps) * rho * velocity * velocity / d;
      const double slip = velocity / eps;
      const double drag = ErgunWenYu::per_solid_volume(eps, slip, d, rho, mu) * solid * slip;
      EXPECT_NEAR(drag / (eps * gradient), 1.0, rounding) << eps << " " << velocity;
    }
}

TEST(ErgunWenYu, BecomesCarmanAndKozenyWithoutInertia) {
  const double eps = 0.4, solid = 0.6;
  // F_total = 150 (1 - eps)/(18 eps^3), Ergun's constant in the place of 180.
  EXPECT_NEAR(scaled_drag(&ErgunWenYu::per_solid_volume, eps, 1e-12) / eps,
              150.0 * solid / (18.0 * eps * eps * eps), 1e-12 * 13.0);  // 1.75 Re/(18 eps^3)
}

TEST(ErgunWenYu, CarriesTheBedAtErgunsMinimumFluidisation) {
  // Drag and pressure gradient carry the sphere: F_drag/eps = weight. Ergun's quadratic for Re:
  // 1.75/eps^3 Re^2 + 150 (1 - eps)/eps^3 Re = Ar.
  for (const double eps : {0.43, 0.46}) {
    const double weight = 2650.0 * 9.81 * sphere_volume(d / 2.0);
    const double ar = 6.0 / pi * weight * rho / (mu * mu);
    const double linear = 150.0 * (1.0 - eps);
    const double reynolds =
        (-linear + std::sqrt(linear * linear + 7.0 * ar * eps * eps * eps)) / 3.5;
    const double slip = slip_at(eps, reynolds);
    const double drag =
        ErgunWenYu::per_solid_volume(eps, slip, d, rho, mu) * sphere_volume(d / 2.0) * slip;
    EXPECT_NEAR(drag / eps / weight, 1.0, rounding) << eps;
  }
}

TEST(ErgunWenYu, BecomesSchillerAndNaumannsSingleSphere) {
  for (const double reynolds : {1e-3, 1.0, 100.0, 999.0, 1e4}) {
    const double c_d =
        reynolds < 1000.0 ? 24.0 / reynolds * (1.0 + 0.15 * std::pow(reynolds, 0.687)) : 0.44;
    const double slip = slip_at(1.0, reynolds);
    const double force = 0.5 * c_d * rho * slip * slip * pi / 4.0 * d * d;
    for (const PerSolidVolume law :
         {&ErgunWenYu::per_solid_volume, &ErgunRoweHenwood::per_solid_volume})
      EXPECT_NEAR(law(1.0, slip, d, rho, mu) * sphere_volume(d / 2.0) * slip / force, 1.0, rounding)
          << reynolds;
  }
}

TEST(ErgunWenYu, DiluteSuspensionsSettleByRichardsonAndZaki) {
  // Settling spheres have no net flux of volume: the superficial slip is the settling speed. The
  // gas carries the suspension's weight, so a sphere's drag is eps times its weight in gas.
  const double weight = 1.0;  // per volume of solid, of tiny spheres: no inertia
  const auto speed = [&](double n, double eps) {
    const double b = ErgunWenYu::with_exponent(n, eps, 0.0, d, rho, mu);
    return eps * (eps * weight / b);
  };
  for (const double n : {4.65, 4.7, 9.6})
    for (const double eps : {0.8, 0.9, 0.97})
      EXPECT_NEAR(speed(n, eps) / (speed(n, 1.0) * std::pow(eps, n)), 1.0, rounding)
          << n << " " << eps;
}

TEST(ErgunWenYu, HasTheTwoExponentsOfItsVariants) {
  const double eps = 0.9, slip = 0.5;
  EXPECT_EQ(ErgunWenYu::with_exponent(4.65, eps, slip, d, rho, mu),
            ErgunWenYu::per_solid_volume(eps, slip, d, rho, mu));
  EXPECT_NEAR(ErgunRoweHenwood::per_solid_volume(eps, slip, d, rho, mu) /
                  ErgunWenYu::per_solid_volume(eps, slip, d, rho, mu),
              std::pow(eps, -0.05), rounding);
  // The exponent is of the suspension only.
  EXPECT_EQ(ErgunWenYu::with_exponent(9.6, 0.5, slip, d, rho, mu),
            ErgunWenYu::per_solid_volume(0.5, slip, d, rho, mu));
}

TEST(ErgunWenYu, JumpsAsDocumentedWhereItsBranchesMeet) {
  struct {
    double reynolds, fall;
  } const rows[] = {{0.0, 0.13}, {100.0, 0.42}, {999.0, 0.73}};
  for (const auto& [reynolds, fall] : rows) {
    // Ergun at 0.8: (30 + 1.75 Re)/9.216; Wen and Yu: 0.8^-4.65 (1 + 0.15 Re^0.687).
    const double ergun = (30.0 + 1.75 * reynolds) / 9.216;
    const double wen_yu = std::pow(0.8, -4.65) * (1.0 + 0.15 * std::pow(reynolds, 0.687));
    const double below = scaled_drag(&ErgunWenYu::per_solid_volume, std::nextafter(0.8, 0.0),
                                     reynolds > 0.0 ? reynolds : 1e-30);
    const double at =
        scaled_drag(&ErgunWenYu::per_solid_volume, 0.8, reynolds > 0.0 ? reynolds : 1e-30);
    EXPECT_NEAR(at / below, wen_yu / ergun, rounding) << reynolds;
    EXPECT_NEAR(1.0 - at / below, fall, 0.005) << reynolds;  // the documented two digits
  }
}

}  // namespace cohesion::drag
