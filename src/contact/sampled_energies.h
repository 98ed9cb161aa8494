// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "vector3.h"

/// Energies of contacts of an engine that computes one force per contact and step, at the time
/// level, from the velocities of half a step before it.
namespace cohesion::contact {

/// The energy c x^(p+1)/(p+1) of a spring of force F = c x^p at the overlap x [length] with
/// `stiffness` F/x [force/length] and `exponent` p, [energy].
inline double normal_spring_energy(double overlap, double stiffness, double exponent) {
  return overlap > 0.0 ? stiffness * overlap * overlap / (exponent + 1.0) : 0.0;
}

/// The force of the normal dashpot: what of the `repulsion` of both the spring is not, [force].
inline double normal_dashpot(double repulsion, double overlap, double stiffness) {
  return repulsion - (overlap > 0.0 ? stiffness * overlap : 0.0);
}

inline double tangential_spring_energy(const Vector3& displacement, double stiffness) {
  return 0.5 * stiffness * dot(displacement, displacement);
}

/// The damping [mass/time] of the tangential dashpot, or 0 in a contact that slides, whose Coulomb
/// force has no dashpot. `force`: on i, of which the part along the normal does not matter;
/// `spring`: that of the tangential spring; `slip`: velocity of i's surface against j's in the
/// plane of contact. A contact sticks where the force equals the sum of spring and dashpot within
/// 1e-6 of the dashpot, which is well above rounding.
inline double acting_damping(const Vector3& force, const Vector3& spring, double damping,
                             const Vector3& slip) {
  const double power = damping * dot(slip, slip);
  return std::abs(dot(force - spring, slip) + power) <= 1e-6 * power ? damping : 0.0;
}

/// The energy T^2/(2 K_r R^2) of a rolling spring of stiffness `stiffness` K_r [force/length] and
/// lever R [length] that carries `torque` T [force length], [energy].
inline double rolling_spring_energy(const Vector3& torque, double stiffness, double lever) {
  return stiffness > 0.0 ? 0.5 * dot(torque, torque) / (stiffness * lever * lever) : 0.0;
}

}  // namespace cohesion::contact
