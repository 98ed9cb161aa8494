// SPDX-License-Identifier: BSD-3-Clause
#include "advice/advised_step.h"

#include <gtest/gtest.h>

#include "advice/elastic_pair.h"
#include "constants.h"

namespace cohesion::advice {
namespace {

constexpr double radius = 0.5e-3, mass = 2650.0 * 4.0 / 3.0 * pi * radius * radius * radius;
constexpr double speed = 0.1;

/// Whether the engines accept a step, where spheres have several contacts and the fastest one has
/// `fastest`.
bool is_accepted(const AdvisedContact& contact, double fastest, double step) {
  const ContactNumbers n = numbers(contact, {fastest, 0.0, step, 0.0, Crowd::several});
  return !detail::steadiness(n, true, detail::steady_step(n, false));
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
          EXPECT_FALSE(is_accepted(contact, 2.0 * speed, 1.02 * step))
              << e << " " << friction << " " << energy;
        } else {
          EXPECT_EQ(step, usual);
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
  EXPECT_LT(step, 0.99 * usual);
  EXPECT_GT(step, 0.9 * usual);
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
        EXPECT_TRUE(is_accepted(contact, 2.0 * speed, step))
            << e << " " << friction << " " << force;
        EXPECT_FALSE(is_accepted(contact, 2.0 * speed, 1.02 * step))
            << e << " " << friction << " " << force;
      }
}

}  // namespace
}  // namespace cohesion::advice
