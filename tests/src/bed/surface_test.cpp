// SPDX-License-Identifier: BSD-3-Clause
#include "bed/surface.h"

#include <gtest/gtest.h>

using cohesion::bed::surface_height;

namespace {

constexpr double round_off = 1e-15;  // a few operations on numbers below 1

// Layers of 0.1 from 0.05 on; a bed of two, at half the change.
TEST(SurfaceHeight, OfWholeLayersIsTheirUpperFaceAtHalfTheChange) {
  EXPECT_NEAR(surface_height({0.4, 0.4, 1.0, 1.0}, 0.05, 0.1, 0.7), 0.25, round_off);
}

TEST(SurfaceHeight, IsLinearBetweenMiddles) {
  // Middles of the second and the third layer: 0.2 and 0.3; a quarter of the way from 0.5 to 0.9
  EXPECT_NEAR(surface_height({0.4, 0.5, 0.9, 1.0}, 0.05, 0.1, 0.6), 0.225, round_off);
}

TEST(SurfaceHeight, IsTheHighestWhereLayersAboveABubbleAreDense) {
  EXPECT_NEAR(surface_height({0.4, 0.9, 0.4, 1.0}, 0.0, 0.1, 0.7), 0.3, round_off);
}

TEST(SurfaceHeight, IsBottomOrTopWhereNothingOrAllIsDense) {
  EXPECT_EQ(surface_height({0.9, 0.9}, 0.05, 0.1, 0.7), 0.05);
  EXPECT_NEAR(surface_height({0.9, 0.4}, 0.05, 0.1, 0.7), 0.25, round_off);
}

TEST(SurfaceHeight, ALayerAtTheLimitIsAbove) {
  EXPECT_NEAR(surface_height({0.4, 0.7}, 0.0, 0.1, 0.7), 0.15, round_off);
}

}  // namespace
