// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/energy_sums.h"

#include <gtest/gtest.h>

namespace cohesion::contact_solver {
namespace {

/// What two processes have of a pair is half of it each; what is lost after the time level counts
/// with the next one.
TEST(EnergySums, LossesCountWhenTheirTimeHasCome) {
  EnergySums sums;
  ContactEnergies energies;
  energies.stored = {1.0, 2.0, 3.0, -4.0, 0.5};
  energies.before = {0.1, 0.2, 0.3};
  energies.after = {0.01, 0.02, 0.03};
  energies.exchanged = 0.25;
  for (const double fraction : {0.5, 0.5}) {
    sums.store(fraction, energies.stored);
    sums.lose(fraction, energies);
  }
  EXPECT_DOUBLE_EQ(sums.stored().spring, 1.0);
  EXPECT_DOUBLE_EQ(sums.stored().tangential_spring, 2.0);
  EXPECT_DOUBLE_EQ(sums.stored().rolling_spring, 3.0);
  EXPECT_DOUBLE_EQ(sums.stored().adhesion, -4.0);
  EXPECT_DOUBLE_EQ(sums.stored().load, 0.5);
  EXPECT_DOUBLE_EQ(sums.exchanged(), 0.25);
  EXPECT_DOUBLE_EQ(sums.lost().normal_damping, 0.1);
  EXPECT_DOUBLE_EQ(sums.lost().tangential_damping, 0.2);
  EXPECT_DOUBLE_EQ(sums.lost().rolling, 0.3);
  sums.begin_step();
  EXPECT_DOUBLE_EQ(sums.lost().normal_damping, 0.11);
  EXPECT_DOUBLE_EQ(sums.lost().tangential_damping, 0.22);
  EXPECT_DOUBLE_EQ(sums.lost().rolling, 0.33);
  EXPECT_EQ(sums.stored().spring, 0.0);
  EXPECT_DOUBLE_EQ(sums.exchanged(), 0.25);
}

}  // namespace
}  // namespace cohesion::contact_solver
