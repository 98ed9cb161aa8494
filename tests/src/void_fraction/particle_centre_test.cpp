// SPDX-License-Identifier: BSD-3-Clause
#include "void_fraction/particle_centre.h"

#include <gtest/gtest.h>

#include <numeric>

#include "sphere.h"

namespace cohesion::void_fraction {

TEST(ParticleCentre, GivesAllOfAParticleToItsCell) {
  std::vector<double> solid(3, 0.0);
  ParticleCentre::deposit(1, 0.25, solid);
  ParticleCentre::deposit(1, 0.5, solid);
  ParticleCentre::deposit(2, 0.125, solid);
  EXPECT_EQ(solid, (std::vector<double>{0.0, 0.75, 0.125}));
}

TEST(ParticleCentre, ConservesTheSolidVolume) {
  std::vector<double> solid(7, 0.0);
  double volume = 0.0;
  for (int i = 0; i < 1000; i++) {
    const double v = sphere_volume(1e-3 + 1e-6 * i);
    ParticleCentre::deposit(i * 31 % 7, v, solid);
    volume += v;
  }
  // 1000 additions, each rounded to 1e-16 of the sum so far.
  EXPECT_NEAR(std::accumulate(solid.begin(), solid.end(), 0.0) / volume, 1.0, 1e-13);
}

TEST(VoidFraction, OfAnEmptyCellIsOne) { EXPECT_EQ(void_fraction(0.0, 2.0, 1.0), 1.0); }

TEST(VoidFraction, CountsTheDepthOfTheParticlesNotTheThicknessOfTheMesh) {
  // One sphere of unit diameter in a cell of area 2: in a mesh of thickness 10 the cell has volume
  // 20, and the slab of depth 1 a volume of 2.
  EXPECT_DOUBLE_EQ(void_fraction(pi / 6.0, 20.0, 0.1), 1.0 - pi / 12.0);
}

}  // namespace cohesion::void_fraction
