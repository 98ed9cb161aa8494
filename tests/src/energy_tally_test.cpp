// SPDX-License-Identifier: BSD-3-Clause
#include "energy_tally.h"

#include <gtest/gtest.h>

namespace cohesion::energy_tally {

TEST(EnergyTally, EachEntryIsStoredLostOrPutIn) {
  double entries[ENTRIES];
  for (int k = 0; k < ENTRIES; k++) entries[k] = static_cast<double>(1 << k);
  entries[RESIDUAL] = 0.0;
  double all = 0.0;
  for (int k = 0; k < ENTRIES; k++)
    if (k != RESIDUAL) all += k == EXTERNAL_WORK ? -entries[k] : entries[k];
  EXPECT_EQ(balance(entries), all);
  EXPECT_EQ(stored(entries), 1.0 + 2.0 + 4.0 + 8.0 + 16.0 + 1024.0 + 2048.0);
}

TEST(EnergyTally, ResidualIsWhatIsMissingSinceItsBegin) {
  double entries[ENTRIES] = {};
  entries[KINETIC] = 5.0;
  Residual residual;
  residual.update(entries);
  EXPECT_EQ(entries[RESIDUAL], 0.0);
  entries[KINETIC] = 2.0;
  entries[FRICTION] = 2.0;
  entries[EXTERNAL_WORK] = 0.5;
  residual.update(entries);
  EXPECT_EQ(entries[RESIDUAL], -1.5);
}

TEST(EnergyTally, WhatCameBetweenRunsWasPutIn) {
  double entries[ENTRIES] = {};
  entries[KINETIC] = 5.0;
  Residual residual;
  residual.update(entries);
  entries[KINETIC] = 4.5;
  residual.end_run(entries);
  for (const double put_in : {2.0, 0.5}) {
    entries[EXTERNAL_WORK] = 0.0;
    entries[SPRING] += put_in;
    EXPECT_EQ(residual.update_after_change(entries), put_in);
    EXPECT_EQ(entries[EXTERNAL_WORK], entries[SPRING]);
    EXPECT_EQ(entries[RESIDUAL], -0.5);
    entries[EXTERNAL_WORK] = 0.0;
    residual.end_run(entries);
    EXPECT_EQ(entries[RESIDUAL], -0.5);
  }
}

TEST(EnergyTally, ABodyHasItsMotionAndItsWeight) {
  double entries[ENTRIES] = {};
  for (int bodies = 1; bodies <= 2; bodies++) {
    // All numbers and sums are exact in binary.
    add_body(entries, 2.0, 0.5, {1.0, -2.0, 2.0}, {0.0, 4.0, 0.0}, {0.0, 0.0, -16.0},
             {3.0, 5.0, 0.25});
    EXPECT_EQ(entries[KINETIC], 9.0 * bodies);
    EXPECT_EQ(entries[ROTATIONAL], 4.0 * bodies);
    EXPECT_EQ(entries[GRAVITY], 4.0 * bodies);
  }
}

}  // namespace cohesion::energy_tally
