// SPDX-License-Identifier: BSD-3-Clause
#include "contact/adhesion.h"

#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

#include "hamaker/law.h"
#include "hamaker/small_gap.h"

namespace cohesion::contact {

TEST(Adhesion, IsTheLawsForceAtTheCutOffAndItsTailEnergy) {
  const hamaker::HamakerLaw<hamaker::SmallGap> law({5e-19, 4e-10, 1e-7});
  const PairGeometry geometry = two_spheres(0.5e-3, 0.5e-3);
  const Adhesion a = adhesion_of(law, geometry);
  // F = A r/(12 H^2), energy F H (1 - H_cut/H_out); a few roundings.
  const double force = 5e-19 * 0.5e-3 / (12.0 * 4e-10 * 4e-10);
  EXPECT_NEAR(a.force / force, 1.0, 1e-14);
  EXPECT_EQ(a.cutoff, 4e-10);
  EXPECT_NEAR(a.tail_energy / (force * 4e-10 * (1.0 - 4e-10 / 1e-7)), 1.0, 1e-13);
}

TEST(Adhesion, PointsToTheLawOnlyForASolver) {
  using Law = hamaker::HamakerLaw<hamaker::SmallGap>;
  const Law law({5e-19, 4e-10, 1e-7}), none({0.0, 4e-10, 1e-7});
  const PairGeometry geometry = two_spheres(0.5e-3, 0.5e-3);
  const Adhesion closed = adhesion_of(law, geometry), solver = adhesion_with_tail(law, geometry);
  EXPECT_EQ(closed.tail, nullptr);
  EXPECT_EQ(solver.tail, &law);
  EXPECT_EQ(solver.force, closed.force);
  EXPECT_EQ(solver.tail_energy, closed.tail_energy);
  EXPECT_EQ(adhesion_with_tail(none, geometry).tail, nullptr);
}

/// A temporary law cannot be pointed to.
template <class Law, class = void>
constexpr bool gives_tail = false;
template <class Law>
constexpr bool gives_tail<
    Law, std::void_t<decltype(adhesion_with_tail(std::declval<Law>(), PairGeometry{}))>> = true;
using SmallGapLaw = hamaker::HamakerLaw<hamaker::SmallGap>;
static_assert(gives_tail<const SmallGapLaw&>);
static_assert(!gives_tail<SmallGapLaw>);
static_assert(!gives_tail<const SmallGapLaw>);

TEST(Adhesion, HasNoRangeWithoutForce) {
  const hamaker::HamakerLaw<hamaker::SmallGap> law({0.0, 4e-10, 1e-7});
  const Adhesion a = adhesion_of(law, two_spheres(0.5e-3, 0.5e-3));
  EXPECT_EQ(a.force, 0.0);
  EXPECT_EQ(a.cutoff, 0.0);
  EXPECT_EQ(a.tail_energy, 0.0);
}

}  // namespace cohesion::contact
