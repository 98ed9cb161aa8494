// SPDX-License-Identifier: BSD-3-Clause
#include "hamaker/range_of_validity.h"

#include <gtest/gtest.h>

#include "../refuses.h"

namespace cohesion::hamaker {

const Form& small_gap = forms[0];
const Form& exact = forms[1];

TEST(RangeOfValidity, SmallGapIsTooStrongByGapOverReducedRadius) {
  const PairGeometry g = two_spheres(2.0, 2.0);
  const HamakerParameters p{1.0, 1e-3, 1.0};
  // Where the limits stand: a tenth too much, and at least as much again as there is.
  const double at_surface_limit = small_gap.largest_surface_cutoff * g.reduced_radius;
  EXPECT_NEAR(SmallGap(p).force(at_surface_limit, g) / Exact(p).force(at_surface_limit, g), 1.1,
              0.02);
  const double at_outer_limit = small_gap.largest_outer_cutoff * g.reduced_radius;
  EXPECT_GT(SmallGap(p).force(at_outer_limit, g) / Exact(p).force(at_outer_limit, g), 2.0);
}

TEST(RangeOfValidity, CutOffsFarBelowTheRadius) {
  const PairGeometry g = two_spheres(2.0, 2.0);  // R* = 1
  EXPECT_NO_THROW(require_far_below_radius(small_gap, {1.0, 0.1, 1.0}, g));
  expect_refused([&] { require_far_below_radius(small_gap, {1.0, 0.11, 1.0}, g); },
                 "surface cut-off H_cut = 0.11: must not be above 0.1");
  expect_refused([&] { require_far_below_radius(small_gap, {1.0, 0.1, 1.1}, g); },
                 "outer cut-off H_out = 1.1: must not be above 1");
  EXPECT_NO_THROW(require_far_below_radius(exact, {1.0, 1.0, 10.0}, g));
  expect_refused([&] { require_far_below_radius(exact, {1.0, 1.1, 10.0}, g); }, "form exact");
  expect_refused([&] { require_far_below_radius(exact, {1.0, 1.0, 11.0}, g); }, "H_out = 11");
  // 1.5e-5 in the last digit above the reduced radius, as it comes out.
  const PairGeometry of_60_um = two_spheres(0.5 * 60e-6, 0.5 * 60e-6);
  EXPECT_NO_THROW(require_far_below_radius(small_gap, {5e-19, 4e-10, 1.5e-5}, of_60_um));
  EXPECT_NO_THROW(require_far_below_radius(small_gap, {0.0, 0.4, 100.0}, g));
  EXPECT_NO_THROW(require_far_below_radius(small_gap, {1.0, 0.1, 1.9}, sphere_and_plane(2.0)));
}

}  // namespace cohesion::hamaker
