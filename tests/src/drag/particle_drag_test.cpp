// SPDX-License-Identifier: BSD-3-Clause
#include "drag/particle_drag.h"

#include <gtest/gtest.h>

namespace cohesion::drag {

TEST(ParticleDrag, ReproducesTheExactVelocityAtAnyStep) {
  const double b = 2.0, mass = 3.0, gas = 1.5, weight = -29.0;
  for (const double dt : {1e-7, 1e-3, 0.5, 1e4}) {
    const double v0 = -0.4;
    const double f = ParticleDrag(b, mass, dt).force(gas - v0, weight);
    const double v1 = v0 + (f + weight) / mass * dt;
    const double v_inf = gas + weight / b;
    // Rounding of v0 + dt (f + F)/m: relative to the largest of the velocities, times dt b/m when
    // drag and weight cancel over a long step.
    const double exact = v_inf + (v0 - v_inf) * std::exp(-b * dt / mass);
    EXPECT_NEAR(v1, exact, 1e-15 * 15.0 * (1.0 + b * dt / mass)) << dt;
  }
}

TEST(ParticleDrag, SmallAndLargeBranchesOfPhiMeet) {
  // x just below and above 1e-4, where the series takes over: its next term is x^3/24 = 4e-14.
  const double below = ParticleDrag(0.99999999e-4, 1.0, 1.0).force(0.0, 1.0);
  const double above = ParticleDrag(1.00000001e-4, 1.0, 1.0).force(0.0, 1.0);
  EXPECT_NEAR(above - below, -0.5 * 2e-12, 1e-13);
}

TEST(ParticleDrag, HoldsTheTerminalVelocity) {
  // At v_inf drag and weight cancel, whatever the step.
  const double b = 0.7, mass = 0.2, weight = -3.0;
  for (const double dt : {1e-6, 1.0, 1e3}) {
    const double f = ParticleDrag(b, mass, dt).force(-weight / b, weight);
    EXPECT_NEAR(f, -weight, 1e-14 * 3.0) << dt;
  }
}

TEST(ParticleDrag, WithoutGasThereIsNoForce) {
  EXPECT_EQ(ParticleDrag(0.0, 1.0, 1.0).force(5.0, 7.0), 0.0);
}

TEST(ParticleDrag, PressureForcePushesDownTheGradient) {
  EXPECT_DOUBLE_EQ(pressure_force(2.0, 3.0), -6.0);
}

}  // namespace cohesion::drag
