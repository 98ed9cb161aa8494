// SPDX-License-Identifier: BSD-3-Clause
#include "powder/parcels.h"

#include <gtest/gtest.h>

#include "contact/rebound.h"
#include "hamaker/forms.h"
#include "powder/grain_contact.h"

namespace cohesion::powder {

namespace {

constexpr double d = 1e-4, restitution = 0.8, stiffness = 50.0;
const hamaker::HamakerParameters attraction{1e-19, 4e-10, 1e-7};

double mass(double diameter) { return 1500.0 * sphere_volume(0.5 * diameter); }

contact::Adhesion adhesion(const hamaker::HamakerParameters& p, double diameter) {
  const hamaker::AnyLaw law = hamaker::forms.front().law(p, p.asperity_radius > 0.0);
  const PairGeometry pair = two_spheres(0.5 * diameter, 0.5 * diameter);
  return std::visit([&](const auto& l) { return contact::adhesion_of(l, pair); }, law);
}

contact::AdhesiveContact contact_of(const hamaker::HamakerParameters& p, double diameter,
                                    double k) {
  return {contact::LinearSpringDashpot::from_restitution(k, restitution, 0.5 * mass(diameter)),
          adhesion(p, diameter)};
}

}  // namespace

// Everything is magnified by l: to rounding.
TEST(Parcels, StickAsTheirGrainsDo) {
  const hamaker::HamakerParameters rough{1e-19, 4e-10, 1e-7, 2e-8},
      cap{1e-19, 4e-10, 1e-7, 2e-7, 2e-9};
  for (const hamaker::HamakerParameters& p : {attraction, rough, cap})
    for (const double l : {1.0, 2.0, 3.5, 10.0}) {
      const Parcels parcels(l);
      const auto grain = contact_of(p, d, stiffness);
      const auto parcel =
          contact_of(parcels.attraction(p), parcels.length(d), parcels.stiffness(stiffness));
      EXPECT_NEAR(parcel.escape_velocity() / grain.escape_velocity(), 1.0, 1e-12);
      for (const double speed : {0.5, 1.5, 20.0}) {
        const double v = speed * grain.escape_velocity();
        EXPECT_NEAR(effective_restitution(parcel, v), effective_restitution(grain, v), 1e-12);
      }
      EXPECT_NEAR(parcel.adhesion().force, parcels.force(grain.adhesion().force),
                  1e-12 * parcel.adhesion().force);
      EXPECT_NEAR(parcel.spring().contact_time(), parcels.time(grain.spring().contact_time()),
                  1e-12 * parcel.spring().contact_time());
    }
}

// F_ad/(m g) of eight grains in a parcel is half of theirs.
TEST(Parcels, LoseBondNumber) {
  const Parcels parcels(2.0);
  const double grain = adhesion(attraction, d).force / mass(d);
  const double parcel =
      adhesion(parcels.attraction(attraction), parcels.length(d)).force / mass(parcels.length(d));
  EXPECT_NEAR(parcel / grain, 0.5, 1e-14);
  EXPECT_DOUBLE_EQ(parcels.number(8000.0), 1000.0);
  EXPECT_DOUBLE_EQ(parcels.drag_diameter(parcels.length(d)), d);
  EXPECT_DOUBLE_EQ(parcels.mass(mass(d)) / mass(parcels.length(d)), 1.0);
}

TEST(Parcels, AreNotSmallerThanGrains) {
  EXPECT_THROW(Parcels(0.5), InvalidParameter);
  EXPECT_THROW(Parcels(std::nan("")), InvalidParameter);
}

}  // namespace cohesion::powder
