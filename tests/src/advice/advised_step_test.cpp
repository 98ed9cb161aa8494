// SPDX-License-Identifier: BSD-3-Clause
#include "advice/advised_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "advice/elastic_pair.h"
#include "constants.h"

namespace cohesion::advice {
namespace {

constexpr double radius = 0.5e-3, mass = 2650.0 * 4.0 / 3.0 * pi * radius * radius * radius;
constexpr double speed = 0.1;
/// Of the largest stable step; planned_steady_step() leaves a thousandth to the rounding of printed
/// numbers.
constexpr double planned = 0.999;
/// Steps are bisected to the last bits, 1e-15 of them.
constexpr double rounding = 1e-9;

/// The largest step with 4 s < 4 and 40/7 s_t < 4 (docs/theory/contact_steps.md), where
/// s = (K + 2 eta/dt) dt^2/mu, and s_t the same with 2/7 mu: of Hertz's contact at the largest
/// overlap of an impact with `fastest`, with K = 2 E* a, eta = 2 sqrt(5/6) beta sqrt(K mu),
/// K_t = c K, and of LIGGGHTS eta_t = sqrt(c) eta.
double stable_step(const contact::ContactParameters& p, double fastest) {
  const double mu = 0.5 * mass, r = 0.5 * radius, c = p.friction > 0.0 ? p.tangential_ratio : 0.0;
  const double overlap =
      std::pow(15.0 * mu * fastest * fastest / (16.0 * p.modulus * std::sqrt(r)), 0.4);
  const double stiffness = 2.0 * p.modulus * std::sqrt(r * overlap);
  const double beta = -std::log(p.restitution) / std::hypot(pi, std::log(p.restitution));
  const double damping = 2.0 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(stiffness * mu);
  // The end of k dt^2 + 2 eta dt < bound.
  const auto end = [](double k, double eta, double bound) {
    return (std::sqrt(eta * eta + k * bound) - eta) / k;
  };
  const double normal = end(stiffness, damping, mu);
  if (c == 0.0) return normal;
  return std::min(normal, end(c * stiffness, std::sqrt(c) * damping, 0.2 * mu));
}

/// What the engines report on a step, where spheres have several contacts and the fastest one has
/// `fastest`.
Report report_of(const AdvisedContact& contact, double fastest, double step, double gravity = 0.0) {
  return report("test", exact_scheme, {contact}, {fastest, gravity, step, 0.0, Crowd::several});
}
bool is_accepted(const AdvisedContact& contact, double fastest, double step, double gravity = 0.0) {
  return report_of(contact, fastest, step, gravity).stop.empty();
}
bool has_few_steps(const Report& report) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [](const Warning& w) { return w.subject == Subject::contact_steps; });
}

/// Probability that a sphere of a Maxwellian gas is faster than `v` standard deviations of a
/// component of the velocity.
double probability_above(double v) {
  return std::erfc(v / std::sqrt(2.0)) + std::sqrt(2.0 / pi) * v * std::exp(-0.5 * v * v);
}

TEST(FastestOverImpact, IsTheMedianOf2e5SpheresOfAMaxwellianGas) {
  const double median = fastest_over_impact * std::sqrt(pi);
  const auto none_is_faster = [&](double over) {
    return std::exp(2e5 * std::log1p(-probability_above(over * median)));
  };
  // The factor is rounded to a tenth.
  EXPECT_LT(none_is_faster(1.0 - 0.05 / fastest_over_impact), 0.5);
  EXPECT_GT(none_is_faster(1.0 + 0.05 / fastest_over_impact), 0.5);
}

TEST(AdvisedStep, OfHertzAndJkrIsAcceptedAtTheFastestSpeedAndNoShorterThanItMustBe) {
  for (const double e : {0.3, 0.5, 0.9})
    for (const double friction : {0.0, 0.5})
      for (const double energy : {0.0, 0.02}) {
        contact::ContactParameters p;
        contact::set_hertz(p, 5e6, 0.3);
        p.restitution = e;
        p.friction = friction;
        if (energy > 0.0) contact::set_surface_energy(p, energy);
        const ElasticPair pair(p, 0.5 * radius, 0.5 * mass);
        contact::Adhesion own{};
        own.force = pair.pull_off_force();
        const AdvisedContact contact = contact_of_equals(p, radius, mass, own);
        const double step = pair.advised_step(speed), usual = pair.contact_time(speed) / 20.0;
        EXPECT_TRUE(is_accepted(contact, fastest_over_impact * speed, step))
            << e << " " << friction << " " << energy;
        EXPECT_LE(step, pair.largest_step(speed));
        if (step < usual) {
          EXPECT_FALSE(
              is_accepted(contact, fastest_over_impact * speed, step / planned * (1.0 + rounding)))
              << e << " " << friction << " " << energy;
          EXPECT_TRUE(
              is_accepted(contact, fastest_over_impact * speed, step / planned * (1.0 - rounding)));
        } else {
          EXPECT_EQ(step, usual);
        }
        if (energy == 0.0) {
          EXPECT_NEAR(step / std::min(usual, planned * stable_step(p, fastest_over_impact * speed)),
                      1.0, rounding);
        }
      }
}

