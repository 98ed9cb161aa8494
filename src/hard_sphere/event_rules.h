// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hard_sphere/bodies.h"

namespace cohesion::hard_sphere {

/// The rule of rest, the rules against inelastic collapse, and the limit of events
/// (docs/theory/hard_spheres.md).
///
/// The rule of rest: in a dissipative collision the partners separate along the line of centres
/// with a least speed [length/time], the larger of two.
///
/// 1. Where other forces press particles together, in steps of the engine:
///
///   G = C a dt sqrt(n)            a dt: velocity change by other forces in this step
///                                 n: previous collisions of the particle in this step
///
/// for the particle with the larger value, even if that adds kinetic energy. If G were constant,
/// the collisions of a contact in a step would grow as the force on it. If G grew as n, particles
/// in a narrow gap would accelerate without bound within the step.
///
/// 2. Where wells press particles together, independent of the step:
///
///   K = 1e-3 C sqrt(2 D/m) sqrt(max(n, 1))        D: depth of the well, m: reduced mass
///
/// as far as that adds no kinetic energy: a collision whose energy along the line of centres is
/// below 1e-6 C^2 D is elastic.
///
/// At the edge a capture returns the pair by at least 1e-6 C^2 of the width of the well, or with K
/// if that is slower: the relative velocity is rotated inwards. Its magnitude is conserved, and so
/// are energy and momentum. A rotation changes the angular momentum of the pair by the fraction
/// 1e-6 C^2 of the width over the distance.
struct EventRules {
  /// Collisions of a particle in a step before further ones are elastic; 0: off.
  int collapse_limit = 100;
  /// A collision sooner after the previous one of a particle is elastic, [time].
  double contact_time = 0.0;
  double rest_factor = 1.0;  ///< C of the rule of rest, [1]; 0: off
  int event_limit = 100000;  ///< events of a particle in a step before the run stops

  /// Whether the rules against inelastic collapse make a collision of a body at `time` elastic.
  bool is_made_elastic(const EventState& event_state, double time) const {
    return (collapse_limit > 0 && event_state.collisions >= collapse_limit) ||
           time - event_state.last_collision < contact_time;
  }

  /// G of a body, [length/time]. speed_increment: a dt.
  double energy_adding_speed(double speed_increment, const EventState& event_state) const {
    return rest_factor * speed_increment * std::sqrt(static_cast<double>(event_state.collisions));
  }
  /// K in a well, [length/time]. inverse_mass: 1/m; collisions: n.
  double energy_limited_speed(double depth, double inverse_mass, int collisions) const {
    const double n = std::max(collisions, 1);
    return rest_factor * fall_speed_fraction * std::sqrt(2.0 * depth * inverse_mass * n);
  }
  /// Least speed along the line of centres, [length/time], with which a chord of a pair of relative
  /// speed w returns within the edge by 1e-6 C^2 of the width of the well.
  double inward_speed_at_edge(double w, const SurfaceDistances& surfaces) const {
    return rest_factor * width_fraction_root * w *
           std::sqrt(2.0 * (surfaces.edge - surfaces.core) / surfaces.edge);
  }

 private:
  /// Square root of the fraction of the width, for C = 1.
  static constexpr double width_fraction_root = 1e-3;
  /// K over the speed of a fall into the well, for C = n = 1.
  static constexpr double fall_speed_fraction = 1e-3;
};

}  // namespace cohesion::hard_sphere
