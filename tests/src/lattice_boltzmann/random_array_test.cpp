// SPDX-License-Identifier: BSD-3-Clause
#include "lattice_boltzmann/random_array.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cohesion::lattice_boltzmann {

namespace {

double distance(const Array& array, int i, int j) {
  double squares = 0.0;
  for (int k = 0; k < 3; k++) {
    const double n = array.nodes[k];
    const double d = array.spheres[i].centre[k] - array.spheres[j].centre[k];
    squares += std::pow(d - n * std::round(d / n), 2);
  }
  return std::sqrt(squares);
}

double solid(const Array& array) {
  double volume = 0.0;
  for (const FixedSphere& s : array.spheres) volume += 4.0 / 3.0 * pi * std::pow(s.radius, 3);
  return volume / (static_cast<double>(array.nodes[0]) * array.nodes[1] * array.nodes[2]);
}

}  // namespace

TEST(RandomArray, HasItsFractionAndNoOverlap) {
  for (const double phi : {0.02, 0.3, 0.6}) {
    const Array array = random_array({phi, std::vector<double>(54, 1.0), 7, 10.0}, 12.0);
    EXPECT_NEAR(solid(array), phi, 1e-12);
    EXPECT_NEAR(2.0 * array.spheres[0].radius, 12.0, 0.2);
    for (int i = 0; i < 54; i++)
      for (int j = 0; j < i; j++)
        EXPECT_GE(distance(array, i, j), 2.0 * array.spheres[0].radius * (1.0 - 1e-10));
  }
}

TEST(RandomArray, KeepsTheSizesOfAMixture) {
  std::vector<double> diameters(64, 1.0);
  for (int i = 0; i < 8; i++) diameters[i] = 2.0;
  const Array array = random_array({0.5, diameters, 3, 10.0}, 12.0);
  EXPECT_NEAR(solid(array), 0.5, 1e-12);
  EXPECT_NEAR(array.spheres[0].radius / array.spheres[63].radius, 2.0, 1e-12);
  for (int i = 0; i < 64; i++)
    for (int j = 0; j < i; j++)
      EXPECT_GE(distance(array, i, j),
                (array.spheres[i].radius + array.spheres[j].radius) * (1.0 - 1e-10));
}

// Its edge is a whole number of nodes, n: d_32 is off by half a node in n at most.
TEST(RandomArray, HasTheSauterMeanAskedForInAnyUnitOfDiameters) {
  for (const double unit : {1.0, 3.0}) {
    std::vector<double> diameters(64, unit);
    for (int i = 0; i < 8; i++) diameters[i] = 2.0 * unit;
    const Array array = random_array({0.3, diameters, 3, 5.0}, 12.0);
    double squares = 0.0, cubes = 0.0;
    for (const FixedSphere& s : array.spheres) {
      squares += std::pow(2.0 * s.radius, 2);
      cubes += std::pow(2.0 * s.radius, 3);
    }
    EXPECT_NEAR(cubes / squares, 12.0, 12.0 * 0.5 / (array.nodes[0] - 0.5));
    EXPECT_NEAR(sauter_mean(array), cubes / squares, 1e-13);
  }
}

TEST(RandomArray, IsAnotherOneWithAnotherSeedAndTheSameWithTheSame) {
  const auto of = [](unsigned seed) {
    return random_array({0.3, std::vector<double>(20, 1.0), seed, 5.0}, 8.0).spheres[11].centre;
  };
  EXPECT_EQ(of(1), of(1));
  EXPECT_NE(of(1), of(2));
}

// Pairs at contact: g = (1 - phi/2)/(1 - phi)^3 of Carnahan and Starling, 2.15 at 0.3. In a shell
// of a tenth of a diameter there are 24 phi g 0.1 (1 + ...) neighbours; g falls by some 2.5 g phi
// per diameter, which is left out, and counts scatter as the root of some 54 x 20 pairs: 10 %.
TEST(RandomArray, IsAFluidInEquilibrium) {
  double close = 0.0;
  for (unsigned seed = 1; seed <= 20; seed++) {
    const Array array = random_array({0.3, std::vector<double>(54, 1.0), seed, 50.0}, 8.0);
    const double d = 2.0 * array.spheres[0].radius;
    for (int i = 0; i < 54; i++)
      for (int j = 0; j < i; j++) close += distance(array, i, j) < 1.1 * d;
  }
  const double phi = 0.3, shell = std::pow(1.1, 3) - 1.0;
  const double pairs = 20 * 54 / 2.0 * 8.0 * phi * shell;
  const double contact = (1.0 - 0.5 * phi) / std::pow(1.0 - phi, 3);
  EXPECT_LT(close / pairs, contact * 1.05);
  EXPECT_GT(close / pairs, contact * 0.8);
}

TEST(RandomArray, WhatCannotBeIsRefused) {
  const std::vector<double> equal(54, 1.0);
  EXPECT_THROW(random_array({0.7, equal, 1}, 12.0), InvalidParameter);
  EXPECT_THROW(random_array({0.0, equal, 1}, 12.0), InvalidParameter);
  EXPECT_THROW(random_array({0.3, {}, 1}, 12.0), InvalidParameter);
  EXPECT_THROW(random_array({0.3, {1.0, -1.0}, 1}, 12.0), InvalidParameter);
  EXPECT_THROW(random_array({0.5, {1.0, 1.0}, 1}, 12.0), InvalidParameter);  // larger than half
  EXPECT_THROW(random_array({0.1, equal, 1}, 3.0), InvalidParameter);
  // These jam before they fill so much.
  EXPECT_THROW(random_array({0.6, std::vector<double>(16, 1.0), 1}, 12.0), InvalidParameter);
}

}  // namespace cohesion::lattice_boltzmann
