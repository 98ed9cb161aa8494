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
  Vector3 on_grid;  ///< between where the step begins and the grid
  Vector3 mean;     ///< in the step, without the spring itself
  Vector3 at_end;   ///< between where the step ends and the grid, without the spring itself

  /// `before`: what others act on, with half of what the normal motion does.
  explicit SpringVelocity(const Vector3& before) : on_grid(before), mean(before), at_end(before) {}

  /// Adds what the other contacts change of it in the whole step, `by_others`, and what the other
  /// spring of the same contact does, `by_partner` (nullptr: there is none).
  void add(const Vector3& by_others, const Vector3* by_partner) {
    on_grid -= 0.5 * by_others;
    mean += 0.5 * (by_partner ? by_others + *by_partner : by_others);
    at_end += 0.5 * by_others;
    if (by_partner) at_end += *by_partner;
  }
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
    displacement = plane.turned_into(memory) + window.before * velocity.on_grid;
  contact::TangentialStep spring =
      law.advance(displacement, velocity.mean, normal.normal.contact_time, answer,
                  normal.normal.repulsion_impulse, normal.normal.repulsion_at_end);
  Vector3 left = spring.displacement - window.after * (velocity.at_end + answer * spring.impulse);
  if (normal.overlap_at_end <= 0.0) {  // parted: what the spring still held is lost
    spring.friction += law.stored_energy(spring.displacement);
    spring.displacement = left = {};
  }
  return {spring, left};
}

}  // namespace cohesion::event_stepping
