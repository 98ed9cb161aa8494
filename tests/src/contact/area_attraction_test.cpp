// SPDX-License-Identifier: BSD-3-Clause
#include "contact/area_attraction.h"

#include <algorithm>
#include <cmath>

#include "advice/integrated_escape.h"
#include "refuses.h"

namespace cohesion::contact {
namespace {

constexpr double modulus = 1e7, radius = 2.5e-4, mass = 1e-6;

HertzSpringDashpot hertz(double restitution) {
  return HertzSpringDashpot::from_restitution(modulus, radius, restitution, mass);
}
HertzWithAreaAttraction contact_of(double density, double restitution = 0.9) {
  return {hertz(restitution), attraction_slope(density, ContactArea::circle, radius)};
}

TEST(AreaAttraction, PullOffIsTheLargestNetAttraction) {
  for (const double density : {1e4, 2e5}) {
    const HertzWithAreaAttraction law = contact_of(density);
    double largest = 0.0, where = 0.0;
    for (int k = 1; k <= 200000; k++) {
      const double x = 3e-5 * k * law.overlap_at_pull_off();
      const double net = 2.0 * pi * radius * density * x -
                         4.0 / 3.0 * modulus * std::sqrt(radius) * x * std::sqrt(x);
      if (net > largest) largest = net, where = x;
    }
    EXPECT_NEAR(law.pull_off_force() / largest, 1.0, 1e-9);
    EXPECT_NEAR(law.overlap_at_pull_off() / where, 1.0, 1e-4);
  }
}

TEST(AreaAttraction, PullOffByHand) {
  // 2/3 pi^3 R*^2 k^3/E*^2 = 20.6708511 * 6.25e-8 * 8e15/1e14
  EXPECT_NEAR(contact_of(2e5).pull_off_force(), 1.03354256e-4, 1e-12);
}

TEST(AreaAttraction, SlopeIsThatOfTheCircleInWhichSpheresIntersect) {
  const double r_i = 1e-3, r_j = 4e-4, x = 1e-9, r = r_i + r_j - x;
  const double area =
      -0.25 * pi * (r - r_i - r_j) * (r + r_i - r_j) * (r - r_i + r_j) * (r + r_i + r_j) / (r * r);
  const double reduced = r_i * r_j / (r_i + r_j);
  EXPECT_NEAR(attraction_slope(3.0, ContactArea::circle, reduced) * x / (3.0 * area), 1.0, 1e-5);
  EXPECT_EQ(attraction_slope(3.0, ContactArea::doubled, reduced),
            2.0 * attraction_slope(3.0, ContactArea::circle, reduced));
}

TEST(AreaAttraction, ForceIsTheDerivativeOfTheEnergy) {
  const HertzWithAreaAttraction law = contact_of(2e5);
  const double x = law.overlap_at_pull_off(), h = 1e-4 * x;
  EXPECT_NEAR((law.at(x + h).energy - law.at(x - h).energy) / (2.0 * h) / law.at(x).force, 1.0,
              1e-7);
  EXPECT_NEAR((law.at(x + h).force - law.at(x - h).force) / (2.0 * h), 0.0,
              1e-4 * law.pull_off_force() / x);
  const double rest = law.resting_overlap();
  EXPECT_NEAR(law.at(rest).force, 0.0, 1e-12 * law.pull_off_force());
  EXPECT_NEAR(-law.at(rest).energy / law.well_energy(), 1.0, 1e-12);
}

TEST(AreaAttraction, EnergyDensityOfAPullOffForceIsTheInverse) {
  for (const ContactArea area : {ContactArea::circle, ContactArea::doubled}) {
    const HertzWithAreaAttraction law{hertz(0.9), attraction_slope(7e4, area, radius)};
    EXPECT_NEAR(energy_density_of_pull_off(law.pull_off_force(), law.hertz(), area, radius) / 7e4,
                1.0, 1e-13);
  }
}

/// The speed at which a pair parts that touches at `speed`, 0: never. Runge and Kutta's scheme.
double parts_at(double slope, const HertzSpringDashpot& spring, double speed) {
  const double step = 1e-3 * std::sqrt(mass / slope);
  const auto a = [&](double x, double v) {
    const LawPoint p = spring.at(std::max(x, 0.0));
    return (slope * std::max(x, 0.0) - p.force - p.damping * v) / mass;
  };
  double x = 0.0, v = speed;
  for (int k = 0; k < 30000; k++) {
    const double v1 = v, a1 = a(x, v);
    const double v2 = v + 0.5 * step * a1, a2 = a(x + 0.5 * step * v1, v2);
    const double v3 = v + 0.5 * step * a2, a3 = a(x + 0.5 * step * v2, v3);
    const double v4 = v + step * a3, a4 = a(x + step * v3, v4);
    x += step / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
    v += step / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    if (x <= 0.0) return -v;
  }
  return 0.0;
}

TEST(AreaAttraction, EscapeVelocityIsThatOfAnIntegration) {
  for (const double restitution : {0.5, 0.9}) {
    const HertzWithAreaAttraction law = contact_of(1e5, restitution);
    const double slope = attraction_slope(1e5, ContactArea::circle, radius);
    const double speed = advice::escape_velocity(law);
    EXPECT_EQ(parts_at(slope, law.hertz(), 0.999 * speed), 0.0);
    EXPECT_GT(parts_at(slope, law.hertz(), 1.001 * speed), 0.0);
  }
}

TEST(AreaAttraction, NothingSticksWithoutLossOrAttraction) {
  EXPECT_EQ(advice::escape_velocity(contact_of(1e5, 1.0)), 0.0);
  EXPECT_EQ(advice::escape_velocity(contact_of(0.0)), 0.0);
}

TEST(AreaAttraction, RefusesANegativeDensity) {
  EXPECT_THROW(attraction_slope(-1.0, ContactArea::circle, radius), InvalidParameter);
}

}  // namespace
}  // namespace cohesion::contact
