// SPDX-License-Identifier: BSD-3-Clause
#include "advice/softness.h"

#include <gtest/gtest.h>

#include "advice/thesis_pair.h"

namespace cohesion::advice {
namespace {

contact::AdhesiveContact contact_of(const PairParameters& p) { return ContactNumbers(p).contact(); }

/// At `ratio` times the stiffness, same restitution.
PairParameters stiffer(PairParameters p, double ratio) {
  p.stiffness *= ratio;
  p.damping *= std::sqrt(ratio);
  return p;
}

bool decides(const PairParameters& p) { return softness_decides(ContactNumbers(p)); }

/// sqrt(2 W/mu (1/e^2 - 1)): below it pairs stick with a spring of any stiffness.
double rigid_escape(const PairParameters& p) {
  const contact::LinearSpringDashpot spring = contact_of(p).spring();
  const double e = spring.restitution();
  return std::sqrt(2.0 * p.adhesion.well_energy() / spring.reduced_mass() * (1.0 / e / e - 1.0));
}

}  // namespace

TEST(OverMaterial, ScaledAdhesionKeepsTheEscapeVelocityAndLosesForceAsTheRootOfStiffness) {
  PairParameters soft = thesis_pair();
  const auto real = contact_of(stiffer(soft, 1e4));
  soft.adhesion = contact::StiffnessScaling(real.spring().stiffness(), soft.stiffness)
                      .adhesion(real.adhesion());
  const OverMaterial over =
      over_material(contact_of(soft), {1e4 * soft.stiffness, contact::Keep::escape_velocity});
  // Exact but for roundings, as StiffnessScaling.
  EXPECT_NEAR(over.escape_velocity, 1.0, 1e-12);
  EXPECT_NEAR(over.force, 0.01, 1e-14);
  EXPECT_NEAR(contact_of(soft).escape_velocity() / real.escape_velocity(), 1.0, 1e-12);
}

TEST(OverMaterial, AdhesionLeftAsItIsKeepsTheForceAndSticksMore) {
  const PairParameters soft = thesis_pair();
  const OverMaterial over =
      over_material(contact_of(soft), {1e4 * soft.stiffness, contact::Keep::force});
  const double real = contact_of(stiffer(soft, 1e4)).escape_velocity();
  EXPECT_NEAR(over.escape_velocity, contact_of(soft).escape_velocity() / real, 1e-12);
  EXPECT_GT(over.escape_velocity, 2.0);
  EXPECT_EQ(over.force, 1.0);
}

TEST(OverMaterial, PairsThatAllPartOrAllStickDoSoInBoth) {
  PairParameters elastic = thesis_pair();
  elastic.damping = 0.0;
  PairParameters overdamped = thesis_pair();
  overdamped.damping *= 1e3;
  for (const PairParameters& p : {elastic, overdamped})
    EXPECT_EQ(
        over_material(contact_of(p), {1e4 * p.stiffness, contact::Keep::force}).escape_velocity,
        1.0);
}

TEST(Softness, DecidesWhereAdhesionWorksMoreInTheSpringThanOnTheWayToIt) {
  PairParameters p = thesis_pair();
  p.speed = 0.01;
  EXPECT_TRUE(decides(p));
  // F_ad^2/(2K) = W at K = 800 N/m * 1.0596e-11/1.0396e-13 = 8.15e4 N/m.
  p.stiffness = 8.1e4;
  EXPECT_TRUE(decides(p));
  p.stiffness = 8.2e4;
  EXPECT_FALSE(decides(p));
}

TEST(Softness, IsOfNoConsequenceWhereAllStickWithARigidSpring) {
  PairParameters p = thesis_pair();
  p.speed = 0.51 * rigid_escape(p);
  EXPECT_TRUE(decides(p));
  p.speed = 0.49 * rigid_escape(p);
  EXPECT_FALSE(decides(p));
}

TEST(Softness, IsOfNoConsequenceWhereHardlyAnImpactIsSlowEnough) {
  PairParameters p = thesis_pair();
  const double escape = contact_of(p).escape_velocity();
  p.speed = 99.0 * escape;
  EXPECT_TRUE(decides(p));
  p.speed = 101.0 * escape;
  EXPECT_FALSE(decides(p));
}

TEST(Softness, IsOfNoConsequenceWithoutAttractionDashpotOrRestitution) {
  PairParameters p = thesis_pair();
  p.adhesion = {};
  EXPECT_FALSE(decides(p));
  p = thesis_pair();
  p.damping = 0.0;
  EXPECT_FALSE(decides(p));
  p.damping = 1e3;
  EXPECT_FALSE(decides(p));
}

TEST(Softness, OfAPairAtRestIsNotKnownToBeOfNoConsequence) {
  PairParameters p = thesis_pair();
  p.speed = 0.0;
  EXPECT_TRUE(decides(p));
}

TEST(Softness, AdviceNamesWordsThatThereAre) {
  EXPECT_NE(softness_advice("'words'").find("'words' keeps"), std::string::npos);
  EXPECT_EQ(softness_advice("").find("material_keep"), std::string::npos);
  for (const char* words : {"'words'", ""}) {
    const std::string advice = softness_advice(words);
    EXPECT_NE(advice.find("collisions"), std::string::npos);
    EXPECT_NE(advice.find("packings"), std::string::npos);
  }
}

}  // namespace cohesion::advice
