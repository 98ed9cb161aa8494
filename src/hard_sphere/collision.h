// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "vector3.h"

namespace cohesion::hard_sphere {

/// One side of an impulsive contact. A wall, and a particle that nothing moves, has both inverses
/// 0; a wall has radius 0 and the velocity of its surface.
struct CollisionPartner {
  Vector3 velocity;        ///< [length/time]
  Vector3 spin;            ///< [1/time]
  double inverse_mass;     ///< [1/mass]
  double inverse_inertia;  ///< of turning about the centre, [1/(mass length^2)]
  double radius;           ///< [length]
};

/// The impulses of a collision, and what they dissipate.
struct CollisionImpulses {
  double normal_impulse = 0.0;    ///< J, [momentum], positive repels
  Vector3 tangential_impulse;     ///< on j, its reverse on i, [momentum]
  double dissipated = 0.0;        ///< [energy]; below 0: given
  double rest_rule_energy = 0.0;  ///< kinetic energy above what restitution e leaves, [energy]
};

/// The least speeds with which collisions part their partners, [length/time].
struct MinimumSeparationSpeeds {
  double energy_adding = 0.0;   ///< whatever energy that takes
  double energy_limited = 0.0;  ///< as far as the collision has the energy
};

/// Collision of hard spheres with restitution and Coulomb friction.
///
///   B2 = 1/m_i + 1/m_j            B1 = B2 + r_i^2/I_i + r_j^2/I_j
///   J = (C0 + C)/B2               C0 = k.(v_i - v_j), k from i to j
///   C = e C0                      the speed with which they part
///   sticking, S0 < mu_f B1 J:     tangential impulse S0/B1
///   sliding:                      tangential impulse mu_f J
///
/// along the sliding velocity of i's surface against j's, of size S0. Dissipated: (C0^2 - C^2)/(2
/// B2) by the normal impulse, S0^2/(2 B1) by sticking, P S0 - P^2 B1/2 by sliding with the
/// tangential impulse P.
///
/// With least speeds G (given) and K (kept) the two part with
///
///   C = max(e C0, G, min(C0, K))
///
/// so that K makes a slow collision elastic. What friction dissipates in a collision that parts
/// with less than K then speeds C up, to K at most: such a collision takes no energy as long as
/// it has less.
///
/// The caller ensures B2 > 0.
///
/// Source: Hoomans et al., Chem. Eng. Sci. 51 (1996) 99, section 2.3; the least speeds: derived
/// here.
inline CollisionImpulses collide(const Vector3& k, const CollisionPartner& i,
                                 const CollisionPartner& j, double restitution, double friction,
                                 const MinimumSeparationSpeeds& least = {}) {
  const double b2 = i.inverse_mass + j.inverse_mass;
  const Vector3 relative = i.velocity - j.velocity;
  const double c0 = dot(k, relative), slow = restitution * c0;
  CollisionImpulses done;
  done.normal_impulse = (1.0 + restitution) * c0 / b2;
  done.dissipated = 0.5 * c0 * c0 * (1.0 - restitution * restitution) / b2;
  const auto part_with = [&](double speed) {
    done.normal_impulse = (c0 + speed) / b2;
    done.dissipated = 0.5 * (c0 - speed) * (c0 + speed) / b2;
    done.rest_rule_energy = 0.5 * (speed - slow) * (speed + slow) / b2;
  };
  const double separation_speed =
      std::max({slow, least.energy_adding, std::min(c0, least.energy_limited)});
  if (separation_speed > slow) part_with(separation_speed);
  if (friction == 0.0 || done.normal_impulse <= 0.0) return done;

  const Vector3 sliding = relative - c0 * k + cross(i.radius * i.spin + j.radius * j.spin, k);
  const double s0 = norm(sliding);
  if (s0 == 0.0) return done;
  const double b1 =
      b2 + i.radius * i.radius * i.inverse_inertia + j.radius * j.radius * j.inverse_inertia;
  const double limit = friction * done.normal_impulse;
  const double size = s0 < limit * b1 ? s0 / b1 : limit;
  done.tangential_impulse = (size / s0) * sliding;
  const double by_friction = size * (s0 - 0.5 * size * b1);
  if (separation_speed < least.energy_limited)
    part_with(std::min(least.energy_limited,
                       std::sqrt(separation_speed * separation_speed + 2.0 * b2 * by_friction)));
  done.dissipated += by_friction;
  return done;
}

}  // namespace cohesion::hard_sphere
