// SPDX-License-Identifier: BSD-3-Clause
// What holds for every closure of the table.
#include "drag/drag_closure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "drag/closure_values.h"
#include "drag/gas_and_sphere.h"
#include "named_table.h"

namespace cohesion::drag {

TEST(DragClosure, EachHasTheValuesOfAnIndependentEvaluation) {
  for (const Closure& closure : closures) {
    // Some forty roundings of 1.1e-16, those of a fitted denominator or numerator (Hill, Koch and
    // Ladd's 0.66 is a sum of terms of 2.2) magnified by 3.3. Syamlal and O'Brien's V_t is half of
    // A - 0.06 Re plus a root of nearly that size, at the largest Re some 0.06 Re/V_t = 400 times
    // V_t at a void fraction of 0.38 (V_t >= 0.2), and enters squared.
    const double tolerance =
        closure.name == SyamlalOBrien::name ? 2.0 * 3.0 * 400.0 * 1.1e-16 : 1e-14;
    int points = 0;
    for (const ClosureValue& at : closure_values) {
      if (at.closure != closure.name) continue;
      points++;
      EXPECT_NEAR(closure.per_solid_volume(at.void_fraction, at.slip, value_diameter, value_density,
                                           value_viscosity) /
                      at.value,
                  1.0, tolerance)
          << at.closure << " " << at.void_fraction << " " << at.slip;
    }
    EXPECT_EQ(points, 20) << closure.name << ": no row in closure_formulas.py";
  }
}

TEST(DragClosure, EachIsFiniteAndPositiveFromNoSlipOn) {
  for (const Closure& closure : closures)
    for (const double void_fraction : {0.2, 0.4, 0.6, 0.8, 1.0 - 1e-16, 1.0})
      for (const double slip : {0.0, 1e-300, 1e-30, 1e-3, 1e3}) {
        const double found = closure.per_solid_volume(void_fraction, slip, d, rho, mu);
        EXPECT_TRUE(std::isfinite(found) && found > 0.0)
            << closure.name << " " << void_fraction << " " << slip;
      }
}

TEST(DragClosure, EachTendsToStokesSingleSphere) {
  // 1, or Dalla Valle's 23.04/24. A division and the powers of 1: some ten roundings.
  const std::set<std::string_view> dalla_valles{SyamlalOBrien::name, DiFelice::name};
  for (const Closure& closure : closures) {
    const double found = closure.per_solid_volume(1.0, 0.0, d, rho, mu) * d * d / (18.0 * mu);
    EXPECT_NEAR(found, dalla_valles.count(closure.name) ? 0.96 : 1.0, 1e-15) << closure.name;
  }
}

TEST(DragClosure, EachForceRisesWithTheSlip) {
  for (const Closure& closure : closures)
    for (int percent = 36; percent <= 100; percent++)
      for (double slip = 1e-4; slip < 30.0; slip *= 1.1) {
        const auto force = [&](double s) {
          return s * closure.per_solid_volume(percent / 100.0, s, d, rho, mu);
        };
        EXPECT_GT(force(1.1 * slip), force(slip)) << closure.name << " " << percent << " " << slip;
      }
}

TEST(DragClosure, EachFallsWithTheVoidFraction) {
  for (const Closure& closure : closures)
    for (int percent = 36; percent < 100; percent++) {
      // Hill, Koch and Ladd's branches meet at a void fraction of 0.6 with a step up.
      if (closure.name == HillKochLadd::name && (percent == 59 || percent == 60)) continue;
      for (const double slip : {0.0, 1e-3, 0.1, 1.0, 10.0})
        EXPECT_GT(closure.per_solid_volume(percent / 100.0, slip, d, rho, mu),
                  closure.per_solid_volume((percent + 1) / 100.0, slip, d, rho, mu))
            << closure.name << " " << percent << " " << slip;
    }
}

// Steps so short that no slope explains more than `limit` between neighbours: what does is a jump.
TEST(DragClosure, TheseAreContinuous) {
  for (const PerSolidVolume law :
       {&DiFelice::per_solid_volume, &Beetstra::per_solid_volume, &Tenneti::per_solid_volume,
        &Tang::per_solid_volume, &WenYu::per_solid_volume})
    for (const double reynolds : {0.0, 1.0, 50.0, 999.9}) {
      // d ln F/d eps: of eps^-4.7 and of phi/eps^3 at most 13, of sqrt(phi) at most 24, of
      // 0.48 phi^(1/3) at most 16.
      const double step = 1e-5, limit = 40.0 * step;
      for (double eps = 0.36; eps < 0.999; eps += step)
        ASSERT_LT(
            std::abs(scaled_drag(law, eps + step, reynolds) / scaled_drag(law, eps, reynolds) -
                     1.0),
            limit)
            << eps << " " << reynolds;
    }
  for (const PerSolidVolume law : {&DiFelice::per_solid_volume, &Beetstra::per_solid_volume,
                                   &HillKochLadd::per_solid_volume, &Tang::per_solid_volume})
    for (const double eps : {0.4, 0.7, 1.0})
      // d ln F/d ln Re is at most 1, and Di Felice's exponent adds 0.4 ln(1/eps) per unit of ln Re.
      for (double reynolds = 1e-3; reynolds < 2e4; reynolds *= 1.0001)
        ASSERT_LT(
            std::abs(scaled_drag(law, eps, reynolds * 1.0001) / scaled_drag(law, eps, reynolds) -
                     1.0),
            2e-4)
            << eps << " " << reynolds;
}

TEST(DragClosure, EachValidityHoldsAFluidisedBed) {
  for (const Closure& closure : closures) {
    EXPECT_TRUE(closure.validity.contains(0.55, 50.0)) << closure.name;
    // Tenneti's simulations end at half of solid.
    EXPECT_EQ(closure.validity.contains(0.42, 50.0), closure.name != Tenneti::name) << closure.name;
    EXPECT_FALSE(closure.validity.contains(0.3, 50.0)) << closure.name;
    EXPECT_FALSE(closure.validity.contains(0.42, 1e5)) << closure.name;
  }
  EXPECT_TRUE((Validity{0.4, 0.9, 100.0}.contains(0.4, 100.0)));
  EXPECT_TRUE((Validity{0.4, 0.9, 100.0}.contains(0.9, 0.0)));
  EXPECT_FALSE((Validity{0.4, 0.9, 100.0}.contains(0.91, 100.0)));
}

TEST(DragClosure, EachSaysWhyItHasNoExponentOrHasOne) {
  for (const Closure& closure : closures)
    EXPECT_EQ(closure.with_exponent == nullptr, !closure.no_exponent.empty()) << closure.name;
}

}  // namespace cohesion::drag
