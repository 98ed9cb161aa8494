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

/// Whether the tangential dashpot acts in a contact. A sliding contact has none. `force`: on i
/// without the tangential spring, of which the part along the normal does not matter; `damping`
/// [mass/time]; `slip`: velocity of i's surface against j's in the plane of contact. A contact
/// sticks where the force is that of the dashpot within 1e-6, which is well above rounding.
inline bool dashpot_acts(const Vector3& force, double damping, const Vector3& slip) {
  const double power = damping * dot(slip, slip);
  return std::abs(dot(force, slip) + power) <= 1e-6 * power;
}

/// The energy T^2/(2 K_r R^2) of a rolling spring of stiffness `stiffness` K_r [force/length] and
/// lever R [length] that carries `torque` T [force length], [energy].
inline double rolling_spring_energy(const Vector3& torque, double stiffness, double lever) {
  return stiffness > 0.0 ? 0.5 * dot(torque, torque) / (stiffness * lever * lever) : 0.0;
}

/// The forces of a contact, from which their work follows once the velocities after the step are
/// known.
struct SampledForces {
  Vector3 normal;  ///< from j, or the wall, to i
  Vector3 force;   ///< on i, of all models, [force]
  /// The reverse of the tangential force on i without its dashpot, [force]: K_t times the
  /// displacement of the spring, or the Coulomb force where the contact slides. In a step the
  /// engine shortens the displacement to that force; in a set-up it does not.
  Vector3 without_dashpot;
  double lever_i, lever_j;  ///< from each centre to the point of contact, [length]
  double normal_dashpot;    ///< normal_dashpot(), [force]
};

struct SphereMotion {
  Vector3 velocity, spin;
};

/// Powers of the forces of contacts, [energy/time].
struct ContactPowers {
  double friction = 0.0;  ///< of the tangential spring, dashpot and slider
  double tangential_dashpot = 0.0, normal_dashpot = 0.0, rolling = 0.0;

  ContactPowers& operator+=(const ContactPowers& b) {
    friction += b.friction;
    tangential_dashpot += b.tangential_dashpot;
    normal_dashpot += b.normal_dashpot;
    rolling += b.rolling;
    return *this;
  }
};

/// `centres`: velocity of i's centre relative to j's; `turn`: the spins times their levers, added.
inline ContactPowers contact_powers(const SampledForces& c, const Vector3& centres,
                                    const Vector3& turn) {
  const Vector3 surfaces = centres - cross(turn, c.normal);
  const double along = dot(c.normal, centres);
  const double friction = dot(c.force, surfaces) - dot(c.force, c.normal) * along;
  return {friction, friction + dot(c.without_dashpot, surfaces), c.normal_dashpot * along};
}

/// Of both particles, without their rolling friction.
inline ContactPowers contact_powers(const SampledForces& c, const SphereMotion& i,
                                    const SphereMotion& j) {
  return contact_powers(c, i.velocity - j.velocity, c.lever_i * i.spin + c.lever_j * j.spin);
}

/// Of i alone: the share of the particle that touches a wall, or a particle of another process.
inline ContactPowers contact_powers(const SampledForces& c, const SphereMotion& i) {
  return contact_powers(c, i.velocity, c.lever_i * i.spin);
}

/// Of a wall that moves at `velocity`: what contact_powers() of i lacks.
inline ContactPowers wall_powers(const SampledForces& c, const Vector3& velocity) {
  const double along = dot(c.normal, velocity);
  const double friction = -dot(c.force, velocity - along * c.normal);
  return {friction, friction - dot(c.without_dashpot, velocity), -c.normal_dashpot * along};
}

/// The torque of rolling friction on a particle: what of `torque`, by all models, the tangential
/// force on i has not at the particle's `lever`.
inline Vector3 rolling_torque(const Vector3& torque, double lever, const SampledForces& c) {
  return torque + lever * cross(c.normal, c.force);
}

}  // namespace cohesion::contact
