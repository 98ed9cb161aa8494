// SPDX-License-Identifier: BSD-3-Clause
#include "advice/elastic_pair.h"

#include "constants.h"
#include "refuses.h"
#include "sphere.h"

namespace cohesion::advice {
namespace {

// Two spheres of 1 mm and 2650 kg/m3.
constexpr double radius = 5e-4, reduced = 0.5 * radius, young = 1e9, nu = 0.25;
const double mass = 2650.0 * sphere_volume(radius), mu = 0.5 * mass;

contact::ContactParameters contact_of(double restitution, double w = 0.0) {
  contact::ContactParameters p;
  contact::set_hertz(p, young, nu);
  p.restitution = restitution;
  p.work_of_adhesion = w;
  return p;
}

ElasticPair jkr(double restitution, double w = 0.1) {
  return {contact_of(restitution, w), reduced, mu};
}

/// F_ad of DMT at this w, with its energy over H_cut.
ElasticPair dmt(double restitution, double w) {
  const double force = 2.0 * pi * w * reduced;
  return {contact_of(restitution), reduced, mu, {force, 4e-10, 4e-10 * force}};
}

}  // namespace

TEST(ElasticPair, PullOffForcesAreThoseOfJkrAndDmt) {
  EXPECT_DOUBLE_EQ(jkr(0.9).pull_off_force(), 1.5 * pi * 0.1 * reduced);
  EXPECT_DOUBLE_EQ(dmt(0.9, 0.1).pull_off_force(), 2.0 * pi * 0.1 * reduced);
  EXPECT_EQ(ElasticPair(contact_of(0.9), reduced, mu).pull_off_force(), 0.0);
}

// Thornton and Ning (1998), eq. 29, for a sphere and a wall: 1.84 ((w/R)^5/(rho^3 E*^2))^(1/6), and
// the work of the neck, 7.09 (w^5 R*^4/E*^2)^(1/3), for any pair. Three digits are theirs.
TEST(ElasticPair, ElasticSpheresStickUpToTheSpeedOfThorntonAndNing) {
  const double w = 0.1, modulus = contact_of(1.0).modulus;
  const ElasticPair wall(contact_of(1.0, w), radius, mass);
  const double thornton =
      1.84 *
      std::pow(std::pow(w / radius, 5) / (std::pow(2650.0, 3) * modulus * modulus), 1.0 / 6.0);
  EXPECT_NEAR(wall.escape_velocity() / thornton, 1.0, 3e-3);
  const double work = 7.0922 * std::cbrt(std::pow(w, 5) * std::pow(reduced, 4) / modulus / modulus);
  // Bisected to 1e-5, of impacts in steps of t_c/1000.
  EXPECT_NEAR(jkr(1.0).escape_velocity() / std::sqrt(2.0 * work / mu), 1.0, 1e-4);
}

TEST(ElasticPair, ElasticSpheresInDmtNeverStick) {
  EXPECT_EQ(dmt(1.0, 0.1).escape_velocity(), 0.0);
  EXPECT_GT(dmt(0.9, 0.1).escape_velocity(), 0.0);
}

// 2.87 (mu^2/(R* E*^2 v))^(1/5), Johnson, eq. 11.24, three digits; 2.9432 x_max/v.
TEST(ElasticPair, ContactTimeAndOverlapAreHertzs) {
  const ElasticPair hertz(contact_of(0.9), reduced, mu);
  const double v = 0.1, modulus = contact_of(0.9).modulus;
  EXPECT_NEAR(
      hertz.contact_time(v) / (2.87 * std::pow(mu * mu / (reduced * modulus * modulus * v), 0.2)),
      1.0, 2e-3);
  const double overlap = std::pow(15.0 * mu * v * v / (16.0 * modulus * std::sqrt(reduced)), 0.4);
  EXPECT_NEAR(hertz.largest_overlap(v) / overlap, 1.0, 1e-12);
  EXPECT_NEAR(hertz.contact_time(v) / (2.94 * overlap / v), 1.0, 2e-3);
}

// What a stuck pair oscillates with about its rest, t = pi sqrt(mu/F'), is no shorter than that of
// the slowest impact but for the 7 % by which Hertz's impact is shorter than a linear spring's.
TEST(ElasticPair, TheContactTimeOfASlowImpactIsThatOfAStuckPair) {
  for (const ElasticPair& pair : {jkr(0.9, 1.0), dmt(0.9, 1.0)}) {
    const double x = pair.overlap_under(0.0);
    const double load = 1e-3 * pair.pull_off_force();
    const double slope = load / (pair.overlap_under(load) - x);
    EXPECT_LT(0.9 * pair.contact_time(1e-9), pi * std::sqrt(mu / slope));
    EXPECT_GT(2.0 * pair.contact_time(1e-9), pi * std::sqrt(mu / slope));
  }
}

TEST(ElasticPair, RestsWhereSpringAndAdhesionBalance) {
  const double w = 0.1, k = 4.0 / 3.0 * contact_of(0.9).modulus * std::sqrt(reduced);
  const double force = 2.0 * pi * w * reduced;
  EXPECT_NEAR(dmt(0.9, w).overlap_under(force) / std::pow(2.0 * force / k, 2.0 / 3.0), 1.0, 1e-12);
  // JKR's rests where F = 0: a^(3/2) = (3/4) R* sqrt(8 pi w/E*); its root is found to 1e-8.
  const double a =
      std::pow(0.75 * reduced * std::sqrt(8.0 * pi * w / contact_of(0.9).modulus), 2.0 / 3.0);
  EXPECT_NEAR(jkr(0.9, w).overlap_under(0.0) /
                  (a * a / reduced - std::sqrt(2.0 * pi * w * a / contact_of(0.9).modulus)),
              1.0, 1e-6);
}

TEST(ElasticPair, AttractionMakesTheImpactOfAPairFasterAndDeeper) {
  const ElasticPair with = dmt(0.9, 0.1), without(contact_of(0.9), reduced, mu);
  EXPECT_GT(with.largest_overlap(1e-3), without.largest_overlap(1e-3));
  EXPECT_LT(with.contact_time(1e-4), without.contact_time(1e-4));
}

TEST(ElasticPair, SoftenedKeepsEscapeVelocityOrForce) {
  const double f = std::pow(1e-2, 0.4);
  for (const ElasticPair& real : {jkr(0.9), dmt(0.9, 0.1)}) {
    const double modulus = 1e-2 * real.contact().modulus;
    const ElasticPair velocity = real.softened(modulus, contact::Keep::escape_velocity);
    EXPECT_NEAR(velocity.escape_velocity() / real.escape_velocity(), 1.0, 1e-3);
    EXPECT_NEAR(velocity.pull_off_force() / real.pull_off_force() / f, 1.0, 1e-14);
    const ElasticPair force = real.softened(modulus, contact::Keep::force);
    EXPECT_EQ(force.pull_off_force(), real.pull_off_force());
    EXPECT_GT(force.escape_velocity(), 2.0 * real.escape_velocity());
  }
}

TEST(ElasticPair, RefusesLinearSpringsAndTwoAdhesions) {
  contact::ContactParameters linear;
  linear.stiffness = 800.0;
  expect_refused([&] { ElasticPair(linear, reduced, mu); }, "reduced modulus");
  expect_refused([&] { ElasticPair(contact_of(0.9, 0.1), reduced, mu, {1e-6, 4e-10, 0.0}); },
                 "not added to JKR's contact");
  expect_refused([&] { ElasticPair(contact_of(0.9), -1.0, mu); }, "reduced radius");
}

TEST(ElasticPair, TaborsParameter) {
  // (1e-4 * 0.01/(1e20 * 8e-30))^(1/3)
  EXPECT_NEAR(tabor_parameter(1e10, 1e-4, 0.1, 2e-10) / std::cbrt(1250.0), 1.0, 1e-12);
}

}  // namespace cohesion::advice
