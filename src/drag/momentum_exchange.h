// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "drag/particle_drag.h"

/// Which momentum passes between the gas and one particle in a gas step dt; one component.
///
/// The gas solver knows the mean velocity U of the particle's cells, at the end of its step. The
/// gas at the particle is u = U + offset. The step charges the gas with c (u - v_0) dt, v_0 the
/// particle's velocity at the step's start, as a source that is linear in U, and with the deferred
/// impulse: what the particle has felt before but the gas was not charged with. The particle then
/// feels b (u - v) with its own velocity as it changes: what it feels less what the gas was charged
/// with is deferred to the next step. The source coefficient c is b or less (Response).
///
/// In form A the particle also feels -V_p grad p, and transmits the fraction 1 - phi of it to the
/// gas by drag within the step (particle_drag.h). The step charges the gas with that, too, grad p
/// its own, implicit: W grad p with W = (1 - phi) V_p. Charged a step late, pressure and particles
/// would swing against each other, and grow. A particle that feels nothing but gas then leaves
/// nothing deferred when it is taken to follow. One that is taken to keep its velocity is held by
/// something that has borne the pressure of the step before, so it is charged with the change,
/// W (grad p - grad p_last), both gradients where it is now. Nothing is left of it in a steady
/// flow. What that does to waves and held particles: pressure_waves.h.
///
/// coefficient c [force time/length]; velocities [length/time]; deferred [force time]; dt [time].
namespace cohesion::drag {

/// What the gas step takes the particles to do meanwhile: keep their velocity, c = b, which is
/// stable whatever they do, but for waves of dense ones in form A (pressure_waves.h); or follow the
/// gas as a particle does that feels nothing else, c = b phi(b dt/m) (particle_drag.h). Then gas
/// and free particles find their common velocity at once, but particles that are held, by others
/// for instance, leave the part b - c of their drag deferred.
struct Response {
  std::string_view name;
  bool free;
};
inline constexpr std::array responses{Response{"held", false}, Response{"free", true}};

/// c of a particle with the coefficient b [force time/length], mass [mass] and a gas step dt
/// [time].
inline double source_coefficient(double coefficient, double mass, double dt, bool free) {
  return free ? ParticleDrag(coefficient, mass, dt).force(1.0, 0.0) : coefficient;
}

/// W [length^3] of a particle of `volume` V_p [length^3], with the coefficient b [force
/// time/length], mass [mass] and a gas step dt [time].
inline double transmitted_volume(double coefficient, double mass, double volume, double dt) {
  return -ParticleDrag(coefficient, mass, dt).force(0.0, volume);
}

/// The part of the charge W (grad p - grad p_last) that is known before the step, as a force on the
/// gas, [force]; W [length^3], gradient of the last step [force/length^3].
inline double last_pressure_on_gas(double transmitted, double last_gradient, bool free) {
  return free ? 0.0 : transmitted * last_gradient;
}

/// The explicit part S of the force S - c U on the gas, a source that is linear in U, [force].
inline double explicit_source(double coefficient, double particle_velocity, double offset,
                              double deferred, double dt) {
  return coefficient * (particle_velocity - offset) - deferred / dt;
}

/// Impulse that the gas gives up for the drag of this step, without what was deferred,
/// [force time]. gas_velocity: u, at the particle.
inline double source_impulse(double coefficient, double gas_velocity, double particle_velocity,
                             double dt) {
  return coefficient * (gas_velocity - particle_velocity) * dt;
}

}  // namespace cohesion::drag
