// SPDX-License-Identifier: BSD-3-Clause
#include "void_fraction/box_bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "box_cell.h"

namespace cohesion::void_fraction {

namespace {

std::vector<int> meeting(const BoxBins& bins, const Box& around) {
  std::vector<int> found;
  bins.meeting(around, found);
  return found;
}

/// By comparison with every box.
std::vector<int> all_meeting(const std::vector<Box>& boxes, const Box& around) {
  std::vector<int> found;
  for (std::size_t n = 0; n < boxes.size(); n++) {
    bool meets = true;
    for (double Vector3::* c : {&Vector3::x, &Vector3::y, &Vector3::z})
      meets = meets && boxes[n].low.*c <= around.high.*c && around.low.*c <= boxes[n].high.*c;
    if (meets) found.push_back(static_cast<int>(n));
  }
  return found;
}

/// Boxes between planes; the planes of z may be at infinity.
std::vector<Box> grid(const std::vector<double>& x, const std::vector<double>& y,
                      const std::vector<double>& z) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i + 1 < x.size(); i++)
    for (std::size_t j = 0; j + 1 < y.size(); j++)
      for (std::size_t k = 0; k + 1 < z.size(); k++)
        boxes.push_back({{x[i], y[j], z[k]}, {x[i + 1], y[j + 1], z[k + 1]}});
  return boxes;
}

std::vector<double> planes(double from, double to, int cells, double growth = 1.0) {
  std::vector<double> found{0.0};
  double side = 1.0;
  for (int n = 0; n < cells; n++, side *= growth) found.push_back(found.back() + side);
  for (double& plane : found) plane = from + (to - from) * plane / found.back();
  return found;
}

/// Regions of all sizes in and beyond the boxes' surroundings, and such whose sides lie on those of
/// boxes: what the bins find is what comparison with every box finds.
void expect_all_found(const std::vector<Box>& boxes, const Box& surroundings) {
  const BoxBins bins(boxes);
  std::mt19937 random(815);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Vector3 span = surroundings.high - surroundings.low;
  for (int trial = 0; trial < 2000; trial++) {
    const double size = trial % 5 == 0 ? 0.0 : std::pow(10.0, -4.0 * uniform(random));
    Box around;
    for (double Vector3::* c : {&Vector3::x, &Vector3::y, &Vector3::z}) {
      around.low.*c = surroundings.low.*c + (1.4 * uniform(random) - 0.2) * span.*c;
      around.high.*c = around.low.*c + size * span.*c;
      const Box& some = boxes[random() % boxes.size()];
      if (trial % 2 == 0 && std::isfinite(some.low.*c)) {
        around.low.*c = some.high.*c;
        around.high.*c = std::max(around.high.*c, some.high.*c);
      }
    }
    ASSERT_EQ(meeting(bins, around), all_meeting(boxes, around)) << trial;
  }
}

}  // namespace

TEST(BoxBins, FindAllBoxesOfARegularGrid) {
  expect_all_found(grid(planes(-1.0, 2.0, 7), planes(3.0, 3.7, 11), planes(0.0, 1.0, 5)),
                   {{-1.0, 3.0, 0.0}, {2.0, 3.7, 1.0}});
}

TEST(BoxBins, FindAllBoxesOfAGradedGrid) {
  // Sides in a ratio of 1 to 130
  expect_all_found(grid(planes(0.0, 1.0, 11, 1.5), planes(0.0, 1.0, 12, 0.65), planes(0.0, 2.0, 3)),
                   {{0.0, 0.0, 0.0}, {1.0, 1.0, 2.0}});
}

TEST(BoxBins, FindAllBoxesOfAPlaneGrid) {
  expect_all_found(grid(planes(0.0, 1.0, 9), planes(0.0, 1.0, 14), {-infinity, infinity}),
                   {{0.0, 0.0, -1.0}, {1.0, 1.0, 1.0}});
}

TEST(BoxBins, FindAllBoxesThatOverlapAndLeaveGaps) {
  // Along a diagonal: most of the space around them is empty.
  std::mt19937 random(99);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Box> boxes;
  for (int n = 0; n < 200; n++) {
    const double at = uniform(random);
    const Vector3 low{at, at, at};
    boxes.push_back({low, low + 0.01 * Vector3{uniform(random), uniform(random), uniform(random)}});
  }
  expect_all_found(boxes, {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}});
}

TEST(BoxBins, FindTheOnlyBoxAndNoneOfNone) {
  const BoxBins one(std::vector<Box>{{{0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}}});
  EXPECT_EQ(meeting(one, {{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}}), std::vector<int>{0});
  EXPECT_TRUE(meeting(one, {{1.1, 0.0, 0.0}, {9.0, 2.0, 3.0}}).empty());
  EXPECT_TRUE(meeting(BoxBins(std::vector<Box>{}), {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}).empty());
}

}  // namespace cohesion::void_fraction
