// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hard_sphere/bodies.h"

namespace cohesion::hard_sphere {

/// The rules of a run: those against inelastic collapse, and limits.
///
/// The rule of rest: a collision that takes energy parts its partners along the line of centres
/// with a least speed. It is the larger one of two.
///
/// 1. Where other forces press particles together, in steps of the engine:
///
///   G = C a dt sqrt(n)            a dt: kick, the change of velocity by other forces in this step
///                                 n: collisions of the particle in this step before this one
///
/// by the particle for which that is more, whatever energy it takes. So what comes to rest goes on
/// with an agitation that a step of its weight gives it anyway, and a contact that hands on the
/// momentum F dt in a step has at most
///
///   N = 1 + (3 F/(2 C m a))^(2/3)
///
/// collisions in it, m the reduced mass: the k-th has an impulse of at least m C a dt sqrt(k - 1).
///
/// The force F on a contact of a bed need not be that of the weight above it: a row of spheres that
/// just fits between two walls is pressed flat with a force that has no bound. With a constant G N
/// grows as F; with one that grows as n what is shut in a narrow place is driven faster and faster
/// within the step. As sqrt(n) speeds stay: in a place with the room s there are at most
/// (C a dt^2/(2 s))^2 collisions.
///
/// 2. Where wells press particles together, whatever the step:
///
///   K = 1e-3 C sqrt(2 D/m) sqrt(max(n, 1))        D: depth of the well
///
/// as far as the collision has the energy: it never gives any. A cluster that turns presses on
/// some of its cores, by captures at the edges of wells: three spheres that turn about an axis in
/// their plane pull two of them together. The cores take energy, the edges give none back, and the
/// speeds of all would tend to 0, the number of events to infinity, in a finite time. A collision
/// whose energy along the line of centres is below 1e-6 C^2 D is elastic instead, and a cluster
/// that turns with the speed v has some v/K events, per contact, in the time of a turn.
///
/// At the edge a capture brings the pair back within it by at least 1e-6 C^2 of the width of the
/// well, or with K where that is less: the relative velocity is turned inwards. Its size is kept,
/// and so are energy and momentum; a turn changes the angular momentum of the pair by the fraction
/// 1e-6 C^2 of the width over the distance.
struct EventRules {
  int collapse_limit =
      100;  ///< collisions of a particle in a step before the rest are elastic; 0: off
  double contact_time = 0.0;  ///< collisions sooner after a particle's last one are elastic, [time]
  double rest_factor = 1.0;   ///< C of the rule of rest, [1]; 0: off
  int event_limit = 100000;   ///< events of a particle in a step before the step is given up

  /// Whether the rules against inelastic collapse make a collision elastic that a body has at
  /// `time`, with what it has done before in the step.
  bool is_made_elastic(const EventState& event_state, double time) const {
    return (collapse_limit > 0 && event_state.collisions >= collapse_limit) ||
           time - event_state.last_collision < contact_time;
  }

  /// G of a body, [length/time].
  double energy_adding_speed(double speed_increment, const EventState& event_state) const {
    return rest_factor * speed_increment * std::sqrt(static_cast<double>(event_state.collisions));
  }
  /// K in a well, [length/time]. inverse_mass: 1/m; collisions: n.
  double energy_limited_speed(double depth, double inverse_mass, int collisions) const {
    const double n = std::max(collisions, 1);
    return rest_factor * fall_speed_fraction * std::sqrt(2.0 * depth * inverse_mass * n);
  }
  /// The speed along the line of centres with which a chord of a pair of relative speed w goes back
  /// within the edge by 1e-6 C^2 of the width of the well, [length/time].
  double inward_speed_at_edge(double w, const SurfaceDistances& surfaces) const {
    return rest_factor * width_fraction_root * w *
           std::sqrt(2.0 * (surfaces.edge - surfaces.core) / surfaces.edge);
  }

 private:
  static constexpr double width_fraction_root = 1e-3;  // root of the part of the width, for C = 1
  static constexpr double fall_speed_fraction = 1e-3;  // K over the speed of a fall, for C = n = 1
};

}  // namespace cohesion::hard_sphere
