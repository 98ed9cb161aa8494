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
/// Of the largest stable step; planned_steady_step() leaves a hundredth to the rounding of scripts.
constexpr double planned = 0.99;
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

/// Whether the engines accept a step, where spheres have several contacts and the fastest one has
/// `fastest`.
bool is_accepted(const AdvisedContact& contact, double fastest, double step) {
  const ContactNumbers n = numbers(contact, {fastest, 0.0, step, 0.0, Crowd::several});
  return detail::steadiness(n, true, detail::steady_step(n, false)).severity == Severity::ok;
}

TEST(AdvisedStep, OfHertzAndJkrIsAcceptedAtTwiceTheSpeedAndNoShorterThanItMustBe) {
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
        EXPECT_TRUE(is_accepted(contact, 2.0 * speed, step))
            << e << " " << friction << " " << energy;
        EXPECT_LE(step, pair.largest_step(speed));
        if (step < usual) {
          EXPECT_FALSE(is_accepted(contact, 2.0 * speed, step / planned * (1.0 + rounding)))
              << e << " " << friction << " " << energy;
          EXPECT_TRUE(is_accepted(contact, 2.0 * speed, step / planned * (1.0 - rounding)));
        } else {
          EXPECT_EQ(step, usual);
        }
        if (energy == 0.0) {
          EXPECT_NEAR(step / std::min(usual, planned * stable_step(p, 2.0 * speed)), 1.0, rounding);
        }
      }
}

TEST(AdvisedStep, OfHertzWithFrictionIsShorterThanATwentiethWithADashpotOfLiggghts) {
  contact::ContactParameters p;
  contact::set_hertz(p, 5e6, 0.3);
  p.restitution = 0.5;
  const double usual = ElasticPair(p, 0.5 * radius, 0.5 * mass).advised_step(speed);
  p.friction = 0.5;
  const double step = ElasticPair(p, 0.5 * radius, 0.5 * mass).advised_step(speed);
  EXPECT_LT(step, usual);
  EXPECT_NEAR(step / (planned * stable_step(p, 2.0 * speed)), 1.0, rounding);
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
        const double step = planned_steady_step(contact, speed);
        EXPECT_TRUE(is_accepted(contact, 2.0 * speed, step / planned * (1.0 - rounding)))
            << e << " " << friction << " " << force;
        EXPECT_FALSE(is_accepted(contact, 2.0 * speed, step / planned * (1.0 + rounding)))
            << e << " " << friction << " " << force;
      }
}

}  // namespace
}  // namespace cohesion::advice
