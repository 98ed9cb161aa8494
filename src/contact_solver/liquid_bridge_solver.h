// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact_solver/contact_solver.h"
#include "liquid_bridge/pull.h"

namespace cohesion::contact_solver {

/// A liquid bridge around a contact whose grid points are exact samples of the motion:
/// ContactSolver with an adhesion that forms where the surfaces touch, and in the gap a pull. The
/// flight there is in segments, each under the mean of the pull between the gaps where it begins
/// and ends, half of which acts at each end. A segment of a head-on pair so takes just the work of
/// the pull, however long it is: whether a pair parts does not depend on the step. A pull that
/// falls limits the segments, for the course in the gap.
class LiquidBridgeSolver final : public ContactSolver {
 public:
  /// `bridge`: force and its fall, and as cutoff the gap of rupture; no tail. contact_distance
  /// [length]: of the centres at touch, or the radius beside a wall; step [time].
  LiquidBridgeSolver(const contact::NormalLaw& law, const contact::Adhesion& bridge,
                     double contact_distance, double step)
      : ContactSolver(law, {bridge.force, 0.0, 0.0}, contact_distance, step, bridge.cutoff, 0.0),
        pull_(bridge.pull()),
        inverse_mass_(1.0 / contact::reduced_mass(law)) {}

  /// Of a pair that has its bridge, zero at touch, [energy].
  double adhesion_energy(double overlap) const override { return pull_.work(-overlap); }

 protected:
  double move_in_range(Flight& now, double time, double external, bool& in_range,
                       StepCourse& course, NormalRecord& record) const override {
    course.event = true;
    if (!course.touching) return span(now, time, external, in_range, course.touching, record);
    const double taken = advance_in_range(now, time, external, course.touching, record);
    in_range = course.touching || range() > 0.0;
    return taken;
  }

 private:
  /// Longest way of a segment, of L + S: its pull changes by less than a third.
  static constexpr double longest_way = 0.125;

  /// In the gap, up to touch or rupture. One that other forces pulled beyond the gap of rupture has
  /// none.
  double span(Flight& now, double time, double external, bool& inside, bool& touching,
              NormalRecord& record) const {
    double taken = 0.0;
    while (taken < time && inside && !touching) {
      if (now.distance > outer_distance())
        rupture(now.distance, inside, record);
      else
        taken += segment(now, time - taken, external, inside, touching, record);
    }
    return taken;
  }

  double segment(Flight& now, double time, double external, bool& inside, bool& touching,
                 NormalRecord& record) const {
    const double outer = outer_distance(), outward = now.outward(external);
    // Rounding may leave a pair that just parted at an overlap.
    const double gap = std::max(now.distance - contact_distance(), 0.0);
    const double to_touch = inverse_mass_ * pull_.mean(gap, 0.0);
    const double to_rupture = inverse_mass_ * pull_.mean(gap, range());
    const double touches = first_root(gap, now.radial, outward - to_touch);
    const double breaks = first_root(outer - now.distance, -now.radial, to_rupture - outward);
    const double whole = std::min(time, longest_segment(now, gap, outward));
    const double t = std::min(touches, breaks);
    if (t >= whole) {
      now = after(now, gap, whole, external);
      return whole;
    }
    touching = touches < breaks;
    now = pulled(now, t, external, touching ? to_touch : to_rupture);
    if (!touching) rupture(outer, inside, record);
    return t;
  }

  void rupture(double distance, bool& inside, NormalRecord& record) const {
    inside = false;
    record.dissipated += pull_.work(distance - contact_distance());
  }

  double longest_segment(const Flight& now, double gap, double outward) const {
    if (pull_.fall == 0.0) return std::numeric_limits<double>::infinity();
    const double way = longest_way * (pull_.fall + gap);
    const double acceleration = std::abs(outward) + inverse_mass_ * pull_.at(gap);
    return way / (std::abs(now.radial) + std::sqrt(way * acceleration));
  }

  /// After a segment without an event. The pull depends on where it ends, of which each estimate is
  /// at least ten times better than the one before.
  Flight after(const Flight& start, double gap, double time, double external) const {
    constexpr int estimates = 20;
    Flight end = pulled(start, time, external, inverse_mass_ * pull_.at(gap));
    for (int k = 0; k < estimates && pull_.fall > 0.0; k++) {
      const double last = end.distance;
      const double end_gap = std::max(last - contact_distance(), 0.0);
      end = pulled(start, time, external, inverse_mass_ * pull_.mean(gap, end_gap));
      if (std::abs(end.distance - last) <= std::numeric_limits<double>::epsilon() * last) break;
    }
    return end;
  }

  /// After a time under a pull [length/time^2], of which half acts where it begins and half where
  /// it ends.
  static Flight pulled(Flight start, double time, double external, double pull) {
    start.radial -= 0.5 * time * pull;
    Flight end = start.after(time, external);
    end.radial -= 0.5 * time * pull;
    return end;
  }

  liquid_bridge::Pull pull_;
  double inverse_mass_;
};

}  // namespace cohesion::contact_solver
