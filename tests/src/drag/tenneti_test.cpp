// SPDX-License-Identifier: BSD-3-Clause
#include "drag/tenneti.h"

#include <gtest/gtest.h>

#include "drag/beetstra.h"
#include "drag/gas_and_sphere.h"
#include "drag/single_sphere.h"

namespace cohesion::drag {
namespace {

double without_inertia(double eps) { return scaled_drag(&Tenneti::per_solid_volume, eps, 0.0); }

}  // namespace

TEST(Tenneti, HasTheValuesThatAHandFinds) {
  // phi = eps = 0.5, so that powers of both are powers of two:
  //   Re = 0:   1/2^-3 + 5.81 0.5/2^-3 + 0.48 0.5^(1/3)/2^-4
  //             = 8 + 23.24 + 7.68 * 0.793700526 = 37.335620 of F_total, half of it of F_drag;
  //   Re = 100: 0.15 100^0.687 = 0.15 * 23.6592 = 3.548880 more of the single sphere, which is 8
  //             times that, and 12.5 (0.95 + 0.61 * 0.5) = 15.6875: 81.41416 of F_total.
  EXPECT_NEAR(scaled_drag(&Tenneti::per_solid_volume, 0.5, 0.0), 37.335620 / 2.0, 1e-6);
  EXPECT_NEAR(scaled_drag(&Tenneti::per_solid_volume, 0.5, 100.0), 81.41416 / 2.0, 1e-4);
}

TEST(Tenneti, HasTheTabulatedValues) {
  // Three digits, of another evaluation of the formula than the header's.
  struct {
    double phi, reynolds, drag;
  } const rows[] = {{0.1, 0.01, 2.27},  {0.1, 100.0, 6.72},  {0.3, 0.01, 6.55},
                    {0.3, 10.0, 8.21},  {0.3, 100.0, 15.6},  {0.5, 0.01, 18.7},
                    {0.5, 100.0, 40.7}, {0.5, 500.0, 101.0}, {0.6, 0.01, 34.4}};
  for (const auto& [phi, reynolds, drag] : rows)
    EXPECT_NEAR(scaled_drag(&Tenneti::per_solid_volume, 1.0 - phi, reynolds) / drag, 1.0, 5e-3)
        << phi << " " << reynolds;
}

TEST(Tenneti, IsAFewPerCentBelowCarmanAndKozenyInADenseBed) {
  struct {
    double phi, below;
  } const rows[] = {{0.5, 0.07}, {0.6, 0.08}};
  for (const auto& [phi, below] : rows) {
    const double eps = 1.0 - phi, carman_kozeny = 10.0 * phi / (eps * eps);  // of F_drag
    EXPECT_NEAR(without_inertia(eps) / carman_kozeny, 1.0 - below, 0.005) << phi;
  }
}

TEST(Tenneti, IsASingleSphereOfSchillerAndNaumannWithoutOthers) {
  for (const double reynolds : {0.0, 1.0, 100.0, 300.0, 5000.0})
    EXPECT_NEAR(scaled_drag(&Tenneti::per_solid_volume, 1.0, reynolds) / schiller_naumann(reynolds),
                1.0, 1e-14)
        << reynolds;
}

TEST(Tenneti, LeavesTheSingleSphereWithTheCubeRootOfTheSolid) {
  // What is left over phi^(1/3) is 0.48, and (2 + 5.81) phi^(2/3) of 1/eps^2 and 5.81 phi; twice
  // the rounding of F over phi^(1/3).
  for (const double phi : {1e-9, 1e-6}) {
    const double root = std::cbrt(phi);
    EXPECT_NEAR((without_inertia(1.0 - phi) - 1.0) / root, 0.48, 8.0 * root * root + 4e-13 / root)
        << phi;
  }
}

TEST(Tenneti, IsBelowBeetstraWithInertiaAsDocumented) {
  // The documented 19 to 36 %, rounded at Re = 100 to 300.
  for (const double eps : {0.5, 0.6, 0.7, 0.8, 0.9})
    for (const double reynolds : {100.0, 200.0, 300.0}) {
      const double ratio = scaled_drag(&Tenneti::per_solid_volume, eps, reynolds) /
                           scaled_drag(&Beetstra::per_solid_volume, eps, reynolds);
      EXPECT_LT(ratio, 0.815) << eps << " " << reynolds;
      EXPECT_GT(ratio, 0.635) << eps << " " << reynolds;
    }
}

}  // namespace cohesion::drag
