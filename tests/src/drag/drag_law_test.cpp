// SPDX-License-Identifier: BSD-3-Clause
#include "drag/drag_law.h"

#include <cmath>
#include <limits>

#include "drag/gas_and_sphere.h"
#include "named_table.h"
#include "refuses.h"

namespace cohesion::drag {
namespace {

const Closure& named(const char* name) { return find_by_name(closures, "drag", name); }

double at(const DragLaw& law, double eps, double slip) {
  return law.per_solid_volume(eps, slip, d, rho, mu);
}

}  // namespace

TEST(DragLaw, IsTheClosureTimesTheFactor) {
  for (const Closure& closure : closures) {
    const double plain = closure.per_solid_volume(0.7, 0.3, d, rho, mu);
    EXPECT_EQ(at(DragLaw(closure), 0.7, 0.3), plain) << closure.name;
    EXPECT_EQ(at(DragLaw(closure, 0.25), 0.7, 0.3), 0.25 * plain) << closure.name;
  }
}

TEST(DragLaw, CoefficientIsThatOfTheVolumeOfASphere) {
  // b |u - v| on one sphere is beta/(1 - eps) times its volume, pi d^3/6.
  const DragLaw law(named("beetstra"), 0.5);
  EXPECT_NEAR(law.coefficient(0.6, 0.2, d, rho, mu) / (pi / 6.0 * d * d * d * at(law, 0.6, 0.2)),
              1.0, 1e-15);
}

TEST(DragLaw, TakesTheExponentOfTheSuspension) {
  for (const char* name : {"ergunWenYu", "ergunRoweHenwood"}) {
    const double own = name == std::string("ergunWenYu") ? 4.65 : 4.7;
    // pow of 0.9 with exponents up to 9.6, a few roundings.
    EXPECT_NEAR(at(DragLaw(named(name), 1.0, 9.6), 0.9, 0.3) / at(DragLaw(named(name)), 0.9, 0.3),
                std::pow(0.9, own - 9.6), 1e-14)
        << name;
  }
}

TEST(DragLaw, RefusesAFactorThatIsNotPositive) {
  for (const double factor : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    expect_refused([&] { DragLaw(named("diFelice"), factor); }, "dragFactor = ");
}

TEST(DragLaw, RefusesAnExponentThatIsNotPositive) {
  for (const double exponent : {0.0, -4.65, std::numeric_limits<double>::quiet_NaN()})
    expect_refused([&] { DragLaw(named("ergunWenYu"), 1.0, exponent); }, "dragExponent = ");
}

TEST(DragLaw, RefusesAnExponentWhereThereIsNoneAndSaysWhy) {
  for (const Closure& closure : closures) {
    if (closure.with_exponent) continue;
    const std::string who = "drag '" + std::string(closure.name) + "' has no exponent to choose";
    expect_refused([&] { DragLaw(closure, 1.0, 4.65); }, who);
    expect_refused([&] { DragLaw(closure, 1.0, 4.65); }, std::string(closure.no_exponent));
    expect_refused([&] { DragLaw(closure, 1.0, 4.65); }, "take one of ergunWenYu, ");
  }
}

}  // namespace cohesion::drag
