// SPDX-License-Identifier: BSD-3-Clause
#include "advice/known_materials.h"

#include <gtest/gtest.h>

namespace cohesion::advice {
namespace {

TEST(SiUnits, GiveWaterItsDensityAndAJouleItsSize) {
  // 1 g/cm^3; 1 pg/um^3; 1e-3 ag/nm^3.
  EXPECT_NEAR(find_si_units("cgs")->density(), 1000.0, 1e-9);
  EXPECT_NEAR(find_si_units("micro")->density(), 1000.0, 1e-9);
  EXPECT_NEAR(1e-3 * find_si_units("nano")->density(), 1000.0, 1e-9);
  // erg; pg um^2/us^2; ag nm^2/ns^2.
  EXPECT_NEAR(find_si_units("cgs")->energy(), 1e-7, 1e-20);
  EXPECT_NEAR(find_si_units("micro")->energy(), 1e-15, 1e-28);
  EXPECT_NEAR(find_si_units("nano")->energy(), 1e-21, 1e-34);
  EXPECT_EQ(find_si_units("lj"), nullptr);
}

TEST(KnownMaterials, HaveHamakerConstantsOfWhichOthersAreTold) {
  const SiUnits *si = find_si_units("si"), *cgs = find_si_units("cgs");
  EXPECT_EQ(above_hamaker_constants(1e-18, si), "");
  EXPECT_EQ(above_hamaker_constants(5e-19, si), "");
  EXPECT_EQ(above_hamaker_constants(0.0, si), "");
  EXPECT_NE(above_hamaker_constants(1e-17, si).find("A = 1e-17 J is above"), std::string::npos);
  // 1e-18 J in erg, and the number of J that is taken for erg.
  EXPECT_EQ(above_hamaker_constants(1e-11, cgs), "");
  EXPECT_NE(above_hamaker_constants(1e-10, cgs).find("is 1e-17 J"), std::string::npos);
  EXPECT_EQ(above_hamaker_constants(1.0, nullptr), "");
}

TEST(KnownMaterials, TellAMassThatWasSetBeforeTheDiameter) {
  const SiUnits* const si = find_si_units("si");
  const double of_diameter_1 = 1500.0 * sphere_volume(0.5);
  for (const double radius : {37.5e-6, 1e-3, 5e-3})
    EXPECT_TRUE(is_mass_of_diameter_1(of_diameter_1, radius, si)) << radius;
  // Nearly 1 m, and those that are as they should be.
  EXPECT_FALSE(is_mass_of_diameter_1(of_diameter_1, 0.4, si));
  for (const double radius : {1e-8, 37.5e-6, 0.5, 2.0})
    EXPECT_FALSE(is_mass_of_diameter_1(1500.0 * sphere_volume(radius), radius, si)) << radius;
  // Scaled a thousandfold for a longer step.
  EXPECT_FALSE(is_mass_of_diameter_1(1.5e6 * sphere_volume(1e-3), 1e-3, si));
  // In micrometres and picograms the sphere is the larger one.
  const SiUnits* const micro = find_si_units("micro");
  EXPECT_TRUE(is_mass_of_diameter_1(1.5 * sphere_volume(0.5), 37.5, micro));
  EXPECT_FALSE(is_mass_of_diameter_1(1.5 * sphere_volume(37.5), 37.5, micro));
  EXPECT_FALSE(is_mass_of_diameter_1(of_diameter_1, 37.5e-6, nullptr));
}

TEST(KnownMaterials, RevealAMassThatWasNeverSet) {
  const SiUnits *si = find_si_units("si"), *nano = find_si_units("nano");
  const double created = sphere_volume(0.5);
  for (const double radius : {37.5e-6, 1e-3, 5e-3})
    EXPECT_TRUE(is_mass_as_created(created, radius, si)) << radius;
  EXPECT_TRUE(is_mass_as_created((1.0 + 1e-14) * created, 37.5e-6, si));
  // Of steel, by chance.
  EXPECT_FALSE(is_mass_as_created(created, 0.025, si));
  // A density that makes spheres heavy on purpose, and one that gives nearly this mass.
  EXPECT_FALSE(is_mass_as_created(1e12 * sphere_volume(37.5e-6), 37.5e-6, si));
  EXPECT_FALSE(is_mass_as_created((1.0 + 1e-9) * created, 37.5e-6, si));
  // A density of 1 is 1e6 kg/m^3 there.
  EXPECT_TRUE(is_mass_as_created(created, 150.0, nano));
  EXPECT_FALSE(is_mass_as_created(created, 20.0, nano));
  EXPECT_FALSE(is_mass_as_created(created, 37.5e-6, nullptr));
}

}  // namespace
}  // namespace cohesion::advice
