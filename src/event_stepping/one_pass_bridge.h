// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "event_stepping/one_pass_contact.h"

namespace cohesion::event_stepping {

/// A liquid bridge around a linear spring-dashpot whose grid points are exact samples of the
/// motion: OnePassContact with an adhesion that forms where the surfaces touch, and in the gap the
/// motion of BridgePair (bridge_pair.h).
class OnePassBridge final : public OnePassContact {
 public:
  /// `bridge`: force and, as cutoff, the gap of rupture; no tail. contact_distance [length]: of the
  /// centres at touch, or the radius beside a wall; step [time].
  OnePassBridge(const contact::LinearSpringDashpot& spring, const contact::Adhesion& bridge,
                double contact_distance, double step)
      : OnePassContact(spring, {bridge.force, 0.0, 0.0}, contact_distance, step, bridge.cutoff,
                       0.0),
        force_(bridge.force),
        pull_(bridge.force / spring.reduced_mass()) {}

  GridStep follow(const GridPoint& at, double others, double kick,
                  GridMemory& memory) const override {
    return follow_by(at, others, kick, memory,
                     [&](Flight& now, bool& inside, NormalRecord& record) {
                       return move(now, others, inside, record);
                     });
  }

  /// Of a pair that has its bridge, zero at touch, [energy].
  double adhesion_energy(double overlap) const override { return -force_ * overlap; }

 private:
  /// Everything that can happen to a pair in a step; whether anything did.
  bool move(Flight& now, double others, bool& inside, NormalRecord& record) const {
    if (!inside) inside = starts_inside(now);
    bool event = inside, touching = inside && now.distance < contact_distance();
    double left = step();
    for (int segments = 0; left > 0.0; segments++) {
      if (segments == max_segments) {
        record.unresolved = true;
        break;
      }
      if (!inside) {
        left -= fly(now, left, others, inside);
        touching = inside;
        event = event || inside;
      } else if (touching) {
        left -= advance_inside(now, left, others, touching, record);
        if (record.unresolved) break;
        inside = touching || range() > 0.0;
      } else {
        left -= span(now, left, others, inside, touching, record);
      }
    }
    return event;
  }

  /// In the gap, up to touch or rupture. One that others pulled beyond the gap of rupture has none.
  double span(Flight& now, double time, double others, bool& inside, bool& touching,
              NormalRecord& record) const {
    const double outer = outer_distance();
    if (now.distance > outer) {
      rupture(now.distance, inside, record);
      return 0.0;
    }
    const double drive = outward_in_flight(now, others) - pull_;
    // Rounding may leave a pair that just parted at an overlap.
    const double gap = std::max(now.distance - contact_distance(), 0.0);
    const double touches = first_root(gap, now.radial, drive);
    const double breaks = first_root(outer - now.distance, -now.radial, -drive);
    const double t = std::min(touches, breaks);
    now = pulled(now, std::min(t, time), others);
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
  Flight pulled(Flight start, double time, double others) const {
    start.radial -= 0.5 * time * pull_;
    Flight end = after(start, time, others);
    end.radial -= 0.5 * time * pull_;
    return end;
  }

  double force_;
  double pull_;
};

}  // namespace cohesion::event_stepping
