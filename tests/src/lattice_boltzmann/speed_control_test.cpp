// SPDX-License-Identifier: BSD-3-Clause
#include "lattice_boltzmann/speed_control.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cohesion::lattice_boltzmann {

// A flow on paper, V dU/dt = g V_fluid - lambda V U: weakly and strongly held. The slowest, of
// lambda 1, loses 1/40 of its error each 20 steps: 10000 steps leave 3e-6 of it.
TEST(SpeedControl, LeadsToTheSpeed) {
  for (const double lambda : {0.001, 0.5, 1.0}) {
    const double volume = 1000.0, fluid = 600.0, asked = 0.02;
    SpeedControl control(asked, volume, fluid);
    double speed = 0.0, force = 1e-6;
    for (int step = 0; step < 10000; step++) {
      const double held = lambda * volume * speed;
      speed += (force * fluid - held) / volume;
      force = control.next(force, held);
    }
    EXPECT_NEAR(speed / asked, 1.0, 1e-5) << lambda;
    EXPECT_NEAR(force * fluid / (lambda * volume * asked), 1.0, 1e-5) << lambda;
  }
}

}  // namespace cohesion::lattice_boltzmann
