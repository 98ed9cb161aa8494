// SPDX-License-Identifier: BSD-3-Clause
#include "drag/wen_yu.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drag/ergun_wen_yu.h"
#include "drag/gas_and_sphere.h"
#include "drag/single_sphere.h"

namespace cohesion::drag {
namespace {

double wen_yu(double eps, double reynolds) {
  return scaled_drag(&WenYu::per_solid_volume, eps, reynolds);
}

}  // namespace

TEST(WenYu, HasTheValuesThatAHandFinds) {
  // F_drag = eps F_total. eps = 0.5: 2^3.65 = 12.5533456; Re = 100: 1 + 0.15 * 23.6591970
  // = 4.5488795
  EXPECT_NEAR(wen_yu(0.5, 0.0), 12.5533456, 1e-6);
  EXPECT_NEAR(wen_yu(0.5, 100.0), 12.5533456 * 4.5488795, 1e-4);
}

TEST(WenYu, IsThatOfErgunAndWenYuInASuspension) {
  for (const double eps : {0.8, 0.9, 1.0})
    for (const double slip : {0.0, 0.1, 10.0})
      for (const double n : {4.65, 9.6})
        EXPECT_EQ(WenYu::with_exponent(n, eps, slip, d, rho, mu),
                  ErgunWenYu::with_exponent(n, eps, slip, d, rho, mu))
            << eps << " " << slip << " " << n;
}

TEST(WenYu, LetsASuspensionSettleAsRichardsonAndZakiSay) {
  // Without inertia F_total = eps^-n U/u_t, the weight at U = eps^n u_t. Some rounding of a power.
  for (const double n : {4.65, 9.6})
    for (const double eps : {0.4, 0.55, 0.9})
      EXPECT_NEAR(WenYu::scaled_total(n, eps, 0.0) * std::pow(eps, n), 1.0, 1e-14);
}

TEST(WenYu, IsBelowErgunInAPackedBedAsDocumented) {
  // 0.4^-4.65 = 70.86 against 150 0.6/(18 0.4^3) = 78.125: 0.907
  EXPECT_NEAR(wen_yu(0.4, 0.0) / scaled_drag(&ErgunWenYu::per_solid_volume, 0.4, 0.0), 0.907,
              0.001);
}

}  // namespace cohesion::drag
