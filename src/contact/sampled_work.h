// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "vector3.h"

/// Energies of contacts of an engine that takes one force per contact and step, at the place on the
/// grid, and steps by leapfrog: v(n+1/2) = v(n-1/2) + dt F(n)/m. The work of a force in that step
/// is exactly dt F(n) v(n), v(n) being the mean of both.
///
/// Source: derived here; what it misses is measured in docs/liggghts-styles/compute_gran_energy.md.
namespace cohesion::contact {

struct Moving {
  Vector3 velocity;  ///< [length/time]
  Vector3 spin;      ///< [1/time]
};

/// The motion of both partners.
struct Motion {
  Moving i, j;
};

/// The motion half a step after the grid point, from that half a step before it and that on it.
inline Motion half_a_step_on(const Motion& before, const Motion& grid) {
  const auto on = [](const Moving& a, const Moving& b) {
    return Moving{2.0 * b.velocity - a.velocity, 2.0 * b.spin - a.spin};
  };
  return {on(before.i, grid.i), on(before.j, grid.j)};
}

/// One contact at the grid point, as the engine's models give it.
struct ContactSample {
  Vector3 normal;           ///< from j, or the wall, to i
  double overlap = 0.0;     ///< x, [length]; negative: gap
  double stiffness = 0.0;   ///< F/x of the normal spring, [force/length]
  double exponent = 1.0;    ///< p of F ~ x^p, [1]
  double repulsion = 0.0;   ///< of normal spring and dashpot, [force]
  double attraction = 0.0;  ///< of the adhesion, [force]

  Vector3 tangential;                 ///< on i, in the plane of contact, [force]
  double lever_i = 0.0;               ///< from the centre to the plane of contact, [length]
  double lever_j = 0.0;               ///< [length]
  Vector3 displacement;               ///< s of the tangential spring, [length]
  double tangential_stiffness = 0.0;  ///< [force/length]
  double tangential_damping = 0.0;    ///< [mass/time]

  Vector3 rolling_i, rolling_j;  ///< torques but those of the tangential force, [force length]
  double rolling_energy = 0.0;   ///< of what is stored in them, [energy]

  Vector3 force_on_i() const { return (repulsion - attraction) * normal + tangential; }
  Vector3 torque_on_i() const { return rolling_i - lever_i * cross(normal, tangential); }
  Vector3 torque_on_j() const { return rolling_j - lever_j * cross(normal, tangential); }

  /// Speed at which i leaves j along the normal, [length/time].
  double separation_speed(const Motion& m) const {
    return dot(normal, m.i.velocity - m.j.velocity);
  }
  /// Velocity of i's surface against j's in the plane of contact, [length/time].
  Vector3 sliding_velocity(const Motion& m) const {
    const Vector3 v =
        m.i.velocity - m.j.velocity - cross(lever_i * m.i.spin + lever_j * m.j.spin, normal);
    return v - dot(v, normal) * normal;
  }
};

/// What leaves the motion of the two, per time, [energy/time].
struct Losses {
  double normal_damping = 0.0;
  double tangential_damping = 0.0;
  double tangential = 0.0;  ///< all that the tangential force takes: to spring, dashpot and slider
  double rolling = 0.0;     ///< all that the rolling torques take

  void add(double factor, const Losses& other) {
    normal_damping += factor * other.normal_damping;
    tangential_damping += factor * other.tangential_damping;
    tangential += factor * other.tangential;
    rolling += factor * other.rolling;
  }
};

/// The losses of a contact. `before`: the motion from which the engine took the force; `grid`: that
/// of the grid point.
inline Losses losses(const ContactSample& c, const Motion& before, const Motion& grid) {
  Losses lost;
  const double spring = c.overlap > 0.0 ? c.stiffness * c.overlap : 0.0;
  lost.normal_damping = -(c.repulsion - spring) * c.separation_speed(grid);
  const Vector3 slides = c.sliding_velocity(grid);
  lost.tangential = -dot(c.tangential, slides);
  // A contact that slides has no force of its dashpot in the Coulomb force: both are told apart by
  // whether spring and dashpot make up the force, 1e-6 of the dashpot being well above rounding.
  const Vector3 dashpot = c.tangential_damping * c.sliding_velocity(before);
  const Vector3 rest = c.tangential + c.tangential_stiffness * c.displacement + dashpot;
  if (norm(rest) <= 1e-6 * norm(dashpot)) lost.tangential_damping = dot(dashpot, slides);
  lost.rolling = -dot(c.rolling_i, grid.i.spin) - dot(c.rolling_j, grid.j.spin);
  return lost;
}

/// The energy T^2/(2 K_r R^2) of a rolling spring of stiffness `stiffness` K_r [force/length] and
/// lever R [length] that carries `torque` T [force length], [energy].
inline double rolling_spring_energy(const Vector3& torque, double stiffness, double lever) {
  return stiffness > 0.0 ? 0.5 * dot(torque, torque) / (stiffness * lever * lever) : 0.0;
}

/// What the two store half a step after the grid point, [energy].
struct Stored {
  double overlap;                  ///< then, [length]; negative: gap
  double spring = 0.0;             ///< c x^(p+1)/(p+1)
  double tangential_spring = 0.0;  ///< K_t s^2/2; 0 once parted: what it stored is lost as friction
};

/// What a contact stores at `after`, the motion of the half step `time` after the grid point.
inline Stored stored(const ContactSample& c, const Motion& after, double time) {
  Stored s;
  s.overlap = c.overlap - time * c.separation_speed(after);
  if (c.overlap > 0.0 && s.overlap > 0.0)
    s.spring = c.stiffness * c.overlap * c.overlap / (c.exponent + 1.0) *
               std::pow(s.overlap / c.overlap, c.exponent + 1.0);
  if (s.overlap <= 0.0) return s;
  const Vector3 stretch = c.displacement + time * c.sliding_velocity(after);
  s.tangential_spring = 0.5 * c.tangential_stiffness * dot(stretch, stretch);
  return s;
}

}  // namespace cohesion::contact
