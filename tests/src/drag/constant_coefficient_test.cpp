// SPDX-License-Identifier: BSD-3-Clause
#include "drag/constant_coefficient.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drag/drag_law.h"
#include "named_table.h"
#include "refuses.h"
#include "sphere.h"

namespace cohesion::drag {
namespace {

const Closure& named(const char* name) { return find_by_name(all_closures, "drag", name); }

constexpr double emulsion = 400.0, viscosity = 1.0, g = 9.81;

}  // namespace

TEST(ConstantCd, IsTheForceOfItsCoefficientOnASphereAlone) {
  const DragLaw law(named("constantCd"), 1.0, std::nullopt, 0.44);
  const double d = 0.03, slip = 0.7;
  const double force = 0.44 * 0.5 * emulsion * pi / 4.0 * d * d * slip * slip;
  EXPECT_NEAR(law.coefficient(1.0, slip, d, emulsion, viscosity) * slip / force, 1.0, 1e-15);
}

TEST(ConstantCd, GoesWithTheSlip) {
  const DragLaw law(named("constantCd"), 1.0, std::nullopt, 0.44);
  EXPECT_EQ(law.coefficient(0.8, 0.0, 0.03, emulsion, viscosity), 0.0);
  EXPECT_NEAR(law.coefficient(0.8, 3.0, 0.03, emulsion, viscosity) /
                  law.coefficient(0.8, 1.0, 0.03, emulsion, viscosity),
              3.0, 1e-15);
}

TEST(DavidsonTaylor, BubblesRiseByDavidsonAndTaylor) {
  // 0.711 sqrt(g d): 0.199, 0.398, 0.630 m/s; of any density.
  const DragLaw law(named("davidsonTaylor"));
  struct {
    double d, rise;
  } const rows[] = {{0.008, 0.199}, {0.032, 0.398}, {0.080, 0.630}};
  for (const auto& [d, rise] : rows) {
    EXPECT_NEAR(0.711 * std::sqrt(g * d), rise, 5e-4);
    const double v = 0.711 * std::sqrt(g * d);
    for (const double bubble : {0.4, 25.0, 200.0}) {
      const double drag =
          law.of_densities(bubble, emulsion) * law.coefficient(1.0, v, d, emulsion, viscosity) * v;
      const double lift = (emulsion - bubble) * g * sphere_volume(d / 2.0);
      EXPECT_NEAR(drag / lift, 1.0, 5e-15) << d << " " << bubble;
    }
  }
}

TEST(DavidsonTaylor, HasTheCoefficientThatIsQuoted) {
  EXPECT_NEAR(DavidsonTaylor::coefficient, 2.64, 0.005);
}

TEST(DavidsonTaylor, SwarmsRiseAgainstTheirVolumeFlowAsOneBubbleDoes) {
  // Steady: F_drag/eps = (rho_e - rho_b) V g; eps |u - v| is then 0.711 sqrt(g d).
  const DragLaw law(named("davidsonTaylor"));
  const double d = 0.05, v = 0.711 * std::sqrt(g * d);
  for (const double eps : {0.5, 0.7, 0.9}) {
    const double slip = v / eps;
    EXPECT_NEAR(law.coefficient(eps, slip, d, emulsion, viscosity) * slip / eps /
                    (emulsion * g * sphere_volume(d / 2.0)),
                1.0, 5e-15)
        << eps;
  }
}

TEST(DavidsonTaylor, RefusesSpheresThatDoNotRise) {
  const DragLaw law(named("davidsonTaylor"));
  expect_refused([&] { law.of_densities(400.0, 400.0); }, "lighter than the fluid");
  EXPECT_EQ(DragLaw(named("diFelice")).of_densities(2000.0, 1.0), 1.0);
}

TEST(ConstantCd, AsksForItsCoefficientAndOthersRefuseIt) {
  expect_refused([&] { DragLaw{named("constantCd")}; }, "needs it, the C_d of a sphere");
  expect_refused([&] { DragLaw(named("constantCd"), 1.0, std::nullopt, -1.0); },
                 "dragCoefficient = -1");
  for (const Closure& closure : all_closures)
    if (!closure.takes_coefficient)
      expect_refused([&] { DragLaw(closure, 1.0, std::nullopt, 0.44); }, "take drag constantCd");
}

TEST(ConstantCd, IsNoClosureOfBedsAndIsKnownToCoupledCases) {
  EXPECT_EQ(all_closures.size(), closures.size() + coefficient_closures.size());
  for (const Closure& closure : closures) EXPECT_FALSE(closure.quadratic) << closure.name;
  for (const Closure& closure : coefficient_closures) {
    EXPECT_TRUE(closure.quadratic) << closure.name;
    EXPECT_EQ(named(std::string(closure.name).c_str()).per_solid_volume, closure.per_solid_volume);
    EXPECT_TRUE(closure.validity.contains(1.0 + 1e-15, 1e9)) << closure.name;
    EXPECT_FALSE(closure.no_exponent.empty()) << closure.name;
  }
}

}  // namespace cohesion::drag
