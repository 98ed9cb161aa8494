// SPDX-License-Identifier: BSD-3-Clause
#include "drag/hill_koch_ladd.h"

#include <gtest/gtest.h>

#include "drag/gas_and_sphere.h"
#include "drag/single_sphere.h"

namespace cohesion::drag {

TEST(HillKochLadd, HasTheExpansionOfDiluteFixedArrays) {
  // S. Kim, W. B. Russel, J. Fluid Mech. 154 (1985) 269:
  //   F_total = 1 + 3/sqrt(2) sqrt(phi) + 135/64 phi ln phi + 16.456 phi + ...
  // What is left per phi is 17.14 - 0.681 = 16.459, to the next order: -0.681 (3/sqrt(2)) sqrt(phi)
  // and 8.48 phi, with logarithms of the third; the rounding of F over phi.
  for (const double phi : {1e-8, 1e-7, 1e-6}) {
    const double known =
        1.0 + 3.0 / std::sqrt(2.0) * std::sqrt(phi) + 135.0 / 64.0 * phi * std::log(phi);
    const double left = (HillKochLadd::without_inertia(phi) - known) / phi;
    EXPECT_NEAR(left, 16.456, 0.003 + 1.5 * std::sqrt(phi) + 1e-15 / phi) << phi;
  }
}

TEST(HillKochLadd, BecomesCarmanAndKozenyInAPackedBed) {
  for (const double phi : {0.4, 0.5, 0.64}) {
    // n F_total = 180 phi^2 mu U/(eps^3 d^2), n = 6 phi/(pi d^3), over 3 pi mu d U.
    const double eps = 1.0 - phi;
    const double gradient = 180.0 * phi * phi * mu / (eps * eps * eps * d * d);
    const double expected = gradient * pi * d * d * d / (6.0 * phi) / (3.0 * pi * mu * d);
    EXPECT_NEAR(HillKochLadd::without_inertia(phi) / expected, 1.0, 1e-14) << phi;
    // The force on a sphere, of which the drag is the part eps; 0.3 Re/2 of inertia at Re = 1e-14.
    EXPECT_NEAR(scaled_drag(&HillKochLadd::per_solid_volume, eps, 1e-14) / (eps * expected), 1.0,
                1e-14)
        << phi;
  }
}

TEST(HillKochLadd, GrowsLinearlyWithTheReynoldsNumberOfTheRadius) {
  // F_3 at phi = 0.2: 0.0673 + 0.0424 + 0.0232/0.32768 = 0.180500...
  const double eps = 0.8, slope = 0.0673 + 0.212 * 0.2 + 0.0232 / std::pow(0.8, 5);
  const auto total = [&](double re) {
    return scaled_drag(&HillKochLadd::per_solid_volume, eps, re) / eps;
  };
  EXPECT_NEAR((total(200.0) - total(100.0)) / 50.0, slope, 1e-13);  // 22 rounded, over 50
}

TEST(HillKochLadd, StepsAsDocumentedWhereItsBranchesMeet) {
  const double below = HillKochLadd::without_inertia(std::nextafter(0.4, 0.0));
  EXPECT_NEAR(HillKochLadd::without_inertia(0.4) / below, 1.0 - 0.038, 5e-4);
}

TEST(HillKochLadd, IsAboveASingleSphereWithInertiaAsDocumented) {
  EXPECT_NEAR(scaled_drag(&HillKochLadd::per_solid_volume, 1.0, 100.0) / schiller_naumann(100.0),
              1.21, 0.005);
}

}  // namespace cohesion::drag
