// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Which momentum passes between the gas and one particle in a gas step dt; one component.
///
/// The gas solver knows the mean velocity U of the particle's cells, at the end of its step. The
/// gas at the particle is u = U + offset. The step charges the gas with b (u - v_0) dt, v_0 the
/// particle's velocity at the step's start, as a source that is linear in U, and with what the
/// particle has felt before but the gas was not charged with, `pending`. The particle then feels
/// b (u - v) with its own velocity as it changes: what it feels less what the gas was charged with
/// is pending in the next step.
///
/// coefficient b [force time/length]; velocities [length/time]; pending [force time]; dt [time].
namespace cohesion::drag {

/// S of the force S - b U on the gas, [force].
inline double source_on_gas(double coefficient, double particle_velocity, double offset,
                            double pending, double dt) {
  return coefficient * (particle_velocity - offset) - pending / dt;
}

/// Impulse that the gas gives up for the drag of this step, without what was pending,
/// [force time]. gas_velocity: u, at the particle.
inline double impulse_charged(double coefficient, double gas_velocity, double particle_velocity,
                              double dt) {
  return coefficient * (gas_velocity - particle_velocity) * dt;
}

}  // namespace cohesion::drag
