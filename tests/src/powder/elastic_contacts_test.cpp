// SPDX-License-Identifier: BSD-3-Clause
#include "powder/elastic_contacts.h"

#include <gtest/gtest.h>

#include "powder/parcels.h"
#include "sphere.h"

namespace cohesion::powder {

namespace {

constexpr double young = 63e9, w = 0.04;

double mass(double diameter) { return 2500.0 * sphere_volume(0.5 * diameter); }

/// Two grains, in JKR's contact or with the attraction of the same work of adhesion around Hertz's.
ElasticBorne two(double diameter, bool jkr, double work = w) {
  contact::ContactParameters p;
  contact::set_hertz(p, young, 0.22);
  p.restitution = 0.9;
  const double radius = 0.25 * diameter, force = 2.0 * pi * work * radius;
  if (jkr) p.work_of_adhesion = work;
  const contact::Adhesion dmt{force, 4e-10, 4e-10 * force};
  return {diameter, {p, radius, 0.5 * mass(diameter), jkr ? contact::Adhesion{} : dmt}};
}

ElasticDemand demand(contact::Keep keep = contact::Keep::escape_velocity) {
  return {young, 0.0, {0.5, 1e3}, 0.01, keep};
}

}  // namespace

TEST(ElasticContacts, AreAsSoftAsTheOverlapAllows) {
  for (const bool jkr : {false, true})
    for (const auto keep : {contact::Keep::escape_velocity, contact::Keep::force}) {
      const ElasticBorne pair = two(5e-4, jkr);
      const double ratio = softest_ratio(pair, demand(keep));
      const double modulus = pair.pair.contact().modulus;
      EXPECT_LE(pair.pair.softened(ratio * modulus, keep).largest_overlap(0.5), 5e-6);
      EXPECT_GT(pair.pair.softened(0.99 * ratio * modulus, keep).largest_overlap(0.5), 5e-6);
    }
}

TEST(ElasticContacts, BearTheWeightOfTheBed) {
  ElasticDemand heavy = demand();
  heavy.load = {1e-3, 1e6};
  // p d^2 and the adhesion press Hertz's contact: x = ((p d^2 + F_ad)/k)^(2/3).
  const ElasticBorne pair = two(5e-4, false);
  const double ratio = softest_ratio(pair, heavy);
  const advice::ElasticPair soft =
      pair.pair.softened(ratio * pair.pair.contact().modulus, heavy.keep);
  const double k = 4.0 / 3.0 * soft.contact().modulus * std::sqrt(1.25e-4);
  const double load = 1e6 * 2.5e-7 + soft.pull_off_force();
  EXPECT_NEAR(std::pow(load / k, 2.0 / 3.0) / 5e-6, 1.0, 2e-6);
}

TEST(ElasticContacts, KeepWhatIsAskedAndRoundTheModulus) {
  for (const bool jkr : {false, true}) {
    const ElasticContacts velocity = elastic_contacts({two(5e-4, jkr)}, demand());
    const ElasticContacts force = elastic_contacts({two(5e-4, jkr)}, demand(contact::Keep::force));
    // Both are bisected to 1e-5.
    EXPECT_NEAR(velocity.over.escape_velocity, 1.0, 3e-5);
    EXPECT_NEAR(velocity.over.force, std::pow(velocity.young / young, 0.4), 1e-12);
    EXPECT_EQ(force.over.force, 1.0);
    EXPECT_GT(force.over.escape_velocity, 2.0);
    EXPECT_EQ(velocity.young, two_digits_below(velocity.young));
  }
}

TEST(ElasticContacts, AreNoStifferThanTheMaterialAndNoSofterThanTheAttractionBears) {
  ElasticDemand d = demand();
  d.load.pressure = 1e13;
  EXPECT_EQ(elastic_contacts({two(5e-4, true)}, d).young, young);
  d = demand();
  d.least = 5e10;
  EXPECT_GE(elastic_contacts({two(5e-4, false)}, d).young, 5e10);
  d.given = 1e8;
  EXPECT_EQ(elastic_contacts({two(5e-4, false)}, d).young, 1e8);
}

// Everything is magnified by l, at the same modulus.
TEST(ElasticContacts, OfParcelsStickAsTheirGrainsDo) {
  for (const double l : {2.0, 10.0}) {
    const Parcels parcels(l);
    const auto grain = two(5e-4, true), parcel = two(5e-4 * l, true, parcels.surface_energy(w));
    // Bisected from guesses that differ by roundings.
    EXPECT_NEAR(parcel.pair.escape_velocity() / grain.pair.escape_velocity(), 1.0, 3e-5);
    EXPECT_NEAR(parcel.pair.pull_off_force() / parcels.force(grain.pair.pull_off_force()), 1.0,
                1e-14);
    EXPECT_NEAR(parcel.pair.contact_time(0.1) / parcels.time(grain.pair.contact_time(0.1)), 1.0,
                1e-14);
  }
}

}  // namespace cohesion::powder
