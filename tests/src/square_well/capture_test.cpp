// SPDX-License-Identifier: BSD-3-Clause
#include "square_well/capture.h"

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

TEST(Capture, IsWhatHappensAtTheEdge) {
  std::mt19937 random(3);
  std::normal_distribution<double> any;
  int captured = 0;
  const int pairs = 1000;
  for (int k = 0; k < pairs; k++) {
    Vector3 r{any(random), any(random), any(random)};
    r = (2.05 / norm(r)) * r;
    const Vector3 w{any(random), any(random), any(random)};
    EXPECT_EQ(will_be_captured(r, w, edge_at, depth, b), captured_at_edge(r, w)) << k;
    captured += will_be_captured(r, w, edge_at, depth, b);
  }
  EXPECT_GT(captured, pairs / 10);
  EXPECT_LT(captured, pairs * 9 / 10);
}

TEST(Capture, NeverAfterAnApproach) {
  for (const double u : {0.01, 1.0, 30.0}) {
    const double inside = u - b * approach_impulse(u, depth, b);
    EXPECT_FALSE(will_be_captured({edge_at, 0, 0}, {inside, 0.3, 0}, edge_at, depth, b)) << u;
  }
}

TEST(Capture, AtRestOrCirclingWhateverItsEnergy) {
  EXPECT_TRUE(will_be_captured({2.1, 0, 0}, {0, 0, 0}, edge_at, depth, b));
  EXPECT_TRUE(will_be_captured({edge_at, 0, 0}, {0, 1e6, 0}, edge_at, depth, b));
  // From r, across: u^2 = w^2 (1 - r^2/edge^2).
  const double limit = std::sqrt(2 * depth * b / (1 - 2.1 * 2.1 / edge_at / edge_at));
  EXPECT_TRUE(will_be_captured({2.1, 0, 0}, {0, 0.999 * limit, 0}, edge_at, depth, b));
  EXPECT_FALSE(will_be_captured({2.1, 0, 0}, {0, 1.001 * limit, 0}, edge_at, depth, b));
}

}  // namespace
