// SPDX-License-Identifier: BSD-3-Clause
#include "drag/momentum_exchange.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drag/particle_drag.h"

namespace cohesion::drag {

TEST(MomentumExchange, TheSourceTakesWhatIsChargedAndWhatWasDeferred) {
  const double b = 3e-5, dt = 2e-3, v = -0.4, mean = 1.7, offset = 0.3, deferred = 5e-8;
  const double on_gas = explicit_source(b, v, offset, deferred, dt) - b * mean;
  const double charged = source_impulse(b, mean + offset, v, dt);
  // A few roundings of the largest term, 2e-7.
  EXPECT_NEAR(on_gas * dt, -(charged + deferred), 2e-7 * 1e-15);
}

TEST(MomentumExchange, ChargesTheGasWithWhatAFreeParticleFeels) {
  const double b = 4e-3, mass = 5e-6, dt = 1e-3, u = 1.3, v = -0.2;
  EXPECT_EQ(source_coefficient(b, mass, dt, false), b);
  const double c = source_coefficient(b, mass, dt, true);
  // Its velocity comes nearer to the gas's by exp(-b dt/m).
  const double gained = mass * (u - v) * -std::expm1(-b * dt / mass);
  EXPECT_NEAR(source_impulse(c, u, v, dt), gained, 1e-15 * gained * 4);
}

TEST(MomentumExchange, GasAndParticleKeepTheirMomentum) {
  // A gas of the mass M and a particle, alone, by steps: what the gas lost is what the particle
  // gained, and what is deferred.
  const double gas_mass = 2e-6, mass = 5e-6, b = 4e-3, dt = 1e-3, offset = 0.1;
  for (const Response response : responses) {
    double gas = 1.0, particle = -0.2, deferred = 0.0;
    const double momentum = gas_mass * gas + mass * particle;
    const double c = source_coefficient(b, mass, dt, response.free);
    for (int step = 0; step < 50; step++) {
      // M (U' - U)/dt = S - c U', implicit
      gas = (gas + explicit_source(c, particle, offset, deferred, dt) * dt / gas_mass) /
            (1.0 + c * dt / gas_mass);
      const double u = gas + offset;
      const double felt = ParticleDrag(b, mass, dt).force(u - particle, 0.0) * dt;
      deferred = felt - source_impulse(c, u, particle, dt);
      particle += felt / mass;
      // Ten roundings of 1e-5 kg m/s or less in each step
      EXPECT_NEAR(gas_mass * gas + mass * particle - deferred, momentum, 50 * 10 * 1e-5 * 2.3e-16);
    }
    // They have come to the same velocity, the offset apart, long ago: b dt/m is 0.8.
    EXPECT_NEAR(particle, gas + offset, 1e-6);
  }
}

TEST(MomentumExchange, ChargesTheGasWithThePressureThatAFreeParticleTransmits) {
  const double b = 4e-3, mass = 5e-6, volume = 3e-9, dt = 1e-3, u = 1.3, v = -0.2, gradient = 4e5;
  const double c = source_coefficient(b, mass, dt, true);
  const double transmitted = transmitted_volume(b, mass, volume, dt);
  const double charged = source_impulse(c, u, v, dt) + transmitted * gradient * dt -
                         last_pressure_on_gas(transmitted, gradient, true) * dt;
  // What the particle gained, and the pressure's impulse gave beside the drag
  const double follows = u - volume * gradient / b;
  const double gained = mass * (follows - v) * -std::expm1(-b * dt / mass);
  EXPECT_NEAR(charged, gained + volume * gradient * dt, 1e-15 * 10 * volume * gradient * dt);
}

TEST(MomentumExchange, ChargesAHeldParticleWithTheChangeOfThePressureAlone) {
  // Of W = 2e-9 and steps of 1e-3, with a gradient that comes up to 4e5 and stays: in all W 4e5 dt
  // for one that is held, W grad p dt in every step for one that follows.
  const double transmitted = 2e-9, dt = 1e-3;
  for (const Response response : responses) {
    double last = 0.0, charged = 0.0;
    for (const double gradient : {1e5, 3e5, 4e5, 4e5, 4e5}) {
      const double known = last_pressure_on_gas(transmitted, last, response.free);
      charged += (transmitted * gradient - known) * dt;
      last = gradient;
    }
    const double expected = response.free ? 3.2e-6 : 8e-7;
    EXPECT_NEAR(charged, expected, 20 * 2.3e-16 * expected) << response.name;
  }
}

TEST(MomentumExchange, TransmitsNothingWithoutDragAndAllWithStiffDrag) {
  EXPECT_EQ(transmitted_volume(0.0, 5e-6, 3e-9, 1e-3), 0.0);
  EXPECT_NEAR(transmitted_volume(4e9, 5e-6, 3e-9, 1e-3), 3e-9, 3e-9 * 1e-11);
}

TEST(MomentumExchange, GasAndParticleKeepTheirMomentumUnderAPressureThatSwings) {
  const double gas_mass = 2e-6, mass = 5e-6, volume = 3e-9, b = 4e-3, dt = 1e-3, share = 0.4;
  for (const Response response : responses) {
    double gas = 1.0, particle = -0.2, deferred = 0.0, last = 0.0, outside = 0.0;
    const double momentum = gas_mass * gas + mass * particle;
    const double c = source_coefficient(b, mass, dt, response.free);
    const double transmitted = transmitted_volume(b, mass, volume, dt);
    // The particle has 1 - eps of the volume.
    const double gas_volume = volume * share / (1.0 - share);
    for (int step = 0; step < 50; step++) {
      const double gradient = 2e5 * std::sin(0.7 * step);
      const double known = last_pressure_on_gas(transmitted, last, response.free);
      const double source = explicit_source(c, particle, 0.0, deferred, dt) + known -
                            (gas_volume + transmitted) * gradient;
      gas = (gas + source * dt / gas_mass) / (1.0 + c * dt / gas_mass);
      const double felt =
          ParticleDrag(b, mass, dt).force(gas - particle, pressure_force(volume, gradient)) * dt;
      deferred =
          felt - source_impulse(c, gas, particle, dt) - (transmitted * gradient - known) * dt;
      particle += (felt + pressure_force(volume, gradient) * dt) / mass;
      last = gradient;
      outside -= (gas_volume + volume) * gradient * dt;
      // Twenty roundings of 1e-5 kg m/s or less in each step
      EXPECT_NEAR(gas_mass * gas + mass * particle - deferred, momentum + outside,
                  50 * 20 * 1e-5 * 2.3e-16);
      // Of a free particle that is taken to follow nothing is left, but rounding of 1e-6 kg m/s.
      if (response.free) {
        EXPECT_NEAR(deferred, 0.0, 20 * 1e-6 * 2.3e-16);
      }
    }
  }
}

}  // namespace cohesion::drag
