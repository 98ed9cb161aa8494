// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_parameters.h"

#include <gtest/gtest.h>

#include <limits>

#include "refuses.h"

namespace cohesion::contact {
namespace {

ContactParameters valid() {
  ContactParameters p;
  p.stiffness = 800.0;
  p.restitution = 0.9;
  return p;
}

}  // namespace

TEST(ContactParameters, RestitutionGivesTheDampingOfThePairsMass) {
  for (const double mass : {1e-9, 7e-7, 3.0}) {
    const LinearSpringDashpot law = normal_contact(valid(), mass);
    EXPECT_NEAR(law.restitution(), 0.9, 1e-14);  // a handful of roundings
    EXPECT_EQ(law.stiffness(), 800.0);
    EXPECT_EQ(law.reduced_mass(), mass);
  }
}

TEST(ContactParameters, UnlikeMaterialsHaveGeometricMeans) {
  ContactParameters a = valid(), b = valid();
  b.stiffness = 4.0 * a.stiffness;
  b.restitution = 0.4;
  b.friction = 0.3;
  ContactParameters m = mixed(a, b);
  EXPECT_DOUBLE_EQ(m.stiffness, 1600.0);
  EXPECT_DOUBLE_EQ(m.restitution, 0.6);
  EXPECT_EQ(m.friction, 0.0);  // of a smooth and a rough one
  EXPECT_DOUBLE_EQ(mixed(b, b).friction, 0.3);
  a.damping = 2.0;
  EXPECT_LT(mixed(a, b).damping, 0.0) << "only one of them gives a damping: restitution stands";
  b.damping = 8.0;
  EXPECT_DOUBLE_EQ(mixed(a, b).damping, 4.0);
}

TEST(ContactParameters, DampingTakesThePlaceOfRestitution) {
  ContactParameters p = valid();
  for (const double damping : {0.0, 0.79e-3}) {
    p.damping = damping;
    EXPECT_EQ(normal_contact(p, 7e-7).damping(), damping);
  }
  p.damping = 0.0;
  EXPECT_EQ(normal_contact(p, 7e-7).restitution(), 1.0);
}

TEST(ContactParameters, TangentialContactIsInProportionToTheNormalOne) {
  ContactParameters p = valid();
  p.friction = 0.3;
  p.tangential_ratio = 0.25;
  p.tangential_damping_ratio = 2.0;
  const LinearSpringDashpot normal = normal_contact(p, 7e-7);
  const TangentialParameters t = tangential_contact(p, normal);
  EXPECT_EQ(t.stiffness, 200.0);
  EXPECT_EQ(t.damping, 2.0 * normal.damping());
  EXPECT_EQ(t.friction, 0.3);
}

TEST(ContactParameters, RefusesWhatCannotBe) {
  EXPECT_NO_THROW(require_valid(valid()));
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const auto refused = [](double ContactParameters::* value, double bad, const char* part) {
    ContactParameters p = valid();
    p.*value = bad;
    expect_refused([&] { require_valid(p); }, part);
  };
  for (const double bad : {0.0, -1.0, nan, inf})
    refused(&ContactParameters::stiffness, bad, "stiffness K");
  for (const double bad : {-0.1, 1.1, nan, inf})
    refused(&ContactParameters::restitution, bad, "restitution");
  for (const double bad : {nan, inf}) refused(&ContactParameters::damping, bad, "damping eta");
  for (const double bad : {-1.0, nan, inf}) {
    refused(&ContactParameters::tangential_ratio, bad, "ratio of tangential to normal stiffness");
    refused(&ContactParameters::tangential_damping_ratio, bad,
            "ratio of tangential to normal damping");
    refused(&ContactParameters::friction, bad, "friction coefficient");
    refused(&ContactParameters::rolling_friction, bad, "rolling friction coefficient");
  }
}

}  // namespace cohesion::contact
