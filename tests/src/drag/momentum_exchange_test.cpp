// SPDX-License-Identifier: BSD-3-Clause
#include "drag/momentum_exchange.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drag/particle_drag.h"

namespace cohesion::drag {

TEST(MomentumExchange, TheSourceTakesWhatIsChargedAndWhatWasPending) {
  const double b = 3e-5, dt = 2e-3, v = -0.4, mean = 1.7, offset = 0.3, pending = 5e-8;
  const double on_gas = source_on_gas(b, v, offset, pending, dt) - b * mean;
  const double charged = impulse_charged(b, mean + offset, v, dt);
  // A few roundings of the largest term, 2e-7.
  EXPECT_NEAR(on_gas * dt, -(charged + pending), 2e-7 * 1e-15);
}

TEST(MomentumExchange, ChargesTheGasWithWhatAFreeParticleFeels) {
  const double b = 4e-3, mass = 5e-6, dt = 1e-3, u = 1.3, v = -0.2;
  EXPECT_EQ(charged_coefficient(b, mass, dt, false), b);
  const double c = charged_coefficient(b, mass, dt, true);
  // Its velocity comes nearer to the gas's by exp(-b dt/m).
  const double gained = mass * (u - v) * -std::expm1(-b * dt / mass);
  EXPECT_NEAR(impulse_charged(c, u, v, dt), gained, 1e-15 * gained * 4);
}

TEST(MomentumExchange, GasAndParticleKeepTheirMomentum) {
  // A gas of the mass M and a particle, alone, by steps: what the gas lost is what the particle
  // gained, and what is pending.
  const double gas_mass = 2e-6, mass = 5e-6, b = 4e-3, dt = 1e-3, offset = 0.1;
  for (const Response response : responses) {
    double gas = 1.0, particle = -0.2, pending = 0.0;
    const double momentum = gas_mass * gas + mass * particle;
    const double c = charged_coefficient(b, mass, dt, response.free);
    for (int step = 0; step < 50; step++) {
      // M (U' - U)/dt = S - c U', implicit
      gas = (gas + source_on_gas(c, particle, offset, pending, dt) * dt / gas_mass) /
            (1.0 + c * dt / gas_mass);
      const double u = gas + offset;
      const double felt = ParticleDrag(b, mass, dt).force(u - particle, 0.0) * dt;
      pending = felt - impulse_charged(c, u, particle, dt);
      particle += felt / mass;
      // Ten roundings of 1e-5 kg m/s or less in each step
      EXPECT_NEAR(gas_mass * gas + mass * particle - pending, momentum, 50 * 10 * 1e-5 * 2.3e-16);
    }
    // They have come to the same velocity, the offset apart, long ago: b dt/m is 0.8.
    EXPECT_NEAR(particle, gas + offset, 1e-6);
  }
}

}  // namespace cohesion::drag
