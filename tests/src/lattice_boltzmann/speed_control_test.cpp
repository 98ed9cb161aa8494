// SPDX-License-Identifier: BSD-3-Clause
#include "lattice_boltzmann/speed_control.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cohesion::lattice_boltzmann {

// A flow on paper, V dU/dt = g V_fluid - lambda V U: weakly and strongly held. The slower of the
// two rates is above 1/(tau tau_F)/(1/tau + 1/tau_F + lambda), 1/310 and 1/560: 6000 steps are ten
// of the slower times, less than 1e-4 of the way.
TEST(SpeedControl, LeadsToTheSpeed) {
  for (const double lambda : {0.001, 0.5, 1.0}) {
    const double volume = 1000.0, fluid = 600.0, asked = 0.02;
    SpeedControl control(asked, volume, fluid);
    double speed = 0.0, force = 1e-6;
    for (int step = 0; step < 6000; step++) {
      const double held = lambda * volume * speed;
      speed += (force * fluid - held) / volume;
      force = control.next(force, held);
    }
    EXPECT_NEAR(speed / asked, 1.0, 1e-4) << lambda;
    EXPECT_NEAR(force * fluid / (lambda * volume * asked), 1.0, 1e-4) << lambda;
  }
}

}  // namespace cohesion::lattice_boltzmann
