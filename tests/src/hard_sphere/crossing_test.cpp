// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/crossing.h"
#include "hard_sphere/concave_wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <random>

#include "hard_sphere/concave_wall.h"
#include "hard_sphere/wall_crossing.h"

namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

constexpr SurfaceDistances well{1.0, 1.5};
constexpr SurfaceDistances bare{1.0, 1.0};
constexpr Vector3 still{};

/// For pairs with speeds of order 1.
Crossing next_crossing(const Vector3& r, const Vector3& w, const SurfaceDistances& surfaces,
                       bool inside) {
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

TEST(Crossing, NoneWhenSeparatingAtRestOrPassing) {
  EXPECT_EQ(next_crossing({3.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, well, false).wait, never);
  EXPECT_EQ(next_crossing({3.0, 0.0, 0.0}, still, well, false).wait, never);
  EXPECT_EQ(next_crossing({1.2, 0.0, 0.0}, still, well, true).wait, never);
  EXPECT_EQ(next_crossing({-3.0, 1.5000001, 0.0}, {1.0, 0.0, 0.0}, well, false).wait, never);
  EXPECT_LT(next_crossing({-3.0, 1.4999999, 0.0}, {1.0, 0.0, 0.0}, well, false).wait, 3.0);
}

// The flag shows which surface has been crossed, wherever round-off has put the pair.
TEST(Crossing, RoundOffAtASurfaceNeitherRepeatsNorMissesIt) {
  for (const double off : {-3e-16, 0.0, 3e-16}) {
    const Vector3 r{1.5 + off, 0.0, 0.0};
    // Just inside after an approach or a capture: next is the core or the far side.
    EXPECT_EQ(next_crossing(r, {-1.0, 0.0, 0.0}, well, true).surface, Surface::core);
    const Crossing far = next_crossing(r, {-1.0, 2.0, 0.0}, well, true);
    EXPECT_EQ(far.surface, Surface::edge_outward);
    EXPECT_NEAR(far.wait, 2 * 1.5 / 5.0, 1e-14);
    // Just outside after an escape.
    EXPECT_EQ(next_crossing(r, {1.0, 0.0, 0.0}, well, false).wait, never);
    // About to leave or enter: now, never in the past.
    EXPECT_GE(next_crossing(r, {1.0, 0.0, 0.0}, well, true).wait, 0.0);
    EXPECT_LT(next_crossing(r, {1.0, 0.0, 0.0}, well, true).wait, 1e-15);
    EXPECT_GE(next_crossing(r, {-1.0, 0.0, 0.0}, well, false).wait, 0.0);
    EXPECT_LT(next_crossing(r, {-1.0, 0.0, 0.0}, well, false).wait, 1e-15);
  }
}

TEST(Crossing, GrazingChordInsideEndsAtTheClosestApproach) {
  // Outside by round-off and tangential: the discriminant is negative. The pair leaves as soon as
  // it separates by more than round-off, 2.25e-15 here.
  const Crossing out = next_crossing({1.5 + 2e-16, 0.0, 0.0}, {-1e-14, 1.0, 0.0}, well, true);
  EXPECT_EQ(out.surface, Surface::edge_outward);
  EXPECT_NEAR(out.wait, 1.5e-14 + 2.25e-15, 1e-16);
  const Crossing along = next_crossing({1.5 + 2e-16, 0.0, 0.0}, {0.0, 1.0, 0.0}, well, true);
  EXPECT_EQ(along.surface, Surface::edge_outward);
  EXPECT_NEAR(along.wait, 2.25e-15, 1e-16);
}

// With a slower reflection at the edge the chord of the pair would stay beyond the edge, and the
// pair would drift farther out at every capture.
TEST(Crossing, CaptureReturnsThePairWithinTheEdge) {
  for (const double beyond : {-1e-15, 0.0, 1e-15, 1e-9})
    for (const double speed : {0.0, 1e-12, 1e-3}) {
      const double distance = well.edge * (1.0 + beyond);
      const Vector3 r{0.0, distance, 0.0}, w{0.8, -speed, 0.6};
      const Vector3 turned = velocity_within_edge(w, {0.0, 1.0, 0.0}, distance, well.edge);
      EXPECT_NEAR(norm(turned), norm(w), 1e-15);
      // The closest point of the chord.
      EXPECT_LT(norm(cross(r, turned)) / norm(turned), well.edge);
      if (speed > 1e-4 && beyond < 1e-8) {
        EXPECT_EQ(norm(turned - w), 0.0);
      }
    }
}

// If an impulse is too small to change the velocities there is no event: the pair is at rest.
TEST(Crossing, RoundOffSpeedsCauseNoCrossing) {
  const Vector3 touching{1.0 - 1e-16, 0.0, 0.0}, at_edge{1.5 + 2e-16, 0.0, 0.0};
  EXPECT_EQ(next_crossing(touching, {-5e-16, 0.0, 0.0}, bare, false).wait, never);
  EXPECT_EQ(next_crossing(touching, {-2e-15, 0.0, 0.0}, bare, false).wait, 0.0);
  EXPECT_EQ(next_crossing(touching, {-5e-16, 0.0, 0.0}, well, true).surface, Surface::edge_outward);
  EXPECT_EQ(next_crossing(at_edge, {5e-16, 0.0, 0.0}, well, true).wait, never);
  EXPECT_EQ(next_crossing(at_edge, {2e-15, 0.0, 0.0}, well, true).wait, 0.0);
  // At the entry of a well there is always an impulse.
  EXPECT_EQ(next_crossing({1.5, 0.0, 0.0}, {-5e-16, 0.0, 0.0}, well, false).wait, 0.0);
}

TEST(Crossing, OverlappingCoresCollideNowOrSeparate) {
  EXPECT_EQ(next_crossing({0.9, 0.0, 0.0}, {-1.0, 0.0, 0.0}, bare, false).wait, 0.0);
  EXPECT_EQ(next_crossing({0.9, 0.0, 0.0}, {1.0, 0.0, 0.0}, bare, false).wait, never);
}

TEST(Crossing, Plane) {
  const MovingWall wall{
      {Wall::x_plane, 1.0, 2.0}, {{0.3, 0.0, 0.0}, {0.5, 0.0, 0.0}}, 0.0, /*when=*/1.0};
  // The plane is at 2.3 at the time 1, and at 2.3 - 0.2 0.4 earlier.
  const Crossing in = next_crossing(wall, {5.1, 0.0, 0.0}, {-1.0, 3.0, 0.0}, 0.6, well, false);
  EXPECT_NEAR(in.wait, 1.0, round_off);
  EXPECT_EQ(in.surface, Surface::edge_inward);
  const Crossing hit = next_crossing(wall, {5.1, 0.0, 0.0}, {-1.0, 3.0, 0.0}, 0.6, bare, false);
  EXPECT_NEAR(hit.wait, 2.0 / 1.5, round_off);
  const Crossing out = next_crossing(wall, {3.1, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.6, well, true);
  EXPECT_NEAR(out.wait, 1.0, round_off);
  EXPECT_EQ(out.surface, Surface::edge_outward);
  EXPECT_EQ(next_crossing(wall, {5.1, 0.0, 0.0}, {0.6, 0.0, 0.0}, 0.6, well, false).wait, never);
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
  // In the well: on its way inward the particle leaves it, along the wall it collides.
  const Crossing out = next_crossing(wall, {-8.8, 0.0, 0.0}, v, 0.0, well, true);
  EXPECT_EQ(out.surface, Surface::edge_outward);
  EXPECT_NEAR(from_axis({-8.8, 0.0, 0.0}, out.wait), 8.5, 10 * round_off);
  EXPECT_EQ(next_crossing(wall, {-8.8, 0.0, 0.0}, {0.1, 1.0, 0.0}, 0.0, well, true).surface,
            Surface::core);
}

/// Pairs of all kinds: far and near, at their surfaces to round-off, slow and fast, and grazing a
/// surface within a fraction down to round-off.
struct RandomPair {
  Vector3 r, w;
  SurfaceDistances surfaces;
  bool inside;
  double vv;

  explicit RandomPair(std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    const auto direction = [&] {
      const Vector3 v{normal(random), normal(random), normal(random)};
      return (1.0 / norm(v)) * v;
    };
    const auto small = [&] { return std::pow(10.0, -16.0 * uniform(random)); };
    const auto sign = [&] { return random() % 2 ? 1.0 : -1.0; };
    surfaces = {1.0, random() % 3 ? 1.0 + 2.0 * uniform(random) : 1.0};
    inside = surfaces.has_well() && random() % 2;
    const double edge = inside ? surfaces.edge : 10.0 * surfaces.edge;
    double distance = surfaces.core + (edge - surfaces.core) * uniform(random);
    if (random() % 4 == 0) distance = surfaces.core * (1.0 + sign() * small());
    if (random() % 4 == 0) distance = surfaces.edge * (1.0 + sign() * small());
    r = distance * direction();
    w = direction();
    if (random() % 2) {
      const Vector3 across = cross(r, w);
      const double nearest =
          (random() % 2 ? surfaces.core : surfaces.edge) * (1.0 + sign() * small());
      const double sine = std::min(nearest / distance, 1.0);
      const Vector3 along = (1.0 / distance) * r, sideways = cross(along, across);
      w = (sine / norm(sideways)) * sideways + sign() * std::sqrt(1.0 - sine * sine) * along;
    }
    w = std::pow(10.0, 6.0 * uniform(random) - 3.0) * w;
    vv = dot(w, w) * (random() % 2 ? 1.0 : 1.0 / small());
  }
};

// The test may predict a crossing that does not occur. It must not miss one, nor with surfaces in
// single precision.
TEST(Crossing, NegativePreselectionMeansNoCrossing) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform;
  int nothing = 0, crossings = 0;
  for (int n = 0; n < 300000; n++) {
    const RandomPair pair(random);
    const Crossing next =
        cohesion::hard_sphere::next_crossing(pair.r, pair.w, pair.vv, pair.surfaces, pair.inside);
    const double b = dot(pair.r, pair.w), ww = dot(pair.w, pair.w), rr = dot(pair.r, pair.r);
    const bool crosses = next.wait < never;
    const double flight = crosses ? next.wait : 10.0 * norm(pair.r) / norm(pair.w);
    const double times[] = {flight,
                            flight * std::pow(10.0, 4.0 * uniform(random) - 2.0),
                            flight * (1.0 + std::pow(10.0, -16.0 * uniform(random))),
                            flight * (1.0 - std::pow(10.0, -16.0 * uniform(random))),
                            0.0,
                            never};
    const SurfaceDistances rounded{static_cast<float>(pair.surfaces.core),
                                   static_cast<float>(pair.surfaces.edge)};
    crossings += crosses;
    for (const double left : times) {
      if (may_cross_within(left, b, ww, rr, pair.surfaces, pair.inside) &&
          may_cross_within(left, b, ww, rr, rounded, pair.inside))
        continue;
      nothing++;
      ASSERT_TRUE(next.wait > left || !crosses) << n << " b " << b << " ww " << ww << " rr " << rr;
    }
  }
  EXPECT_GT(crossings, 150000);
  EXPECT_GT(nothing, 150000);
}

// A pair at rest has no crossing, also in a well, and the test raises no floating-point exception.
TEST(Crossing, PairsAtRestHaveNoCrossing) {
  std::feclearexcept(FE_ALL_EXCEPT);
  for (volatile double left : {0.0, 1.0, never}) {
    EXPECT_FALSE(may_cross_within(left, 0.0, 0.0, 1.44, bare, false));
    EXPECT_FALSE(may_cross_within(left, 0.0, 0.0, 4.0, well, false));
    EXPECT_FALSE(may_cross_within(left, 0.0, 0.0, 1.44, well, true));
  }
  EXPECT_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
}

}  // namespace
