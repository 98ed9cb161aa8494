// SPDX-License-Identifier: BSD-3-Clause
#include "square_well/impulses.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace {

using namespace cohesion::square_well;

constexpr double mass_i = 2.0, mass_j = 5.0;
constexpr double b = 1.0 / mass_i + 1.0 / mass_j;
constexpr double mu = 1.0 / b;
constexpr double depth = 0.7;

/// Kinetic energy of the two after J less before, i moving with u against j at rest.
double energy_change(double u, double J) {
  const double vi = u - J / mass_i, vj = J / mass_j;
  return 0.5 * mass_i * (vi * vi - u * u) + 0.5 * mass_j * vj * vj;
}

// The energies are sums of terms of up to mu u^2, each rounded a few times by 1.1e-16 of itself.
double round_off(double u) { return 20 * 1.1e-16 * (mass_i * u * u + depth); }

TEST(SquareWell, ApproachGainsTheDepth) {
  for (const double u : {1e-9, 0.3, 1.0, 40.0, 0.0, -1e-3})
    EXPECT_NEAR(energy_change(u, approach_impulse(u, depth, b)), depth, round_off(u)) << u;
}

TEST(SquareWell, EscapeLosesTheDepth) {
  for (const double u : {-1.1, -2.0, -40.0}) {
    ASSERT_TRUE(escapes(u, depth, b));
    EXPECT_NEAR(energy_change(u, escape_impulse(u, depth, b)), -depth, round_off(u)) << u;
  }
}

TEST(SquareWell, CaptureTurnsThePairBackAndKeepsItsEnergy) {
  for (const double u : {-1e-9, -0.5, -0.98}) {
    ASSERT_FALSE(escapes(u, depth, b));
    const double J = capture_impulse(u, b);
    EXPECT_NEAR(energy_change(u, J), 0.0, round_off(u)) << u;
    EXPECT_NEAR(u - J * b, -u, 4e-16);
  }
}

TEST(SquareWell, ImpulsesAreThoseOfTheSource) {
  const double u = 0.8, out = -1.6;
  EXPECT_NEAR(approach_impulse(u, depth, b), mu * (u - std::sqrt(u * u + 2 * depth / mu)), 1e-15);
  EXPECT_NEAR(escape_impulse(out, depth, b), mu * (out + std::sqrt(out * out - 2 * depth / mu)),
              1e-15);
  EXPECT_NEAR(capture_impulse(-0.8, b), -2 * mu * 0.8, 1e-15);
}

// A fast pair hardly feels a shallow well; mu (u - sqrt(u^2 + ...)) would have lost all digits.
TEST(SquareWell, ShallowWellKeepsItsDigits) {
  const double u = 1e5, shallow = 1e-8;
  EXPECT_NEAR(approach_impulse(u, shallow, b) / (-shallow / u), 1.0, 1e-14);
  EXPECT_NEAR(escape_impulse(-u, shallow, b) / (-shallow / u), 1.0, 1e-14);
}

// v_esc^2 = (2D/mu)(1/e^2 - 1): head-on, in over the edge, hit with e, out over the edge.
TEST(SquareWell, EscapeVelocityOfAHeadOnPair) {
  const double e = 0.8, v_esc = std::sqrt(2 * depth * b * (1 / (e * e) - 1));
  for (const double share : {1 - 1e-12, 1 + 1e-12}) {
    double u = share * v_esc;
    u -= b * approach_impulse(u, depth, b);
    EXPECT_EQ(escapes(-e * u, depth, b), share > 1.0);
  }
}

}  // namespace
