// SPDX-License-Identifier: BSD-3-Clause
#include "advice/power_law_spring.h"

#include <gtest/gtest.h>

#include "contact/linear_spring_dashpot.h"
#include "refuses.h"

namespace cohesion::advice {
namespace {

constexpr double mass = 7e-7, speed = 0.1;

/// Of Hertz's contact of 1 mm spheres with Y* = 2.7e6 Pa, told at 1e-7 m.
ContactSprings hertz(double damping = 0.0) {
  const double c = 4.0 / 3.0 * 2.7e6 * std::sqrt(0.25e-3);
  ContactSprings s{c * std::sqrt(1e-7), damping};
  s.tangential_stiffness = 0.8 * s.stiffness;
  s.rolling_stiffness = 0.3 * s.stiffness;
  s.exponent = 1.5;
  s.overlap = 1e-7;
  return s;
}

struct Impact {
  double largest_overlap, restitution, time;
};

/// By integration with the midpoint rule; `steps` to the largest overlap or so. Force (A) on top.
Impact integrate(const ContactSprings& s, double attraction, double u, int steps) {
  const double c = s.stiffness * std::pow(s.overlap, 1.0 - s.exponent);
  const auto rate = [&](double x, double v) {
    const double eta = s.damping * std::pow(x / s.overlap, 0.5 * (s.exponent - 1.0));
    return (attraction - c * std::pow(x, s.exponent) - eta * v) / mass;
  };
  const double dt = largest_overlap(s, mass, attraction, u) / u / steps;
  double x = 0.0, v = u, time = 0.0, most = 0.0;
  while (true) {
    // Midpoint rule, second order with the dashpot, too.
    const double middle_x = x + 0.5 * dt * v, middle_v = v + 0.5 * dt * rate(x, v);
    const double next = x + dt * middle_v;
    if (next <= 0.0 || time > 100.0 * steps * dt) return {most, -v / u, time + dt * x / (x - next)};
    v += dt * rate(std::max(middle_x, 0.0), middle_v);
    x = next;
    time += dt;
    most = std::max(most, x);
  }
}

}  // namespace

TEST(PowerLawSpring, LinearSpringIsItself) {
  const ContactSprings s{800.0, 0.8e-3, 300.0, 100.0};
  const ContactSprings same = linear_springs(s, mass, 1e-6, speed);
  EXPECT_EQ(same.stiffness, 800.0);
  EXPECT_EQ(same.damping, 0.8e-3);
  EXPECT_EQ(same.tangential_stiffness, 300.0);
  EXPECT_EQ(same.rolling_stiffness, 100.0);
}

TEST(PowerLawSpring, LargestOverlapOfHertzIsThatOfItsEnergy) {
  const ContactSprings s = hertz();
  const double c = s.stiffness / std::sqrt(s.overlap);
  // 2/5 c x^(5/2) = m u^2/2; a power of a few roundings.
  const double x = std::pow(1.25 * mass * speed * speed / c, 0.4);
  EXPECT_NEAR(largest_overlap(s, mass, 0.0, speed), x, 1e-14 * x);
  const double pulled = largest_overlap(s, mass, 3e-4, speed);
  EXPECT_NEAR(0.4 * c * std::pow(pulled, 2.5), 3e-4 * pulled + 0.5 * mass * speed * speed,
              1e-14 * mass * speed * speed);
  EXPECT_EQ(largest_overlap(s, mass, 0.0, 0.0), 0.0);
}

TEST(PowerLawSpring, EquivalentIsPressedAsFarAndBouncesAsHigh) {
  const ContactSprings s = hertz(2e-3);
  const ContactSprings linear = linear_springs(s, mass, 0.0, speed);
  const contact::LinearSpringDashpot spring(linear.stiffness, linear.damping, mass);
  const Impact impact = integrate(s, 0.0, speed, 4000);
  ASSERT_GT(impact.restitution, 0.3);
  ASSERT_LT(impact.restitution, 0.8);
  // The midpoint rule errs by (1/4000)^2, the force at exit by a step: sqrt(1/4000)^3 = 4e-6.
  EXPECT_NEAR(spring.restitution(), impact.restitution, 2e-5);
  // At any speed the same.
  const ContactSprings slow = linear_springs(s, mass, 0.0, 0.01 * speed);
  EXPECT_NEAR(contact::LinearSpringDashpot(slow.stiffness, slow.damping, mass).restitution(),
              spring.restitution(), 1e-12);
  // Without dashpot the largest overlap, of which (dt/t)^2 = 6e-8 is lost between steps.
  const ContactSprings elastic = linear_springs(hertz(), mass, 3e-4, speed);
  const Impact pressed = integrate(hertz(), 3e-4, speed, 4000);
  const double w0 = std::sqrt(elastic.stiffness / mass);
  const double b = 3e-4 / elastic.stiffness;
  EXPECT_NEAR(b + std::hypot(b, speed / w0), pressed.largest_overlap,
              1e-6 * pressed.largest_overlap);
}

TEST(PowerLawSpring, ContactOfHertzTakesSevenPercentLess) {
  const ContactSprings linear = linear_springs(hertz(), mass, 0.0, speed);
  const double taken = integrate(hertz(), 0.0, speed, 4000).time;
  const double of_linear = contact::LinearSpringDashpot(linear.stiffness, 0.0, mass).contact_time();
  // pi over 2.9432, Hertz's number.
  EXPECT_NEAR(of_linear / taken, 3.14159265 / 2.9432, 1e-3);
}

TEST(PowerLawSpring, OtherSpringsGrowAlike) {
  const ContactSprings linear = linear_springs(hertz(), mass, 0.0, speed);
  // K is 2/(p+1) = 0.8 of F/x there.
  EXPECT_NEAR(linear.tangential_stiffness / linear.stiffness, 0.8 / 0.8, 1e-14);
  EXPECT_NEAR(linear.rolling_stiffness / linear.stiffness, 0.3 / 0.8, 1e-14);
}

TEST(PowerLawSpring, AtRestItIsAsItWasTold) {
  const ContactSprings linear = linear_springs(hertz(1e-4), mass, 0.0, 0.0);
  EXPECT_EQ(linear.overlap, 1e-7);
  EXPECT_NEAR(linear.stiffness, 0.8 * hertz().stiffness, 1e-14 * hertz().stiffness);
}

TEST(PowerLawSpring, RefusesWhatHasNoSpring) {
  ContactSprings s = hertz();
  s.stiffness = 0.0;
  expect_refused([&] { linear_springs(s, mass, 0.0, speed); }, "stiffness K");
  expect_refused([&] { linear_springs(hertz(), 0.0, 0.0, speed); }, "reduced mass");
  s = hertz();
  s.overlap = 0.0;
  expect_refused([&] { linear_springs(s, mass, 0.0, speed); }, "overlap");
}

}  // namespace cohesion::advice
