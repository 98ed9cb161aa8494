// SPDX-License-Identifier: BSD-3-Clause
// What holds for every closure of the table. Values: closures_test.py.
#include "drag/drag_closure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string_view>

#include "drag/gas_and_sphere.h"

namespace cohesion::drag {

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
  for (const Closure& closure : closures) {
    const double found = closure.per_solid_volume(1.0, 0.0, d, rho, mu) * d * d / (18.0 * mu);
    EXPECT_NEAR(found, found < 0.98 ? 0.96 : 1.0, 1e-15) << closure.name;
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

// Jumps of these are stated in their headers: along the void fraction and along Re.
const std::set<std::string_view> jump_along_eps{ErgunWenYu::name, ErgunRoweHenwood::name,
                                                HillKochLadd::name, SyamlalOBrien::name};
const std::set<std::string_view> jump_along_reynolds{ErgunWenYu::name, ErgunRoweHenwood::name,
                                                     Tenneti::name, WenYu::name};

// Steps so short that no slope explains more than `limit` between neighbours: what does is a jump.
TEST(DragClosure, EachIsContinuousUnlessStated) {
  for (const Closure& closure : closures) {
    const PerSolidVolume law = closure.per_solid_volume;
    if (!jump_along_eps.count(closure.name))
      for (const double reynolds : {0.0, 1.0, 50.0, 999.9}) {
        // d ln F/d eps: of eps^-4.7 and of phi/eps^3 at most 13, of sqrt(phi) at most 24, of
        // 0.48 phi^(1/3) at most 16.
        const double step = 1e-5, limit = 40.0 * step;
        for (double eps = 0.36; eps < 0.999; eps += step)
          ASSERT_LT(
              std::abs(scaled_drag(law, eps + step, reynolds) / scaled_drag(law, eps, reynolds) -
                       1.0),
              limit)
              << closure.name << " " << eps << " " << reynolds;
      }
    if (jump_along_reynolds.count(closure.name)) continue;
    for (const double eps : {0.4, 0.7, 1.0})
      // d ln F/d ln Re is at most 1, and Di Felice's exponent adds 0.4 ln(1/eps) per unit of ln Re.
      for (double reynolds = 1e-3; reynolds < 2e4; reynolds *= 1.0001)
        ASSERT_LT(
            std::abs(scaled_drag(law, eps, reynolds * 1.0001) / scaled_drag(law, eps, reynolds) -
                     1.0),
            2e-4)
            << closure.name << " " << eps << " " << reynolds;
  }
}

TEST(DragClosure, EachValidityHoldsAFluidisedBed) {
  for (const Closure& closure : closures) {
    EXPECT_TRUE(closure.validity.contains(0.55, 50.0)) << closure.name;
    EXPECT_FALSE(closure.validity.contains(0.3, 50.0)) << closure.name;
    EXPECT_FALSE(closure.validity.contains(0.55, 1e5)) << closure.name;
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
