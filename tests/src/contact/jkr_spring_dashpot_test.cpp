// SPDX-License-Identifier: BSD-3-Clause
#include "contact/jkr_spring_dashpot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/hertz_spring_dashpot.h"

namespace cohesion::contact {
namespace {

constexpr double modulus = 5e7, radius = 2.5e-4, work = 0.1, mass = 7e-7;
const auto hertz = HertzSpringDashpot::from_restitution(modulus, radius, 0.9, mass);
const JkrSpringDashpot law(hertz, radius, work);

/// From the radius of contact a.
double overlap(double a) { return a * a / radius - std::sqrt(2.0 * pi * work * a / modulus); }
double force(double a) {
  return 4.0 * modulus * a * a * a / (3.0 * radius) -
         std::sqrt(8.0 * pi * work * modulus) * std::pow(a, 1.5);
}
const double radius_at_tearing = std::cbrt(pi * work * radius * radius / (8.0 * modulus));

}  // namespace

TEST(JkrSpringDashpot, ForceIsThatOfTheRadiusOfContact) {
  const double pull_off = 1.5 * pi * work * radius;
  for (double times = 1.0001; times < 1e4; times *= 1.1) {
    const double a = times * radius_at_tearing;
    EXPECT_NEAR(law.at(overlap(a)).force, force(a), 1e-10 * std::abs(force(a)) + 1e-8 * pull_off)
        << times;
    EXPECT_NEAR(law.at(overlap(a)).radius_stiffness, 2.0 * modulus * a, 1e-8 * 2.0 * modulus * a);
  }
  EXPECT_NEAR(law.lowest_overlap(), overlap(radius_at_tearing), 1e-12 * -law.lowest_overlap());
}

TEST(JkrSpringDashpot, PullsOffAtThreeHalvesOfPiWR) {
  double largest = 0.0;
  for (int k = 0; k <= 100000; k++)
    largest = std::max(largest, -law.at(law.lowest_overlap() * k / 100000.0).force);
  EXPECT_NEAR(largest, 1.5 * pi * work * radius, 1e-8 * largest);
}

TEST(JkrSpringDashpot, EnergyIsTheWorkOfTheForce) {
  const double step = 1e-10;
  for (const double x : {-0.9 * -law.lowest_overlap(), -1e-7, 0.0, 1e-7, 1e-6}) {
    const double slope = (law.at(x + step).energy - law.at(x - step).energy) / (2.0 * step);
    EXPECT_NEAR(slope, law.at(x).force, 1e-4 * std::abs(law.at(x).force) + 1e-9) << x;
    const double steeper = (law.at(x + step).force - law.at(x - step).force) / (2.0 * step);
    EXPECT_NEAR(steeper, law.at(x).stiffness, 1e-3 * std::abs(steeper)) << x;
    const double damped =
        (law.at(x + step).damping_integral - law.at(x - step).damping_integral) / (2.0 * step);
    EXPECT_NEAR(damped, law.at(x).damping, 1e-3 * damped) << x;
  }
}

TEST(JkrSpringDashpot, PartingTakesTheWorkOfThornton) {
  // Of an elastic impact: from touch, where it began, to where they tear.
  const double lost = law.at(law.lowest_overlap()).energy - law.touch_energy();
  EXPECT_NEAR(lost,
              7.0922 * std::cbrt(std::pow(work, 5.0) * std::pow(radius, 4.0) / modulus / modulus),
              1e-5 * lost);
}

TEST(JkrSpringDashpot, WithoutAdhesionItIsHertz) {
  const JkrSpringDashpot weak(hertz, radius, 1e-14);
  const auto hertz = HertzSpringDashpot::from_restitution(modulus, radius, 0.9, mass);
  for (const double x : {1e-7, 1e-6}) {
    EXPECT_NEAR(weak.at(x).force, hertz.at(x).force, 1e-6 * hertz.at(x).force);
    EXPECT_NEAR(weak.at(x).stiffness, hertz.at(x).stiffness, 1e-6 * hertz.at(x).stiffness);
    EXPECT_NEAR(weak.at(x).damping, hertz.at(x).damping, 1e-6 * hertz.at(x).damping);
  }
}

TEST(JkrSpringDashpot, WithAWorkOfAdhesionOfZeroItIsHertzFromTouchOn) {
  for (const JkrSpringDashpot& none :
       {JkrSpringDashpot(hertz, radius, 0.0), law.with_work_of_adhesion(0.0)}) {
    EXPECT_EQ(none.lowest_overlap(), 0.0);
    EXPECT_EQ(none.touch_energy(), 0.0);
    EXPECT_EQ(none.friction_load(), 0.0);
    for (const double x : {0.0, 1e-300, 1e-20, 1e-7, 1e-6}) {
      const LawPoint a = none.at(x), b = hertz.at(x);
      EXPECT_NEAR(a.force, b.force, 1e-13 * b.force) << x;
      EXPECT_NEAR(a.stiffness, b.stiffness, 1e-13 * b.stiffness) << x;
      EXPECT_NEAR(a.energy, b.energy, 1e-13 * b.energy) << x;
      EXPECT_NEAR(a.damping, b.damping, 1e-13 * b.damping) << x;
      EXPECT_NEAR(a.damping_integral, b.damping_integral, 1e-13 * b.damping_integral) << x;
      EXPECT_NEAR(a.radius_stiffness, b.radius_stiffness, 1e-13 * b.radius_stiffness) << x;
    }
    EXPECT_EQ(none.at(-1e-20).force, 0.0);
  }
  EXPECT_THROW(JkrSpringDashpot(hertz, radius, -1e-3), InvalidParameter);
}

}  // namespace cohesion::contact
