// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_solver/contact_solver.h"

namespace cohesion::contact_solver {

/// JKR's contact (contact/jkr_spring_dashpot.h): ContactSolver with a contact that begins at touch
/// and lasts until the neck tears, beyond touch. What surfaces gain where the neck forms, and what
/// it stores where it tears, is lost.
class JkrSolver final : public ContactSolver {
 public:
  /// law: Hertz's, or JKR's with an attraction of its own. contact_distance [length]: of the
  /// centres at touch, or the radius beside a wall; step [time].
  JkrSolver(const contact::NormalLaw& law, const contact::Adhesion& /*attraction*/,
            double contact_distance, double step)
      : ContactSolver(law, {}, contact_distance, step, -contact::lowest_overlap(law), 0.0),
        touch_energy_(contact::point_of(law, 0.0).energy) {}

  /// All of it is the spring's, [energy].
  double adhesion_energy(double /*overlap*/) const override { return 0.0; }

 protected:
  double move_in_range(Flight& now, double time, double external, bool& in_range,
                       StepCourse& course, NormalRecord& record) const override {
    course.event = true;
    if (course.entered) record.dissipated -= touch_energy_;
    course.entered = false;
    return advance_in_contact(now, time, external, in_range, record);
  }

 private:
  double touch_energy_;
};

}  // namespace cohesion::contact_solver
