// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "hard_sphere/collision.h"
#include "square_well/impulses.h"
#include "validation.h"

namespace cohesion::hard_sphere {

/// Hard core with restitution and friction inside a square well.
struct Law {
  double restitution = 1.0;  ///< e, [1]
  double friction = 0.0;     ///< mu_f, [1]
  double depth = 0.0;        ///< D, [energy]; 0: hard core alone

  /// Whether collisions take no energy.
  bool takes_nothing() const { return restitution == 1.0 && friction == 0.0; }
};

inline void require_valid(const Law& law) {
  require(std::isfinite(law.restitution) && law.restitution >= 0.0 && law.restitution <= 1.0,
          "restitution e", law.restitution, "must be between 0 and 1");
  require_non_negative("friction mu", law.friction);
  require_non_negative("depth D of the well", law.depth);
}

/// The surface that the centre of a partner meets, and the direction in which it crosses.
enum class Surface { core, edge_inward, edge_outward };

enum class Kind { collision, approach, escape, capture };
inline constexpr std::array kind_names{"collision", "approach", "escape", "capture"};

/// The outcome of partner j meeting a surface of partner i.
struct Impact {
  Kind kind = Kind::collision;
  bool inside = false;  ///< in the well afterwards
  double normal = 0.0;  ///< J, [momentum], positive repels
  Vector3 on_j;         ///< impulse, its reverse on i, [momentum]
  Vector3 twist;        ///< k x tangential impulse: spins change by -radius twist/I, [momentum]
  double energy_change = 0.0;  ///< of kinetic energy, rotation included, [energy]
  double given_at_rest = 0.0;  ///< Collision::given_at_rest, [energy]
};

/// Computes the impact at a surface; k is the unit vector from i to j (from the particle's centre
/// to the wall), `least` the speeds of collide(). The laws and their sources: collision.h,
/// square_well/impulses.h.
inline Impact impact(Surface surface, const Vector3& k, const Law& law, const Partner& i,
                     const Partner& j, const LeastSpeeds& least = {}) {
  Impact now;
  if (surface == Surface::core) {
    const Collision hit = collide(k, i, j, law.restitution, law.friction, least);
    now.inside = law.depth > 0.0;
    now.normal = hit.normal;
    now.on_j = hit.normal * k + hit.tangential;
    now.twist = cross(k, hit.tangential);
    now.energy_change = -hit.dissipated;
    now.given_at_rest = hit.given_at_rest;
    return now;
  }
  const double b = i.inverse_mass + j.inverse_mass;
  const double u = dot(k, i.velocity - j.velocity);
  if (surface == Surface::edge_inward) {
    now.kind = Kind::approach;
    now.inside = true;
    now.normal = square_well::approach_impulse(u, law.depth, b);
    now.energy_change = law.depth;
  } else if (square_well::escapes(u, law.depth, b)) {
    now.kind = Kind::escape;
    now.normal = square_well::escape_impulse(u, law.depth, b);
    now.energy_change = -law.depth;
  } else {
    now.kind = Kind::capture;
    now.inside = true;
    now.normal = square_well::capture_impulse(u, b);
  }
  now.on_j = now.normal * k;
  return now;
}

}  // namespace cohesion::hard_sphere
