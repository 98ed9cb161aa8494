// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/tangential_spring.h"
#include "event_stepping/pair_step.h"

namespace cohesion::event_stepping {

/// What a tangential or rolling spring does in a step.
struct SpringStep {
  contact::TangentialStep spring;
  Vector3 memory;  ///< for the next step: the spring's displacement on the grid, [length]
};

/// How fast the ends of a spring part, [length/time].
struct SpringVelocity {
  Vector3 start;      ///< in the middle of what all others and the normal motion do, without itself
  Vector3 by_others;  ///< of that, what the other contacts do in the whole step
};

/// The spring over the step that `normal` describes, in the plane across n. `memory` is what the
/// last step left, `answer` the inverse mass that answers the spring's impulse.
///
/// The spring's displacement is known on the grid, where it has grown with the grid's motion, and
/// is carried half a step back to where the step begins, like positions. Were it added up from
/// the steps as the pair sees them, each alone against its own tangential force, a spring under a
/// constant load that others balance would creep.
inline SpringStep follow_spring(const contact::TangentialSpring& law, const PairStep& normal,
                                const StepWindow& window, const Vector3& n, const Vector3& memory,
                                const SpringVelocity& velocity, double answer) {
  Vector3 displacement = contact::TangentialSpring::turned(memory, n);
  if (dot(memory, memory) > 0.0)
    displacement += window.before * (velocity.start - velocity.by_others);
  contact::TangentialStep spring =
      law.advance(displacement, velocity.start, normal.normal.contact_time, answer,
                  normal.normal.repulsion_impulse, normal.normal.repulsion_at_end);
  Vector3 left = spring.displacement - window.after * (velocity.start + answer * spring.impulse);
  if (normal.overlap_at_end <= 0.0) {  // parted: what the spring still held is lost
    spring.friction += law.stored_energy(spring.displacement);
    spring.displacement = left = {};
  }
  return {spring, left};
}

}  // namespace cohesion::event_stepping
