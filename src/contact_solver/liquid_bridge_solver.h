// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "contact_solver/contact_solver.h"

namespace cohesion::contact_solver {

/// A liquid bridge around a contact whose grid points are exact samples of the
/// motion: ContactSolver with an adhesion that forms where the surfaces touch, and in the gap a
/// constant pull, half of which acts where a segment of the flight begins and half where it ends.
class LiquidBridgeSolver final : public ContactSolver {
 public:
  /// `bridge`: force and, as cutoff, the gap of rupture; no tail. contact_distance [length]: of the
  /// centres at touch, or the radius beside a wall; step [time].
  LiquidBridgeSolver(const contact::NormalLaw& law, const contact::Adhesion& bridge,
                     double contact_distance, double step)
      : ContactSolver(law, {bridge.force, 0.0, 0.0}, contact_distance, step, bridge.cutoff, 0.0),
        force_(bridge.force),
        pull_(bridge.force / contact::reduced_mass(law)) {}

  /// Of a pair that has its bridge, zero at touch, [energy].
  double adhesion_energy(double overlap) const override { return -force_ * overlap; }

 protected:
  double move_in_range(Flight& now, double time, double external, bool& in_range, Course& course,
                       NormalRecord& record) const override {
    course.event = true;
    if (!course.touching) return span(now, time, external, in_range, course.touching, record);
    const double taken = advance_in_range(now, time, external, course.touching, record);
    in_range = course.touching || range() > 0.0;
    return taken;
  }

 private:
  /// In the gap, up to touch or rupture. One that other forces pulled beyond the gap of rupture has
  /// none.
  double span(Flight& now, double time, double external, bool& inside, bool& touching,
              NormalRecord& record) const {
    const double outer = outer_distance();
    if (now.distance > outer) {
      rupture(now.distance, inside, record);
      return 0.0;
    }
    const double drive = now.outward(external) - pull_;
    // Rounding may leave a pair that just parted at an overlap.
    const double gap = std::max(now.distance - contact_distance(), 0.0);
    const double touches = first_root(gap, now.radial, drive);
    const double breaks = first_root(outer - now.distance, -now.radial, -drive);
    const double t = std::min(touches, breaks);
    now = pulled(now, std::min(t, time), external);
    if (t >= time) return time;
    touching = touches < breaks;
    if (!touching) rupture(outer, inside, record);
    return t;
  }

  void rupture(double distance, bool& inside, NormalRecord& record) const {
    inside = false;
    record.dissipated += force_ * (distance - contact_distance());
  }

  /// After a segment of the bridge's pull, of which half acts where it begins and half where it
  /// ends.
  Flight pulled(Flight start, double time, double external) const {
    start.radial -= 0.5 * time * pull_;
    Flight end = start.after(time, external);
    end.radial -= 0.5 * time * pull_;
    return end;
  }

  double force_;
  double pull_;
};

}  // namespace cohesion::contact_solver
