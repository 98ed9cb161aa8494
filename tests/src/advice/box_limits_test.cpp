// SPDX-License-Identifier: BSD-3-Clause
#include "advice/box_limits.h"

#include <gtest/gtest.h>

#include "../refuses.h"

namespace cohesion::advice {

TEST(BoxLimits, RadiusUpToTheLongestSide) {
  const BoxSize box{{1.0, 4.0, 2.0}, {true, false, false}};
  EXPECT_NO_THROW(require_radius_in_box(4.0, box));
  EXPECT_NO_THROW(require_radius_in_box(4.5, {{1.0, 4.0, 2.0}, {true, false, false}, true}));
  expect_refused([&] { require_radius_in_box(4.5, box); },
                 "radius of a particle = 4.5: must not be above the longest side of the box, 4");
}

TEST(BoxLimits, ImagesAreThoseOfPeriodicDirections) {
  EXPECT_EQ(images_within(2.5, {{1.0, 1.0, 1.0}, {false, false, false}}), 1.0);
  EXPECT_EQ(images_within(2.5, {{1.0, 3.0, 1.0}, {true, true, false}}), 7.0 * 3.0);
  EXPECT_EQ(images_within(1.0, {{1.0, 1.0, 1.0}, {true, true, true}}), 27.0);
}

TEST(BoxLimits, RangeUpToFourBoxesInThreeDirections) {
  const BoxSize cube{{1.0, 1.0, 1.0}, {true, true, true}};
  EXPECT_NO_THROW(require_range_in_box(4.0, cube));
  expect_refused([&] { require_range_in_box(4.5, cube); },
                 "range of radii and attraction = 4.5: would find 1331 images of each particle in "
                 "the periodic box of 1 x 1 x 1");
  const BoxSize thin{{1.0, 1000.0, 1000.0}, {true, true, true}};
  EXPECT_NO_THROW(require_range_in_box(50.0, thin));
}

}  // namespace cohesion::advice
