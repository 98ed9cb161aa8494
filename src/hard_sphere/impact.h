// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "hard_sphere/collision.h"
#include "square_well/impulses.h"
#include "validation.h"

namespace cohesion::hard_sphere {

/// Hard core with restitution and friction inside a square well.
struct ImpactLaw {
  double restitution = 1.0;  ///< e, [1]
  double friction = 0.0;     ///< mu_f, [1]
  double depth = 0.0;        ///< D, [energy]; 0: no well

  /// Whether collisions conserve kinetic energy.
  bool conserves_energy() const { return restitution == 1.0 && friction == 0.0; }
};

inline void require_valid(const ImpactLaw& law) {
  require(std::isfinite(law.restitution) && law.restitution >= 0.0 && law.restitution <= 1.0,
          "restitution e", law.restitution, "must be between 0 and 1");
  require_non_negative("friction mu", law.friction);
  require_non_negative("depth D of the well", law.depth);
}

/// The surface that the centre of a partner reaches, and the direction in which it crosses.
enum class Surface { core, edge_inward, edge_outward };

enum class EventKind { collision, approach, escape, capture };
inline constexpr std::array event_kind_names{"collision", "approach", "escape", "capture"};

/// The outcome of partner j reaching a surface of partner i.
struct ImpactOutcome {
  EventKind kind = EventKind::collision;
  bool inside = false;          ///< whether the pair is in the well afterwards
  double normal_impulse = 0.0;  ///< J, [momentum], positive repels
  Vector3 impulse;              ///< on j; the reverse acts on i, [momentum]
  Vector3 spin_impulse;  ///< k x tangential impulse; spins change by -radius/I times it, [momentum]
  double energy_change = 0.0;     ///< of the kinetic energy with rotation, [energy]
  double rest_rule_energy = 0.0;  ///< CollisionImpulses::rest_rule_energy, [energy]
};

/// Computes the impact at a surface. k: unit vector from i to j, or from the centre of the particle
/// to the wall; `least`: as in collide(). Laws and sources: collision.h, square_well/impulses.h.
inline ImpactOutcome compute_impact(Surface surface, const Vector3& k, const ImpactLaw& law,
                                    const CollisionPartner& i, const CollisionPartner& j,
                                    const MinimumSeparationSpeeds& least = {}) {
  ImpactOutcome outcome;
  if (surface == Surface::core) {
    const CollisionImpulses hit = collide(k, i, j, law.restitution, law.friction, least);
    outcome.inside = law.depth > 0.0;
    outcome.normal_impulse = hit.normal_impulse;
    outcome.impulse = hit.normal_impulse * k + hit.tangential_impulse;
    outcome.spin_impulse = cross(k, hit.tangential_impulse);
    outcome.energy_change = -hit.dissipated;
    outcome.rest_rule_energy = hit.rest_rule_energy;
    return outcome;
  }
  const double b = i.inverse_mass + j.inverse_mass;
  const double u = dot(k, i.velocity - j.velocity);
  if (surface == Surface::edge_inward) {
    outcome.kind = EventKind::approach;
    outcome.inside = true;
    outcome.normal_impulse = square_well::approach_impulse(u, law.depth, b);
    outcome.energy_change = law.depth;
  } else if (square_well::escapes(u, law.depth, b)) {
    outcome.kind = EventKind::escape;
    outcome.normal_impulse = square_well::escape_impulse(u, law.depth, b);
    outcome.energy_change = -law.depth;
  } else {
    outcome.kind = EventKind::capture;
    outcome.inside = true;
    outcome.normal_impulse = square_well::capture_impulse(u, b);
  }
  outcome.impulse = outcome.normal_impulse * k;
  return outcome;
}

}  // namespace cohesion::hard_sphere
