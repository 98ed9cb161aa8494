// SPDX-License-Identifier: BSD-3-Clause
#include "bed/geldart.h"

#include <gtest/gtest.h>

using cohesion::bed::geldart_group;
using cohesion::bed::GeldartGroup;

namespace {

// Powders whose group the literature states, and one that is far from the lines.
TEST(Geldart, KnownPowders) {
  // Cracking catalyst, the example of group A in Geldart's paper
  EXPECT_EQ(geldart_group(1400 - 1.2, 60e-6), GeldartGroup::A);
  // 75 um, 1500 kg/m3: van der Hoef et al. (2006), as group A
  EXPECT_EQ(geldart_group(1500 - 1.2, 75e-6), GeldartGroup::A);
  // Sand of 40 to 500 um, the example of group B
  EXPECT_EQ(geldart_group(2650 - 1.2, 0.25e-3), GeldartGroup::B);
  // Beads of 4 mm, as in the beds of Hoomans et al. (1996): far beyond the sands
  EXPECT_EQ(geldart_group(2700 - 1.2, 4e-3), GeldartGroup::D);
}

// Both sides of the lines, in the units of the paper: g/cm^3 and um.
TEST(Geldart, LinesAreWhereThePaperHasThem) {
  EXPECT_EQ(geldart_group(2500, 89.9e-6), GeldartGroup::A);  // 2.5 x 89.9 = 224.75
  EXPECT_EQ(geldart_group(2500, 90.1e-6), GeldartGroup::B);  // 225.25
  EXPECT_EQ(geldart_group(2500, 632e-6), GeldartGroup::B);   // 2.5 x 632^2 = 0.99856e6
  EXPECT_EQ(geldart_group(2500, 633e-6), GeldartGroup::D);   // 1.0017e6
}

TEST(Geldart, BeyondTheCrossingOfTheLinesIsD) {
  EXPECT_EQ(geldart_group(50, 4.49e-3), GeldartGroup::D);  // 224.5 g/cm^3 um, 1.008e6
}

}  // namespace
