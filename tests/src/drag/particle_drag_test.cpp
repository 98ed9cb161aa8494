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
  // x just below and above 1e-4, where the series takes over: whose error is far below rounding.
  const double below = ParticleDrag(0.99999999e-4, 1.0, 1.0).force(0.0, 1.0);
  const double above = ParticleDrag(1.00000001e-4, 1.0, 1.0).force(0.0, 1.0);
  EXPECT_NEAR(above - below, -0.5 * 2e-12, 1e-13);
}

TEST(ParticleDrag, KeepsItsDigitsForShortSteps) {
  for (const double x : {1e-12, 1e-8, 1e-5, 0.99999e-4, 1.00001e-4, 1e-3}) {
    // phi - 1 by its alternating series in long double; the first omitted term is x^6/5040.
    const long double y = x;
    const long double expected = -y / 2 * (1 - y / 3 * (1 - y / 4 * (1 - y / 5 * (1 - y / 6))));
    // Below the switch the law's series ends after its third term: the next is x^3/60 of the first.
    // Above, phi - 1 is a difference of numbers near 1: a few 2e-16 over x/2.
    const double tolerance = x < 1e-4 ? 2e-14 : 1e-15 / (x / 2);
    EXPECT_NEAR(ParticleDrag(x, 1.0, 1.0).force(0.0, 1.0) / double(expected), 1.0, tolerance) << x;
  }
}

TEST(ParticleDrag, NeverTurnsTheSlipRound) {
  for (const double x : {0.1, 1.0, 10.0, 1e6}) {
    const double left = 1.0 - ParticleDrag(x, 1.0, 1.0).force(1.0, 0.0);  // of a slip of 1
    EXPECT_NEAR(left, std::exp(-x), 1e-15) << x;  // one subtraction of numbers up to 1
  }
}

TEST(ParticleDrag, HoldsTheTerminalVelocity) {
  // At v_inf drag and weight cancel, whatever the step.
  const double b = 0.7, mass = 0.2, weight = -3.0;
  for (const double dt : {1e-6, 1.0, 1e3}) {
    const double f = ParticleDrag(b, mass, dt).force(-weight / b, weight);
    EXPECT_NEAR(f, -weight, 1e-14 * 3.0) << dt;
  }
}

TEST(ParticleDrag, IsTheSameFromTheStartAndFromTheMiddle) {
  const double mass = 3.0, gas = 1.5, weight = -29.0, v0 = -0.4;
  for (const double x : {0.0, 1e-12, 1e-5, 1e-3, 1.0, 50.0}) {
    const ParticleDrag drag(x * mass, mass, 1.0);
    const double f = drag.force(gas - v0, weight);
    const double middle = v0 + 0.5 * (f + weight) / mass;
    // A few roundings of the forces, and of the middle velocity times b.
    const double rounding = 1e-15 * (std::abs(f) + std::abs(weight) + x * mass * std::abs(middle));
    EXPECT_NEAR(drag.force_about(gas - middle, weight), f, 4.0 * rounding) << x;
  }
}

TEST(ParticleDrag, WithoutGasThereIsNoForce) {
  EXPECT_EQ(ParticleDrag(0.0, 1.0, 1.0).force(5.0, 7.0), 0.0);
}

TEST(ParticleDrag, PressureForcePushesDownTheGradient) {
  EXPECT_DOUBLE_EQ(pressure_force(2.0, 3.0), -6.0);
}

}  // namespace cohesion::drag
