// SPDX-License-Identifier: BSD-3-Clause
#include "lattice_boltzmann/walls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "constants.h"
#include "refuses.h"

namespace cohesion::lattice_boltzmann {

TEST(Lattice, VelocitiesComeInOppositePairsAndWeightsAreThoseOfItsMoments) {
  double sum = 0.0, second = 0.0, fourth = 0.0;
  for (int q = 0; q < directions; q++) {
    for (int k = 0; k < 3; k++) EXPECT_EQ(velocity[q][k], -velocity[opposite(q)][k]);
    EXPECT_EQ(opposite(opposite(q)), q);
    sum += weight(q);
    second += weight(q) * velocity[q][0] * velocity[q][0];
    fourth += weight(q) * velocity[q][0] * velocity[q][0] * velocity[q][1] * velocity[q][1];
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
  EXPECT_NEAR(second, 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(fourth, 1.0 / 9.0, 1e-15);
}

// Each link ends on the sphere, whose images count; nodes inside are those of its volume, but for a
// shell of half a spacing.
TEST(Walls, LinksEndOnTheSphere) {
  const Grid grid({20, 18, 16});
  const FixedSphere sphere{{19.3, 0.4, 8.1}, 6.2};
  const Walls walls(grid, {sphere});
  ASSERT_EQ(walls.spheres(), 1);
  int found = 0, links = 0;
  for (int q = 1; q < directions; q++) links += static_cast<int>(walls.links(0, q).size());
  ASSERT_GT(links, 100);
  for (int z = 0; z < 16; z++)
    for (int y = 0; y < 18; y++)
      for (int x = 0; x < 20; x++)
        for (int q = 1; q < directions; q++)
          for (const Link& link : walls.links(0, q)) {
            if (link.node != grid.index(x, y, z)) continue;
            double squares = 0.0;
            const int node[] = {x, y, z};
            for (int k = 0; k < 3; k++) {
              const double n = grid.nodes(k);
              const double at = node[k] + link.distance * velocity[q][k] - sphere.centre[k];
              squares += std::pow(at - n * std::round(at / n), 2);
            }
            EXPECT_NEAR(std::sqrt(squares), sphere.radius, 1e-12);
            EXPECT_FALSE(walls.is_fluid(link.node + grid.offset(q)));
            found++;
          }
  EXPECT_EQ(found, links);
  const double inside = 20.0 * 18.0 * 16.0 - static_cast<double>(walls.fluid_nodes());
  EXPECT_GT(inside, 4.0 / 3.0 * pi * std::pow(5.7, 3));
  EXPECT_LT(inside, 4.0 / 3.0 * pi * std::pow(6.7, 3));
}

// Two spheres half a spacing apart: behind nodes between them there is none to interpolate with.
TEST(Walls, LinksOfNarrowGapsAreHalved) {
  const Walls walls(Grid({24, 16, 16}), {{{7.0, 8.0, 8.0}, 4.6}, {{17.0, 8.0, 8.0}, 4.6}});
  bool halved = false;
  for (const int sphere : {0, 1})
    for (int q = 1; q < directions; q++)
      for (const Link& link : walls.links(sphere, q)) halved |= link.halved();
  EXPECT_TRUE(halved);
}

// Runs are all nodes of the fluid, each once, and no other.
TEST(Walls, RunsAreTheNodesOfTheFluid) {
  const Grid grid({14, 12, 10});
  const Walls walls(grid, {{{13.2, 0.4, 5.1}, 4.2}});
  std::vector<int> seen(grid.size(), 0);
  for (int z = 0; z < 10; z++)
    for (const auto& run : walls.runs(z))
      for (int i = 0; i < run.nodes; i++) seen[run.first + i]++;
  std::size_t nodes = 0;
  for (int z = 0; z < 10; z++)
    for (int y = 0; y < 12; y++)
      for (int x = 0; x < 14; x++) {
        const std::size_t node = grid.index(x, y, z);
        EXPECT_EQ(seen[node], walls.is_fluid(node) ? 1 : 0);
        nodes += seen[node];
      }
  EXPECT_EQ(nodes, walls.fluid_nodes());
}

TEST(Walls, WhatDoesNotFitIsRefused) {
  EXPECT_THROW(Grid({3, 8, 8}), InvalidParameter);
  EXPECT_NO_THROW(Grid({4, 4, 4}));
  expect_refused([] { Walls(Grid({8, 8, 8}), {{{4.0, 4.0, 4.0}, 4.5}}); },
                 "diameter of a sphere = 9");
  EXPECT_NO_THROW(Walls(Grid({8, 8, 8}), {{{4.0, 4.0, 4.0}, 4.0}}));
  EXPECT_THROW(Walls(Grid({8, 8, 8}), {{{4.0, 4.0, 4.0}, 0.0}}), InvalidParameter);
}

}  // namespace cohesion::lattice_boltzmann
