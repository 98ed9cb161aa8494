// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "hard_sphere/bodies.h"

namespace cohesion::hard_sphere {

/// The rules of a run: those against inelastic collapse, and limits.
///
/// The rule of rest: a collision that takes energy leaves with a speed along the line of centres of
/// at least
///
///   u' = C a dt sqrt(n)           a dt: kick, the change of velocity by other forces in this step
///                                 n: collisions of the particle in this step before this one
///
/// by the particle for which that is more. So what comes to rest goes on with an agitation that a
/// step of its weight gives it anyway, and a contact that hands on the momentum F dt in a step has
/// at most
///
///   N = 1 + (3 F/(2 C m a))^(2/3)
///
/// collisions in it, m the reduced mass: the k-th has an impulse of at least m C a dt sqrt(k - 1).
///
/// The force F on a contact of a bed need not be that of the weight above it: a row of spheres that
/// just fits between two walls is pressed flat with a force that has no bound. With a constant u' N
/// grows as F; with one that grows as n what is shut in a narrow place is driven faster and faster
/// within the step. As sqrt(n) speeds stay: in a place with the room s there are at most
/// (C a dt^2/(2 s))^2 collisions.
struct EventRules {
  int collapse = 100;  ///< collisions of a particle in a step before the rest are elastic; 0: off
  double contact_time = 0.0;  ///< collisions sooner after a particle's last one are elastic, [time]
  double rest = 1.0;          ///< C of the rule of rest, [1]; 0: off
  int limit = 100000;         ///< events of a particle in a step before the step is given up

  /// Whether the rules against inelastic collapse make a collision elastic that a body has at
  /// `time`, with what it has done before in the step.
  bool make_elastic(const Course& course, double time) const {
    return (collapse > 0 && course.collisions >= collapse) ||
           time - course.last_collision < contact_time;
  }

  /// The least speed with which the rule of rest lets a body leave, [length/time].
  double rest_speed(double kick, const Course& course) const {
    return rest * kick * std::sqrt(static_cast<double>(course.collisions));
  }
};

}  // namespace cohesion::hard_sphere
