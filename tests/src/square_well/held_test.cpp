// SPDX-License-Identifier: BSD-3-Clause
#include "square_well/held.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "square_well/impulses.h"

namespace {

using namespace cohesion;
using namespace cohesion::square_well;

constexpr double edge_at = 2.2, depth = 0.7, b = 1.5;

/// Flies the pair to the edge and asks there.
bool captured_at_edge(const Vector3& r, const Vector3& w) {
  // |r - w t| = edge; r closes with w.
  const double ww = dot(w, w), rw = dot(r, w);
  const double t = (rw + std::sqrt(rw * rw + ww * (edge_at * edge_at - dot(r, r)))) / ww;
  const Vector3 at = r - t * w;
  return !escapes(dot(at, w) / edge_at, depth, b);
}

TEST(Held, IsWhatHappensAtTheEdge) {
  std::mt19937 random(3);
  std::normal_distribution<double> any;
  int held_pairs = 0;
  const int pairs = 1000;
  for (int k = 0; k < pairs; k++) {
    Vector3 r{any(random), any(random), any(random)};
    r = (2.05 / norm(r)) * r;
    const Vector3 w{any(random), any(random), any(random)};
    EXPECT_EQ(held(r, w, edge_at, depth, b), captured_at_edge(r, w)) << k;
    held_pairs += held(r, w, edge_at, depth, b);
  }
  EXPECT_GT(held_pairs, pairs / 10);
  EXPECT_LT(held_pairs, pairs * 9 / 10);
}

TEST(Held, NeverAfterAnApproach) {
  for (const double u : {0.01, 1.0, 30.0}) {
    const double inside = u - b * approach_impulse(u, depth, b);
    EXPECT_FALSE(held({edge_at, 0, 0}, {inside, 0.3, 0}, edge_at, depth, b)) << u;
  }
}

TEST(Held, AtRestOrCirclingWhateverItsEnergy) {
  EXPECT_TRUE(held({2.1, 0, 0}, {0, 0, 0}, edge_at, depth, b));
  EXPECT_TRUE(held({edge_at, 0, 0}, {0, 1e6, 0}, edge_at, depth, b));
  // From r, across: u^2 = w^2 (1 - r^2/edge^2).
  const double limit = std::sqrt(2 * depth * b / (1 - 2.1 * 2.1 / edge_at / edge_at));
  EXPECT_TRUE(held({2.1, 0, 0}, {0, 0.999 * limit, 0}, edge_at, depth, b));
  EXPECT_FALSE(held({2.1, 0, 0}, {0, 1.001 * limit, 0}, edge_at, depth, b));
}

}  // namespace
