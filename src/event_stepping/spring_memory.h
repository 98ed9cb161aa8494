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

/// How fast the ends of a spring part in a step, [length/time].
struct SpringVelocity {
  Vector3 before;        ///< others act, with half of what the normal motion does
  Vector3 by_others{};   ///< what the other contacts change of it in the whole step
  Vector3 by_partner{};  ///< what the other spring of the same contact changes of it
};

/// The spring over the step that `normal` describes, in the plane of contact. `memory` is what the
/// last step left, `answer` the inverse mass that answers the spring's impulse.
///
/// The spring's displacement is known on the grid, where it has grown with the grid's motion, and
/// is carried half a step back to where the step begins, and at the end on to the grid again. Were
/// it added up from the steps as the pair sees them, each alone against its own tangential force, a
/// spring under a constant load that others balance would creep. Other contacts shift both ends of
/// the step alike, by what they do in a quarter of it, as they shift the normal motion: carried
/// with the grid's velocity at either end instead, dense gases lose thirty times as much energy
/// that nobody books. The other spring of the contact begins and ends where this one does and
/// shifts nothing.
inline SpringStep follow_spring(const contact::TangentialSpring& law, const PairStep& normal,
                                const StepWindow& window, const contact::Plane& plane,
                                const Vector3& memory, const SpringVelocity& velocity,
                                double answer) {
  Vector3 displacement{};
  if (dot(memory, memory) > 0.0)
    displacement =
        plane.turned_into(memory) + window.before * (velocity.before - 0.5 * velocity.by_others);
  contact::TangentialStep spring =
      law.advance(displacement, velocity.before + 0.5 * (velocity.by_others + velocity.by_partner),
                  normal.normal.contact_time, answer, normal.normal.repulsion_impulse,
                  normal.normal.repulsion_at_end);
  Vector3 left =
      spring.displacement - window.after * (velocity.before + 0.5 * velocity.by_others +
                                            velocity.by_partner + answer * spring.impulse);
  if (normal.overlap_at_end <= 0.0) {  // parted: what the spring still held is lost
    spring.friction += law.stored_energy(spring.displacement);
    spring.displacement = left = {};
  }
  return {spring, left};
}

}  // namespace cohesion::event_stepping
