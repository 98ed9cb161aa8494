// SPDX-License-Identifier: BSD-3-Clause
#include "drag/tang.h"

#include <gtest/gtest.h>

#include "drag/beetstra.h"
#include "drag/gas_and_sphere.h"
#include "drag/single_sphere.h"

namespace cohesion::drag {
namespace {

double tang(double eps, double reynolds) {
  return scaled_drag(&Tang::per_solid_volume, eps, reynolds);
}

}  // namespace

TEST(Tang, HasTheValuesThatAHandFinds) {
  // phi = eps = 0.5, so that powers of both are powers of two:
  //   Re = 0:   10 0.5/0.25 + 0.25 (1 + 1.5 * 0.70710678) = 20 + 0.51516504;
  //   Re = 100: 0.11 0.5 1.5 - 0.00456 * 16 = 0.00954 for each unit of Re, and
  //             0.169 0.5 + 0.0644 * 16 = 1.1149 times 100^0.657 = 20.60630.
  EXPECT_NEAR(tang(0.5, 0.0), 20.51516504, 1e-7);
  EXPECT_NEAR(tang(0.5, 100.0), 20.51516504 + 0.954 + 1.1149 * 20.60630, 1e-4);
}

TEST(Tang, HasTheTabulatedValues) {
  // Three digits, of another evaluation of the formula than the header's.
  struct {
    double phi, reynolds, drag;
  } const rows[] = {{0.1, 0.01, 2.44},  {0.1, 100.0, 8.10}, {0.3, 0.01, 7.03},
                    {0.3, 10.0, 9.01},  {0.3, 100.0, 17.4}, {0.5, 0.01, 20.6},
                    {0.5, 100.0, 44.4}, {0.5, 500.0, 91.4}, {0.6, 0.01, 38.0}};
  for (const auto& [phi, reynolds, drag] : rows)
    EXPECT_NEAR(tang(1.0 - phi, reynolds) / drag, 1.0, 5e-3) << phi << " " << reynolds;
}

TEST(Tang, IsBeetstraWithoutInertia) {
  for (const double eps : {0.36, 0.5, 0.8, 1.0})
    EXPECT_NEAR(tang(eps, 0.0) / scaled_drag(&Beetstra::per_solid_volume, eps, 0.0), 1.0, 1e-15)
        << eps;
}

TEST(Tang, IsNearASingleSphereWithInertiaAsDocumented) {
  struct {
    double reynolds, ratio;
  } const rows[] = {{100.0, 1.18}, {1000.0, 1.00}};
  for (const auto& [reynolds, ratio] : rows)
    EXPECT_NEAR(tang(1.0, reynolds) / schiller_naumann(reynolds), ratio, 0.005) << reynolds;
}

TEST(Tang, KeepsItsDragCoefficientAboveItsData) {
  for (const double eps : {0.36, 0.6, 1.0})
    for (const double times : {1.5, 10.0, 1e3})
      EXPECT_NEAR(tang(eps, times * 1000.0) / (times * tang(eps, 1000.0)), 1.0, 1e-14)
          << eps << " " << times;
}

}  // namespace cohesion::drag
