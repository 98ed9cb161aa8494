// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/crossing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hard_sphere/wall_crossing.h"

namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

constexpr Surfaces well{1.0, 1.5};
constexpr Surfaces bare{1.0, 1.0};
constexpr Vector3 still{};

/// With speeds of the pair of order 1.
Crossing next_crossing(const Vector3& r, const Vector3& w, const Surfaces& surfaces, bool inside) {
  return cohesion::hard_sphere::next_crossing(r, w, 1.0, surfaces, inside);
}

// Distances of order 1 are rounded by a few 1e-16; times are distances over speeds of order 1.
constexpr double round_off = 1e-15;

TEST(Crossing, HeadOnTimes) {
  const Crossing in = next_crossing({3.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}, well, false);
  EXPECT_NEAR(in.wait, 0.75, round_off);
  EXPECT_EQ(in.surface, Surface::edge_inward);
  const Crossing hit = next_crossing({1.5, 0.0, 0.0}, {-2.0, 0.0, 0.0}, well, true);
  EXPECT_NEAR(hit.wait, 0.25, round_off);
  EXPECT_EQ(hit.surface, Surface::core);
  const Crossing out = next_crossing({1.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, well, true);
  EXPECT_NEAR(out.wait, 1.0, round_off);
  EXPECT_EQ(out.surface, Surface::edge_outward);
  EXPECT_EQ(next_crossing({3.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}, bare, false).surface, Surface::core);
}

TEST(Crossing, ObliqueTimesPutThePairOnTheSurface) {
  const Vector3 r{2.0, 0.7, -0.3}, w{-1.3, 0.2, 0.4};
  const Crossing in = next_crossing(r, w, well, false);
  EXPECT_NEAR(norm(r + in.wait * w), well.edge, 3 * round_off);
  const Vector3 inside{0.9, 0.9, 0.0};
  const Crossing out = next_crossing(inside, w, well, true);
  ASSERT_EQ(out.surface, Surface::edge_outward);
  EXPECT_NEAR(norm(inside + out.wait * w), well.edge, 3 * round_off);
}

TEST(Crossing, NoneWhenPartingStillOrPassing) {
  EXPECT_EQ(next_crossing({3.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, well, false).wait, never);
  EXPECT_EQ(next_crossing({3.0, 0.0, 0.0}, still, well, false).wait, never);
  EXPECT_EQ(next_crossing({1.2, 0.0, 0.0}, still, well, true).wait, never);
  EXPECT_EQ(next_crossing({-3.0, 1.5000001, 0.0}, {1.0, 0.0, 0.0}, well, false).wait, never);
  EXPECT_LT(next_crossing({-3.0, 1.4999999, 0.0}, {1.0, 0.0, 0.0}, well, false).wait, 3.0);
}

// What was just crossed lies behind by the flag, wherever round-off has left the pair.
TEST(Crossing, RoundOffAtASurfaceNeitherRepeatsNorMissesIt) {
  for (const double off : {-3e-16, 0.0, 3e-16}) {
    const Vector3 r{1.5 + off, 0.0, 0.0};
    // Just inside after an approach, and after a capture: the core, or the far side.
    EXPECT_EQ(next_crossing(r, {-1.0, 0.0, 0.0}, well, true).surface, Surface::core);
    const Crossing far = next_crossing(r, {-1.0, 2.0, 0.0}, well, true);
    EXPECT_EQ(far.surface, Surface::edge_outward);
    EXPECT_NEAR(far.wait, 2 * 1.5 / 5.0, 1e-14);
    // Just outside after an escape.
    EXPECT_EQ(next_crossing(r, {1.0, 0.0, 0.0}, well, false).wait, never);
    // On the point of leaving or entering: now, never in the past.
    EXPECT_GE(next_crossing(r, {1.0, 0.0, 0.0}, well, true).wait, 0.0);
    EXPECT_LT(next_crossing(r, {1.0, 0.0, 0.0}, well, true).wait, 1e-15);
    EXPECT_GE(next_crossing(r, {-1.0, 0.0, 0.0}, well, false).wait, 0.0);
    EXPECT_LT(next_crossing(r, {-1.0, 0.0, 0.0}, well, false).wait, 1e-15);
  }
}

TEST(Crossing, GrazingChordInsideEndsAtTheClosestApproach) {
  // Outside by round-off and tangential: the discriminant is negative, the pair leaves at once.
  const Crossing out = next_crossing({1.5 + 2e-16, 0.0, 0.0}, {-1e-14, 1.0, 0.0}, well, true);
  EXPECT_EQ(out.surface, Surface::edge_outward);
  EXPECT_NEAR(out.wait, 1.5e-14, 1e-15);
}

// What an impulse cannot change any more is no event: the pair stands.
TEST(Crossing, SpeedsThatAreRoundOffAreNone) {
  const Vector3 touching{1.0 - 1e-16, 0.0, 0.0}, at_edge{1.5 + 2e-16, 0.0, 0.0};
  EXPECT_EQ(next_crossing(touching, {-5e-16, 0.0, 0.0}, bare, false).wait, never);
  EXPECT_EQ(next_crossing(touching, {-2e-15, 0.0, 0.0}, bare, false).wait, 0.0);
  EXPECT_EQ(next_crossing(touching, {-5e-16, 0.0, 0.0}, well, true).surface, Surface::edge_outward);
  EXPECT_EQ(next_crossing(at_edge, {5e-16, 0.0, 0.0}, well, true).wait, never);
  EXPECT_EQ(next_crossing(at_edge, {2e-15, 0.0, 0.0}, well, true).wait, 0.0);
  // Into the well there is always an impulse.
  EXPECT_EQ(next_crossing({1.5, 0.0, 0.0}, {-5e-16, 0.0, 0.0}, well, false).wait, 0.0);
}

TEST(Crossing, OverlappingCoresMeetNowOrPart) {
  EXPECT_EQ(next_crossing({0.9, 0.0, 0.0}, {-1.0, 0.0, 0.0}, bare, false).wait, 0.0);
  EXPECT_EQ(next_crossing({0.9, 0.0, 0.0}, {1.0, 0.0, 0.0}, bare, false).wait, never);
}

TEST(Crossing, Plane) {
  const MovingWall wall{{Wall::x_plane, 1.0, 2.0}, {{0.3, 0.0, 0.0}, {0.5, 0.0, 0.0}}, 0.0};
  // 0.4 before the end of the step the plane is at 2.3 - 0.2.
  const Crossing in = next_crossing(wall, {5.1, 0.0, 0.0}, {-1.0, 3.0, 0.0}, 0.4, well, false);
  EXPECT_NEAR(in.wait, 1.0, round_off);
  EXPECT_EQ(in.surface, Surface::edge_inward);
  const Crossing hit = next_crossing(wall, {5.1, 0.0, 0.0}, {-1.0, 3.0, 0.0}, 0.4, bare, false);
  EXPECT_NEAR(hit.wait, 2.0 / 1.5, round_off);
  const Crossing out = next_crossing(wall, {3.1, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.4, well, true);
  EXPECT_NEAR(out.wait, 1.0, round_off);
  EXPECT_EQ(out.surface, Surface::edge_outward);
  EXPECT_EQ(next_crossing(wall, {5.1, 0.0, 0.0}, {0.6, 0.0, 0.0}, 0.4, well, false).wait, never);
}

TEST(Crossing, CylinderFromInside) {
  const MovingWall wall{{Wall::z_cylinder, 1.0, 10.0}, {}, 0.0};
  const Vector3 x{3.0, -2.0, 1.0}, v{1.0, 0.5, 7.0};
  const auto from_axis = [&](const Vector3& at, double t) {
    return std::hypot(at.x + t * v.x, at.y + t * v.y);
  };
  const Crossing in = next_crossing(wall, x, v, 0.0, well, false);
  EXPECT_EQ(in.surface, Surface::edge_inward);
  EXPECT_NEAR(from_axis(x, in.wait), 8.5, 10 * round_off);
  const Crossing hit = next_crossing(wall, x, v, 0.0, bare, false);
  EXPECT_EQ(hit.surface, Surface::core);
  EXPECT_NEAR(from_axis(x, hit.wait), 9.0, 10 * round_off);
  // In the well: on its way inward it leaves, along the rim it hits.
  const Crossing out = next_crossing(wall, {-8.8, 0.0, 0.0}, v, 0.0, well, true);
  EXPECT_EQ(out.surface, Surface::edge_outward);
  EXPECT_NEAR(from_axis({-8.8, 0.0, 0.0}, out.wait), 8.5, 10 * round_off);
  EXPECT_EQ(next_crossing(wall, {-8.8, 0.0, 0.0}, {0.1, 1.0, 0.0}, 0.0, well, true).surface,
            Surface::core);
}

}  // namespace
