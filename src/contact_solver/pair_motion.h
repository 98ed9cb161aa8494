// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

#include "vector3.h"

namespace cohesion::contact_solver {

/// What a contact must know of a particle; a wall has inverse mass 0 and radius 0.
struct Body {
  double radius;        ///< [length]
  double inverse_mass;  ///< [1/mass]; 0: its velocity is prescribed

  /// Bits that differ; 0 if the bodies are equal. Faster than comparisons of numbers.
  std::uint64_t difference(const Body& other) const {
    std::uint64_t mine[2], others[2];
    std::memcpy(mine, this, sizeof mine);
    std::memcpy(others, &other, sizeof others);
    return (mine[0] ^ others[0]) | (mine[1] ^ others[1]);
  }
  bool operator==(const Body& other) const { return difference(other) == 0; }
};

/// 1/I of a solid sphere, [1/(mass length^2)]; 0 for a wall.
inline double inverse_inertia(const Body& body) {
  return body.inverse_mass > 0.0 ? 2.5 * body.inverse_mass / (body.radius * body.radius) : 0.0;
}

/// Position and velocity of particle j relative to particle i (of the foot of the normal relative
/// to the particle's centre, at a wall), and their spins.
struct PairMotion {
  Vector3 separation{};  ///< [length]
  Vector3 velocity{};    ///< [length/time]
  Vector3 spin_i{};      ///< [1/time]
  Vector3 spin_j{};
};

/// What a contact stores, [energy].
struct StoredEnergies {
  double spring;
  double tangential_spring;
  double rolling_spring;
  double adhesion;  ///< zero for particles far from each other
  /// What the normal motion stores by its energy account less spring and adhesion.
  double load = 0.0;

  double potential() const { return spring + adhesion; }
};

/// What acts on the particles of a pair: `impulse` on j, its reverse on i. Impulses [momentum] and
/// angular impulses [momentum length], or forces [force] and torques [force length] where stated.
struct PairAction {
  Vector3 impulse{};
  Vector3 torque_i{};
  Vector3 torque_j{};
};

/// What a contact does to its particles in a step: impulses.
struct FrictionalStep : PairAction {
  Vector3 friction{};      ///< impulse of sliding friction on j, [momentum]
  double repulsion = 0.0;  ///< impulse of spring and dashpot, [momentum]
  /// What of the impulse an edge gives, which the next step does not have, [momentum].
  Vector3 at_edge{};
  bool unresolved = false;  ///< the step was not integrated to its end
};

/// What a contact loses in a step but in sliding, [energy]. All that friction loses is what its
/// forces take from the motion, less what its springs store.
struct ContactLosses {
  double normal_damping = 0.0;
  double tangential_damping = 0.0;
  double rolling = 0.0;  ///< in the dashpot and slider of the rolling spring
};

/// The energies of a contact at a time level. They balance with 1/2 m v_(n-1/2) v_(n+1/2).
struct ContactEnergies {
  StoredEnergies stored{};  ///< 0 where it was not requested
  ContactLosses before{};   ///< since the time level before, as far as they are known only now
  ContactLosses after{};    ///< up to the next time level
  double exchanged = 0.0;  ///< part of the load that all contacts together exchange with each other
};

}  // namespace cohesion::contact_solver