TEST(LargestStep, HasNoWarningAtTheFastestSpeed) {
  for (const double e : {0.3, 0.9})
    for (const double own_speed : {0.001, speed}) {
      contact::ContactParameters p;
      contact::set_hertz(p, 5e6, 0.3);
      p.restitution = e;
      const double gravity = 9.81;
      const AdvisedContact contact = contact_of_equals(p, radius, mass, {});
      const ElasticPair pair(p, 0.5 * radius, 0.5 * mass);
      const double largest = pair.largest_step(own_speed, gravity);
      const double fastest = fastest_over_impact * own_speed;
      EXPECT_FALSE(has_few_steps(report_of(contact, fastest, largest, gravity))) << e;
      EXPECT_TRUE(has_few_steps(report_of(contact, fastest,
                                          (1.0 + 2.0 * printed_rounding) * largest, gravity)) ||
                  !is_accepted(contact, fastest, (1.0 + 2.0 * printed_rounding) * largest, gravity))
          << e;
      EXPECT_LE(pair.advised_step(own_speed, gravity), largest);
    }
}

TEST(AdvisedStep, OfSlowImpactsIsThatOfAFallByOneDiameter) {
  contact::ContactParameters p;
  contact::set_hertz(p, 5e6, 0.3);
  p.restitution = 0.5;
  p.friction = 0.5;
  constexpr double slow = 0.01, gravity = 9.81;
  const double fall = std::sqrt(2.0 * gravity * 2.0 * radius);
  const ElasticPair pair(p, 0.5 * radius, 0.5 * mass);
  const AdvisedContact contact = contact_of_equals(p, radius, mass, {});
  const double step = pair.advised_step(slow, gravity);
  EXPECT_TRUE(is_accepted(contact, fastest_over_impact * slow, step, gravity));
  EXPECT_FALSE(is_accepted(contact, fastest_over_impact * slow, 1.02 * step, gravity));
  EXPECT_FALSE(is_accepted(contact, 0.0, pair.advised_step(slow), gravity));
  EXPECT_DOUBLE_EQ(step, pair.advised_step(fall / fastest_over_impact));
}

TEST(AdvisedStep, OfHertzWithFrictionIsShorterThanATwentiethWithADashpotOfLiggghts) {
  contact::ContactParameters p;
  contact::set_hertz(p, 5e6, 0.3);
  p.restitution = 0.5;
  const double usual = ElasticPair(p, 0.5 * radius, 0.5 * mass).advised_step(speed);
  p.friction = 0.5;
  const double step = ElasticPair(p, 0.5 * radius, 0.5 * mass).advised_step(speed);
  EXPECT_LT(step, usual);
  EXPECT_NEAR(step / (planned * stable_step(p, fastest_over_impact * speed)), 1.0, rounding);
}

TEST(PlannedSteadyStep, OfLinearSpringsIsAccepted) {
  for (const double e : {0.3, 0.5, 0.9})
    for (const double friction : {0.0, 0.5})
      for (const double force : {0.0, 1e-6}) {
        contact::ContactParameters p;
        p.stiffness = 800.0;
        p.restitution = e;
        p.friction = friction;
        contact::Adhesion adhesion{};
        adhesion.force = force;
        const AdvisedContact contact = contact_of_equals(p, radius, mass, adhesion);
        const double step = planned_steady_step(contact, speed, 0.0);
        EXPECT_TRUE(
            is_accepted(contact, fastest_over_impact * speed, step / planned * (1.0 - rounding)))
            << e << " " << friction << " " << force;
        EXPECT_FALSE(
            is_accepted(contact, fastest_over_impact * speed, step / planned * (1.0 + rounding)))
            << e << " " << friction << " " << force;
      }
}

}  // namespace
}  // namespace cohesion::advice
