// SPDX-License-Identifier: BSD-3-Clause
#include "drag/beetstra.h"

#include <gtest/gtest.h>

#include "drag/ergun_wen_yu.h"
#include "drag/gas_and_sphere.h"
#include "drag/single_sphere.h"

namespace cohesion::drag {
namespace {

double without_inertia(double eps) {
  return Beetstra::per_solid_volume(eps, 0.0, d, rho, mu) * d * d / (18.0 * mu * eps);
}

}  // namespace

TEST(Beetstra, IsCarmanAndKozenyAndAFewPerCentInAPackedBed) {
  for (const double phi : {0.5, 0.6}) {
    const double eps = 1.0 - phi;
    const double carman_kozeny = 10.0 * phi / (eps * eps);  // of F_drag
    const double more = without_inertia(eps) / carman_kozeny - 1.0;
    EXPECT_NEAR(more, eps * eps * eps * eps * (1.0 + 1.5 * std::sqrt(phi)) / (10.0 * phi), 1e-14);
    if (phi == 0.6) {
      EXPECT_NEAR(more, 0.01, 0.005);  // the documented 1 %
    }
  }
}

TEST(Beetstra, LeavesASingleSphereWithTheSquareRootOfTheSolid) {
  // 1 + 1.5 sqrt(phi) + (10 - 2) phi + ..., what is left being -3 phi^1.5.
  for (const double phi : {1e-6, 1e-4}) {
    const double eps = 1.0 - phi;
    EXPECT_NEAR(without_inertia(eps), 1.0 + 1.5 * std::sqrt(phi) + 8.0 * phi,
                4.0 * phi * std::sqrt(phi) + 1e-15 / std::sqrt(phi));
  }
}

TEST(Beetstra, IsAboveASingleSphereWithInertiaAsDocumented) {
  struct {
    double reynolds, ratio;
  } const rows[] = {{100.0, 1.16}, {1000.0, 1.68}};
  for (const auto& [reynolds, ratio] : rows)
    EXPECT_NEAR(
        scaled_drag(&Beetstra::per_solid_volume, 1.0, reynolds) / schiller_naumann(reynolds), ratio,
        0.005)
        << reynolds;
}

TEST(Beetstra, IsCloseToErgunInAPackedBedWithInertia) {
  // Ergun's data scatter by some 25 %, and his constant is 150 for Carman and Kozeny's 180. F_total
  // taken for F_drag would make it 2.5 times as much.
  for (const double reynolds : {10.0, 100.0, 1000.0})
    EXPECT_NEAR(scaled_drag(&Beetstra::per_solid_volume, 0.4, reynolds) /
                    scaled_drag(&ErgunWenYu::per_solid_volume, 0.4, reynolds),
                1.0, 0.35)
        << reynolds;
}

}  // namespace cohesion::drag
