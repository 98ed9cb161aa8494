// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector3.h"

/// Energies of contacts of an engine that computes one force per contact and step, at the time
/// level, from the velocities of half a step before it.
namespace cohesion::contact {

/// One contact at the time level, as the engine's models give it.
struct ContactSample {
  Vector3 normal;          ///< from j, or the wall, to i
  double overlap = 0.0;    ///< x, [length]; negative: gap
  double stiffness = 0.0;  ///< F/x of the normal spring, [force/length]
  double exponent = 1.0;   ///< p of F ~ x^p, [1]
  double repulsion = 0.0;  ///< of normal spring and dashpot, [force]

  Vector3 tangential;                 ///< on i, in the plane of contact, [force]
  Vector3 slip;                       ///< velocity of i's surface against j's in it
  Vector3 displacement;               ///< s of the tangential spring, [length]
  double tangential_stiffness = 0.0;  ///< [force/length]
  double tangential_damping = 0.0;    ///< [mass/time]

  /// c x^(p+1)/(p+1) of F = c x^p.
  double spring_energy() const {
    return overlap > 0.0 ? stiffness * overlap * overlap / (exponent + 1.0) : 0.0;
  }
  double tangential_spring_energy() const {
    return 0.5 * tangential_stiffness * dot(displacement, displacement);
  }
  /// Force of the normal dashpot on i.
  Vector3 normal_dashpot() const {
    return (repulsion - (overlap > 0.0 ? stiffness * overlap : 0.0)) * normal;
  }
  /// Whether it sticks: in a contact that slides, the Coulomb force has no dashpot. It sticks where
  /// the tangential force equals the sum of spring and dashpot within 1e-6 of the dashpot, which is
  /// well above rounding.
  bool sticks() const {
    const Vector3 dashpot = tangential_dashpot();
    const Vector3 rest = tangential + tangential_stiffness * displacement - dashpot;
    return dot(rest, rest) <= 1e-12 * dot(dashpot, dashpot);
  }
  /// Force of the tangential dashpot on i where it sticks.
  Vector3 tangential_dashpot() const { return -tangential_damping * slip; }
};

/// The energy T^2/(2 K_r R^2) of a rolling spring of stiffness `stiffness` K_r [force/length] and
/// lever R [length] that carries `torque` T [force length], [energy].
inline double rolling_spring_energy(const Vector3& torque, double stiffness, double lever) {
  return stiffness > 0.0 ? 0.5 * dot(torque, torque) / (stiffness * lever * lever) : 0.0;
}

}  // namespace cohesion::contact
