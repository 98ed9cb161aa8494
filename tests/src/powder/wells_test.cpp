// SPDX-License-Identifier: BSD-3-Clause
#include "powder/wells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/adhesive_contact.h"
#include "hamaker/forms.h"
#include "refuses.h"
#include "sphere.h"

namespace cohesion::powder {

namespace {

constexpr double d = 5e-4, stiffness = 1.7e4;
const double mass = 2500.0 * sphere_volume(0.5 * d);

contact::Adhesion adhesion_of(const hamaker::HamakerParameters& p, const PairGeometry& geometry) {
  return std::visit([&](const auto& law) { return contact::adhesion_of(law, geometry); },
                    hamaker::forms.front().law(p, p.asperity_radius > 0.0));
}

double escape(double k, double e, double mu, const contact::Adhesion& adhesion) {
  return contact::AdhesiveContact(contact::LinearSpringDashpot::from_restitution(k, e, mu),
                                  adhesion)
      .escape_velocity();
}

const hamaker::HamakerParameters smooth{6.5e-20, 4e-10, 1e-7}, rough{1e-19, 4e-10, 1e-7, 1e-7};

}  // namespace

// At every restitution, in pairs and at walls, smooth and rough, and whatever the springs of the
// run: bounded by the closed form's root and its rounding.
TEST(Wells, HoldPairsUpToTheEscapeVelocityOfTheMaterial) {
  for (const hamaker::HamakerParameters& p : {smooth, rough})
    for (const PairGeometry& geometry : {two_spheres(0.5 * d, 0.5 * d), sphere_and_plane(0.5 * d)})
      for (const double e : {0.3, 0.9, 0.99}) {
        const double mu = geometry.reduced_radius > 0.3 * d ? mass : 0.5 * mass;
        const contact::Adhesion real = adhesion_of(p, geometry);
        const double depth = well_depth(stiffness, e, mu, real);
        const double expected = escape(stiffness, e, mu, real);
        ASSERT_GT(expected, 0.0);
        for (const double soft : {stiffness, 1400.0, 1.0})
          EXPECT_NEAR(escape(soft, e, mu, {0.0, 0.01 * d, depth}) / expected, 1.0, 1e-12) << e;
      }
}

// v_esc^2 = (2 D/mu)(1/e^2 - 1), with v_esc from the contact itself.
TEST(Wells, AreAsDeepAsPrinted) {
  const double e = 0.9, mu = 0.5 * mass;
  const contact::Adhesion real = adhesion_of(smooth, two_spheres(0.5 * d, 0.5 * d));
  const double v = escape(stiffness, e, mu, real);
  EXPECT_NEAR(well_depth(stiffness, e, mu, real) / (0.5 * mu * v * v / (1.0 / 0.81 - 1.0)), 1.0,
              1e-13);
}

// Of a contact so rigid that adhesion works on the way to it alone, its energy W.
TEST(Wells, TendToTheEnergyOfTheAttractionOfRigidGrains) {
  const contact::Adhesion real = adhesion_of(smooth, two_spheres(0.5 * d, 0.5 * d));
  EXPECT_NEAR(well_depth(1e14, 0.9, 0.5 * mass, real) / real.well_energy(), 1.0, 1e-4);
  EXPECT_GT(well_depth(1e3, 0.9, 0.5 * mass, real), real.well_energy());
}

// All is magnified by l (powder/parcels.h), and the energy by l^3.
TEST(Wells, OfParcelsAreAsDeepAsTheirVolume) {
  const double l = 3.0;
  const hamaker::HamakerParameters large{l * l * l * smooth.hamaker_constant,
                                         l * smooth.surface_cutoff, l * smooth.outer_cutoff};
  const double grain =
      well_depth(stiffness, 0.9, 0.5 * mass, adhesion_of(smooth, two_spheres(0.5 * d, 0.5 * d)));
  const double parcel = well_depth(l * stiffness, 0.9, 0.5 * l * l * l * mass,
                                   adhesion_of(large, two_spheres(0.5 * l * d, 0.5 * l * d)));
  EXPECT_NEAR(parcel / grain / (l * l * l), 1.0, 1e-12);
}

TEST(Wells, NeedLossAndCohesion) {
  const contact::Adhesion real = adhesion_of(smooth, two_spheres(0.5 * d, 0.5 * d));
  EXPECT_EQ(well_depth(stiffness, 0.9, 0.5 * mass, {}), 0.0);
  expect_refused([&] { well_depth(stiffness, 1.0, 0.5 * mass, real); },
                 "restitution e = 1: must lie between 0 and 1 with a square well");
}

}  // namespace cohesion::powder
