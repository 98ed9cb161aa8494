// SPDX-License-Identifier: BSD-3-Clause
#include "hamaker/tail.h"

#include <gtest/gtest.h>

#include "hamaker/law.h"
#include "hamaker/small_gap.h"

namespace cohesion::hamaker {

const PairGeometry geometry = two_spheres(0.5e-3, 0.5e-3);

TEST(HamakerAdhesion, IsTheLawsForceAtTheCutOffAndItsTailEnergy) {
  const HamakerLaw<SmallGap> law({5e-19, 4e-10, 1e-7});
  const contact::Adhesion a = adhesion_of(law, geometry);
  // F = A r/(12 H^2), energy F H (1 - H_cut/H_out); a few roundings.
  const double force = 5e-19 * 0.5e-3 / (12.0 * 4e-10 * 4e-10);
  EXPECT_NEAR(a.force / force, 1.0, 1e-14);
  EXPECT_EQ(a.cutoff, 4e-10);
  EXPECT_NEAR(a.tail_energy / (force * 4e-10 * (1.0 - 4e-10 / 1e-7)), 1.0, 1e-13);
}

TEST(HamakerAdhesion, HasTheTailOfTheLaw) {
  const HamakerLaw<SmallGap> law({5e-19, 4e-10, 1e-7});
  const contact::Adhesion a = adhesion_of(law, geometry);
  ASSERT_TRUE(a.tail);
  const double gap = 6e-10, load = 0.1 * a.force;
  EXPECT_EQ(a.tail->barrier(load, gap), law.barrier(load, gap, geometry));
  EXPECT_EQ(a.tail->work_up_to(gap), law.energy(gap, geometry) + law.tail_energy(geometry));
  EXPECT_TRUE(a.tail->contains(1e-7));
  EXPECT_FALSE(a.tail->contains(1.001e-7));
}

TEST(HamakerAdhesion, HasNoRangeWithoutForce) {
  const HamakerLaw<SmallGap> law({0.0, 4e-10, 1e-7});
  const contact::Adhesion a = adhesion_of(law, geometry);
  EXPECT_EQ(a.force, 0.0);
  EXPECT_EQ(a.cutoff, 0.0);
  EXPECT_EQ(a.tail_energy, 0.0);
  EXPECT_FALSE(a.tail);
}

}  // namespace cohesion::hamaker
