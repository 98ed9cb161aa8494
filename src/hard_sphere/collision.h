// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "vector3.h"

namespace cohesion::hard_sphere {

/// One partner of an impulsive contact. A wall or an immobile particle has zero inverse mass and
/// inertia. A wall has radius 0 and the velocity of its surface.
struct CollisionPartner {
  Vector3 velocity;        ///< [length/time]
  Vector3 spin;            ///< [1/time]
  double inverse_mass;     ///< [1/mass]
  double inverse_inertia;  ///< about the centre, [1/(mass length^2)]
  double radius;           ///< [length]
};

/// Impulses of a collision and its energy change.
struct CollisionImpulses {
  double normal_impulse = 0.0;    ///< J, [momentum], positive repels
  Vector3 tangential_impulse;     ///< on j; the reverse acts on i, [momentum]
  double dissipated = 0.0;        ///< [energy]; negative: the collision adds energy
  double rest_rule_energy = 0.0;  ///< kinetic energy above that of restitution e, [energy]
};

/// Least speeds of separation along the line of centres, [length/time].
struct MinimumSeparationSpeeds {
  double energy_adding = 0.0;   ///< G: enforced even if that adds kinetic energy
  double energy_limited = 0.0;  ///< K: enforced as far as possible without adding kinetic energy
};

/// Collision of hard spheres with restitution and Coulomb friction.
///
///   B2 = 1/m_i + 1/m_j            B1 = B2 + r_i^2/I_i + r_j^2/I_j
///   J = (C0 + C)/B2               C0 = k.(v_i - v_j), k from i to j
///   C = e C0                      speed of separation
///   sticking, S0 < mu_f B1 J:     tangential impulse S0/B1
///   sliding:                      tangential impulse mu_f J
///
/// along the sliding velocity of i's surface against j's, of magnitude S0. Dissipated energy: (C0^2
/// - C^2)/(2 B2) by the normal impulse, S0^2/(2 B1) by sticking, P S0 - P^2 B1/2 by sliding with
/// the tangential impulse P.
///
/// With the least speeds of separation G and K
///
///   C = max(e C0, G, min(C0, K))
///
/// so that K makes a slow collision elastic. In a collision with C < K the energy dissipated by
/// friction then increases C, up to K: such a collision conserves energy while its C stays below K.
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
  const auto separate_with = [&](double speed) {
    done.normal_impulse = (c0 + speed) / b2;
    done.dissipated = 0.5 * (c0 - speed) * (c0 + speed) / b2;
    done.rest_rule_energy = 0.5 * (speed - slow) * (speed + slow) / b2;
  };
  const double separation_speed =
      std::max({slow, least.energy_adding, std::min(c0, least.energy_limited)});
  if (separation_speed > slow) separate_with(separation_speed);
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
    separate_with(std::min(least.energy_limited, std::sqrt(separation_speed * separation_speed +
                                                           2.0 * b2 * by_friction)));
  done.dissipated += by_friction;
  return done;
}

}  // namespace cohesion::hard_sphere
