// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "event_stepping/one_pass_contact.h"
#include "square_well/impulses.h"

namespace cohesion::event_stepping {

/// A square well around a linear spring-dashpot whose grid points are exact samples of the motion:
/// OnePassContact with the well in the place of the adhesion.
///
/// Inside without contact the pair flies as outside: straight across its normal, along it under
/// what others cause. At the edge it gets the impulse of approach, escape or capture
/// (square_well/impulses.h) when it is there. So the well may be as wide as the particles. A pair
/// in its well that meets neither edge nor contact has exactly no force.
///
/// Which surface is next is decided by what is remembered and the sense of the motion, not by the
/// distance alone: one that others pushed beyond the edge has its event when it moves that way.
///
/// Source: square_well/impulses.h (impulses at the edge), one_pass_contact.h (contact).
class OnePassWell final : public OnePassContact {
 public:
  /// `well`: no force; `cutoff` the gap at the edge, `tail_energy` the depth. contact_distance
  /// [length]: of the centres at touch, or the radius beside a wall; step [time].
  OnePassWell(const contact::LinearSpringDashpot& spring, const contact::Adhesion& well,
              double contact_distance, double step)
      : OnePassContact(spring, well.cutoff > 0.0 ? contact::Adhesion{} : well, contact_distance,
                       step, well.cutoff, well.cutoff),
        depth_(well.tail_energy),
        inverse_mass_(1.0 / spring.reduced_mass()) {}

  GridStep follow(const GridPoint& at, double others, double kick,
                  GridMemory& memory) const override {
    if (memory.phase == GridMemory::within && meets_nothing(at, others)) {
      memory.work = work_before(at, memory);
      memory.force = 0.0;
      return {};
    }
    if (range() == 0.0) return OnePassContact::follow(at, others, kick, memory);
    return follow_by(at, others, kick, memory,
                     [&](Flight& now, bool& inside, NormalRecord& record) {
                       return move(now, others, inside, record);
                     });
  }

  /// The energy of a pair in the well, wherever it is, [energy].
  double adhesion_energy(double /*overlap*/) const override { return -depth_; }

 private:
  /// Whether the pair is farther from contact and edge than it can fly, as most pairs in their
  /// wells are.
  bool meets_nothing(const GridPoint& at, double others) const {
    const double way = step() * (std::abs(at.radial) + at.sideways + step() * std::abs(others));
    return at.distance > contact_distance() + way && at.distance < outer_distance() - way;
  }

  /// Follows everything that can happen to a pair in a step; returns whether anything did.
  bool move(Flight& now, double others, bool& inside, NormalRecord& record) const {
    bool event = false;
    const auto fall_in = [&] {
      approach(now);
      event = true;
    };
    if (!inside) {
      inside = starts_inside(now);
      if (inside) fall_in();
    }
    double left = step();
    for (int segments = 0; left > 0.0; segments++) {
      if (segments == max_segments) {
        record.unresolved = true;
        break;
      }
      if (!inside) {
        left -= fly(now, left, others, inside);
        if (inside) fall_in();
        continue;
      }
      const double touch = time_to_touch(now, others), out = time_to_edge(now, others);
      const double next = std::min(touch, out);
      if (next >= left) {
        now = after(now, left, others);
        break;
      }
      event = true;
      const bool touches = touch <= out;
      double t = next;
      if (t > 0.0)
        now = at_meeting(now, t, left, others, touches ? contact_distance() : outer_distance());
      left -= t;
      if (touches) {
        bool touching = true;
        left -= advance_inside(now, left, others, touching, record);
        if (record.unresolved) break;
      } else {
        inside = !leave(now);
        if (inside) left -= whole_bounces(now, left, others);
      }
    }
    return event;
  }

  double time_to_touch(const Flight& now, double others) const {
    const double gap = now.distance - contact_distance();
    const double drive = outward_in_flight(now, others);
    const bool approaches = now.radial < 0.0 || (now.radial == 0.0 && drive < 0.0);
    if (gap < 0.0 || (gap == 0.0 && approaches)) return 0.0;
    return first_root(gap, now.radial, drive);
  }

  /// A pair beyond its edge that comes back has not left it.
  double time_to_edge(const Flight& now, double others) const {
    const double gap = std::max(outer_distance() - now.distance, 0.0);
    if (gap == 0.0 && now.radial > 0.0) return 0.0;
    return first_root(gap, -now.radial, -outward_in_flight(now, others));
  }

  /// Gives the impulse of approach. A pair that others pushed inside may already part; it does so
  /// faster then.
  void approach(Flight& now) const {
    const double u = std::abs(now.radial);
    const double faster =
        u - inverse_mass_ * square_well::approach_impulse(u, depth_, inverse_mass_);
    now.radial = now.radial > 0.0 ? faster : -faster;
  }

  /// Gives the impulse at the edge to a pair that moves out; returns false where it is turned back.
  bool leave(Flight& now) const {
    const double u = -now.radial;
    const bool escapes = square_well::escapes(u, depth_, inverse_mass_);
    now.radial += inverse_mass_ * (escapes ? square_well::escape_impulse(u, depth_, inverse_mass_)
                                           : square_well::capture_impulse(u, inverse_mass_));
    return escapes;
  }

  /// Skips the bounces, within `time`, of a pair that its turning or others press against the edge:
  /// whole ones leave it as it is. Returns the time they take.
  double whole_bounces(const Flight& now, double time, double others) const {
    const double drive = outward_in_flight(now, others);
    if (drive <= 0.0 || now.radial * now.radial >= 2.0 * drive * range()) return 0.0;
    const double period = -2.0 * now.radial / drive;
    return std::floor(time / period) * period;
  }

  double depth_;
  double inverse_mass_;
};

}  // namespace cohesion::event_stepping
