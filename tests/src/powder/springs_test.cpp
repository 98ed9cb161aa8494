// SPDX-License-Identifier: BSD-3-Clause
#include "powder/springs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hamaker/small_gap.h"

namespace cohesion::powder {

namespace {

constexpr double d = 5e-4;
const double mass = 2500.0 * sphere_volume(0.5 * d);
const Elastic glass{63e9, 0.22};

GrainPair pair_of(double hamaker_constant) {
  const hamaker::HamakerParameters p{hamaker_constant, 4e-10, 1e-7};
  // F_ad = A R*/(6 H_cut^2) and the energy up to H_cut, both in closed form
  const double force = hamaker_constant * 0.25 * d / (6.0 * 4e-10 * 4e-10);
  const double tail = hamaker_constant * 0.25 * d / 6.0 * (1.0 / 4e-10 - 1.0 / 1e-7);
  return {d, mass, p, {force, 4e-10, tail}};
}

Demand demand(contact::Keep keep = contact::Keep::escape_velocity) {
  return {0.9, {0.4, 1000.0}, 0.01, keep, 0.0, glass};
}

}  // namespace

TEST(Springs, KeepWhatIsAsked) {
  const Springs velocity = springs_of(pair_of(6.5e-20), demand());
  const Springs force = springs_of(pair_of(6.5e-20), demand(contact::Keep::force));
  EXPECT_LT(velocity.used.stiffness, velocity.material.stiffness);
  EXPECT_NEAR(velocity.used.escape_velocity / velocity.material.escape_velocity, 1.0, 1e-9);
  EXPECT_NEAR(velocity.over.escape_velocity, 1.0, 1e-9);
  EXPECT_NEAR(force.used.pull_off, force.material.pull_off, 1e-24);
  EXPECT_GT(force.over.escape_velocity, 1.0);
}

TEST(Springs, BearTheLoadAndAreNoStifferThanTheMaterial) {
  Demand heavy = demand();
  heavy.load.pressure = 1e5;
  // p d^2 on a contact may press it by d/100.
  EXPECT_GE(springs_of(pair_of(0.0), heavy).used.stiffness, 1e5 * d / 0.01);
  heavy.load.pressure = 1e12;
  const Springs rigid = springs_of(pair_of(0.0), heavy);
  EXPECT_EQ(rigid.used.stiffness, rigid.material.stiffness);
  EXPECT_EQ(rigid.over.force, 1.0);
}

// Large grains hardly stick, and only the slowest: an impact presses Hertz's contact far into where
// it is stiffer. F(x) = c x^(3/2), 2/5 c x^(5/2) = mu v^2/2, K x^2 = mu v^2.
TEST(Springs, BearImpactsThatTheMaterialBears) {
  Demand fast = demand();
  fast.elastic.young = 1e9;
  fast.load = {7.0, 0.0};
  const Springs s = springs_of(pair_of(1e-19), fast);
  const double mu = 0.5 * mass, modulus = 1e9 / (2.0 * (1.0 - 0.22 * 0.22));
  const double c = 4.0 / 3.0 * modulus * std::sqrt(0.25 * d);
  const double x = std::pow(2.5 * 0.5 * mu * 49.0 / c, 0.4);
  ASSERT_GT(x, 0.01 * d);  // the material is pressed more than by the share that is asked for
  EXPECT_NEAR(s.used.stiffness / (mu * 49.0 / (x * x)), 1.0, 1e-3);
  EXPECT_GT(s.used.stiffness, s.material.stiffness);
  EXPECT_EQ(s.used.pull_off, s.material.pull_off);
  EXPECT_LT(s.over.escape_velocity, 1.0);
  EXPECT_EQ(s.over.force, 1.0);
}

// Twice the mass and twice the adhesion, as at a wall.
TEST(Springs, BearWhatPressesThemMoreThanThePair) {
  Demand walled = demand();
  walled.load = {0.4, 0.0};
  const double pair_alone = springs_of(pair_of(0.0), walled).used.stiffness;
  walled.others = {{{d, mass}, {}}};
  // Two digits of up to a tenth more, both
  EXPECT_NEAR(springs_of(pair_of(0.0), walled).used.stiffness / pair_alone, 2.0, 0.2);
}

TEST(Springs, GivenAloneAreTheMaterial) {
  Demand given = demand();
  given.given = 800.0;
  given.elastic.young = 0.0;
  const Springs s = springs_of(pair_of(6.5e-20), given);
  EXPECT_EQ(s.material.stiffness, 800.0);
  EXPECT_EQ(s.used.stiffness, 800.0);
}

// A well has the escape velocity whatever the spring is, and no force.
TEST(Springs, WithAWellKeepTheEscapeVelocityWhereverTheyAreSoft) {
  Demand well = demand();
  well.well_ratio = 1.01;
  for (const double given : {0.0, 10.0, 1e4}) {
    well.given = given;
    const Springs s = springs_of(pair_of(6.5e-20), well);
    EXPECT_NEAR(s.over.escape_velocity, 1.0, 1e-12);
    EXPECT_NEAR(s.used.escape_velocity / s.material.escape_velocity, 1.0, 1e-12);
    EXPECT_EQ(s.over.force, 0.0);
    EXPECT_GT(s.material.pull_off, 0.0);
  }
}

// mu (v^2 + 2 D/mu) = K x^2 at the largest overlap x of an impact without loss, x = 0.01 d; loss
// makes it less, and two digits of at most a tenth more make the spring stiffer.
TEST(Springs, WithAWellBearWhatItAddsToImpacts) {
  Demand well = demand();
  well.well_ratio = 1.01;
  well.load = {1e-3, 0.0};  // slow: most is the well's
  const Springs s = springs_of(pair_of(6.5e-20), well);
  const double e = well.restitution, mu = 0.5 * mass, v = s.used.escape_velocity;
  const double squared = 1e-6 + v * v / (1.0 / (e * e) - 1.0);  // 2 D/mu of the escape velocity
  const double lossless = mu * squared / (1e-4 * d * d);
  EXPECT_LT(s.used.stiffness, 1.1 * lossless);
  // From the overlap with loss: no less than e of that without.
  EXPECT_GT(s.used.stiffness, e * e * lossless);
}

TEST(Springs, RefuseAWellWithinTheGrains) {
  Demand well = demand();
  well.well_ratio = 0.9;
  EXPECT_THROW(springs_of(pair_of(6.5e-20), well), InvalidParameter);
}

// The attraction can be scaled to the least stiffness, and to a tenth and a bit less it cannot.
TEST(Springs, LeaveTheAttractionRoom) {
  const hamaker::HamakerParameters p{1e-19, 4e-10, 4e-9};
  const double least = least_scaled_stiffness(1e4, p);
  EXPECT_NO_THROW(contact::StiffnessScaling(1e4, least).hamaker(p));
  EXPECT_THROW(contact::StiffnessScaling(1e4, least / 1.11).hamaker(p), InvalidParameter);
}

}  // namespace cohesion::powder
