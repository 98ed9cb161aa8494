// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "event_stepping/first_root.h"
#include "event_stepping/loaded_flight.h"
#include "event_stepping/pair_step.h"
#include "event_stepping/sphere_pair.h"

namespace cohesion::event_stepping {

/// Two spheres whose adhesion forms where their surfaces touch and ends at a gap: a liquid bridge
/// (liquid_bridge/parameters.h). `inside` says that there is one.
///
/// The relative motion at n-1/2 is followed exactly to n+1/2: straight flight to the touch; contact
/// under the constant force as SpherePair follows it; and in the gap, along the line of centres,
/// the parabola of the constant force, up to touch or rupture, whichever comes first. The pair may
/// turn in the gap: half of the impulse of a segment acts where it begins and half where it ends,
/// which keeps the angular momentum exactly and is exact head-on. So the gap may be as wide as the
/// particles.
///
/// The energy of a bridge is counted from the touch, F_b h in the gap: its formation changes
/// nothing, and what it holds where it breaks, F_b h_r, counts as dissipated.
class BridgePair {
 public:
  using Attraction = contact::Adhesion;

  /// `bridge`: force and, as cutoff, the gap of rupture; no tail. `step` [time]: the usual length
  /// of a step.
  BridgePair(const contact::LinearSpringDashpot& spring, const contact::Adhesion& bridge,
             double contact_distance, double step)
      : contact_(spring, {bridge.force, 0.0, 0.0}, contact_distance, step),
        core_(contact_distance),
        range_(bridge.cutoff),
        force_(bridge.force),
        pull_(bridge.force / spring.reduced_mass()) {}

  double range() const { return range_; }
  double spring_energy(double overlap) const { return contact_.spring_energy(overlap); }
  /// Of a pair that has its bridge, zero at touch.
  double adhesion_energy(double overlap) const { return -force_ * overlap; }

  /// Whether anything can happen to the pair within the window.
  bool within_reach(const RelativeState& grid, const StepWindow& window) const {
    const double slack = std::max(window.before, window.after) * norm(grid.velocity);
    const double reach = core_ + range_ + slack;
    return dot(grid.separation, grid.separation) <= reach * reach;
  }

  /// `load`: as in SpherePair.
  PairStep advance(const RelativeState& grid, const StepWindow& window, bool inside,
                   const Vector3& load = {}) const {
    PairStep step;
    Motion m{{grid.separation - window.before * grid.velocity, grid.velocity}, apart, 0.0};
    // One that others pushed into contact has touched.
    if (dot(m.at.separation, m.at.separation) < core_ * core_)
      m.state = in_contact;
    else if (inside)
      m.state = spanned;
    bool flies = true;
    double left = window.length();
    for (int segments = 0; left > 0.0; segments++) {
      if (segments == max_segments) {
        step.normal.unresolved = true;
        break;
      }
      if (m.state == apart) {
        left -= fly(m, left, load);
        continue;
      }
      flies = false;
      left -= m.state == in_contact ? touch(m, left, load, step.normal)
                                    : span(m, left, load, step.normal);
      if (step.normal.unresolved) break;
    }
    step.inside = m.state != apart;
    step.overlap_at_end = m.state == in_contact ? m.overlap : core_ - norm(m.at.separation);
    step.interacts = !flies;
    if (flies) return step;  // not to carry the rounding of no change into the motion
    step.set_change(grid, window, load, m.at);
    return step;
  }

 private:
  /// A pair falls back into contact after each of its bounces, of which a step holds few: more
  /// often only by rounding.
  static constexpr int max_segments = 1000;

  enum State { apart, spanned, in_contact };
  struct Motion {
    RelativeState at;
    State state;
    double overlap;  ///< in contact
  };

  /// Up to the touch.
  double fly(Motion& m, double time, const Vector3& load) const {
    const double wait = time_to_fall_to(core_, m.at, load, time);
    if (wait < time) m.state = in_contact;
    const double taken = std::min(wait, time);
    m.at = flown(m.at, load, taken);
    return taken;
  }

  double touch(Motion& m, double time, const Vector3& load, NormalRecord& record) const {
    bool touching = true;
    const double taken = contact_.advance_inside(m.at, time, touching, m.overlap, record, load);
    if (!touching) m.state = range_ > 0.0 ? spanned : apart;
    return taken;
  }

  /// In the gap, up to touch or rupture. One that others pulled beyond the gap of rupture has none.
  double span(Motion& m, double time, const Vector3& load, NormalRecord& record) const {
    const double outer = core_ + range_, distance = norm(m.at.separation);
    const double radial = dot(m.at.separation, m.at.velocity) / distance;
    if (distance > outer) {
      rupture(m, distance, record);
      return 0.0;
    }
    const double across = std::max(dot(m.at.velocity, m.at.velocity) - radial * radial, 0.0);
    const double pull = pull_ - dot(m.at.separation, load) / distance;
    const double drive = across / distance - pull;
    // Rounding may leave a pair that just parted at an overlap.
    const double gap = std::max(distance - core_, 0.0);
    const double touches = first_root(gap, radial, drive);
    const double breaks = first_root(outer - distance, -radial, -drive);
    const double t = std::min(touches, breaks);
    m.at = pulled(m.at, pull, std::min(t, time));
    if (t >= time) return time;
    if (touches < breaks)
      m.state = in_contact;
    else
      rupture(m, outer, record);
    return t;
  }

  void rupture(Motion& m, double distance, NormalRecord& record) const {
    m.state = apart;
    record.dissipated += force_ * (distance - core_);
  }

  /// After a segment of the `pull` of bridge and load, [length/time^2].
  static RelativeState pulled(const RelativeState& start, double pull, double time) {
    const double kick = 0.5 * time * pull;
    RelativeState end = start;
    end.velocity -= (kick / norm(start.separation)) * start.separation;
    end.separation += time * end.velocity;
    end.velocity -= (kick / norm(end.separation)) * end.separation;
    return end;
  }

  SpherePair contact_;
  double core_;
  double range_;
  double force_;
  double pull_;
};

/// A sphere and a plane, with the separation from the sphere's centre to the foot of the normal:
/// only its length changes.
class BridgePlane : public BridgePair {
 public:
  using BridgePair::BridgePair;

  PairStep advance(const RelativeState& grid, const StepWindow& window, bool inside,
                   const Vector3& load = {}) const {
    const Vector3& s = grid.separation;
    const double inverse = 1.0 / dot(s, s);
    return BridgePair::advance({s, (inverse * dot(s, grid.velocity)) * s}, window, inside,
                               (inverse * dot(s, load)) * s);
  }
};

}  // namespace cohesion::event_stepping
