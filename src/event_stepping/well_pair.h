// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "event_stepping/loaded_flight.h"
#include "event_stepping/pair_step.h"
#include "event_stepping/sphere_pair.h"
#include "square_well/impulses.h"

namespace cohesion::event_stepping {

/// Two spheres with a square well around a spring-dashpot contact.
///
/// The relative motion at n-1/2 is followed exactly to n+1/2. Outside contact the pair flies
/// straight: to the edge of the well from outside; from inside to the contact or the edge,
/// whichever comes first. At the edge it gets the impulse of approach, escape or capture at the
/// time at which it is there. In contact it turns as SpherePair does. No approximation is made but
/// SpherePair's, so that the well may be as wide as the particles.
///
/// Which surface is next is decided by the flag `inside` and the sense of the motion, not by the
/// distance alone (hard_sphere/crossing.h): what other contacts do to a pair between two steps can
/// put it beyond the edge or short of it. It has its event then as soon as it moves that way.
///
/// Source: square_well/impulses.h (impulses at the edge), sphere_pair.h (contact).
class WellPair {
 public:
  /// No force; `cutoff` the gap at the edge, `tail_energy` the depth.
  using Attraction = contact::Adhesion;

  /// `step` [time]: the usual length of a step.
  WellPair(const contact::LinearSpringDashpot& spring, const contact::Adhesion& well,
           double contact_distance, double step)
      : WellPair(spring, well, contact_distance, contact_distance, step) {}

  double range() const { return range_; }
  double spring_energy(double overlap) const { return contact_.spring_energy(overlap); }
  /// The energy of a pair in the well, wherever it is, [energy].
  double adhesion_energy(double /*overlap*/) const { return -depth_; }

  bool within_reach(const RelativeState& grid, const StepWindow& window) const {
    const double slack = std::max(window.before, window.after) * norm(grid.velocity);
    const double reach = edge_ + slack;
    return dot(grid.separation, grid.separation) <= reach * reach;
  }

  /// Whether a pair in its well is farther from contact and edge than `way` [length].
  bool is_clear_by(double way, const Vector3& separation) const {
    const double inner = core_ + way, outer = edge_ - way;
    const double square = dot(separation, separation);
    return outer > 0.0 && square > inner * inner && square < outer * outer;
  }

  /// `load`: as in SpherePair.
  PairStep advance(const RelativeState& grid, const StepWindow& window, bool inside,
                   const Vector3& load = {}) const {
    if (edge_ == core_) return contact_.advance(grid, window, inside, load);
    PairStep step;
    if (inside && meets_nothing(grid, window, load)) {
      step.inside = true;
      step.interacts = false;
      step.overlap_at_end = core_ - norm(grid.separation + window.after * grid.velocity);
      return step;
    }
    Motion m{{grid.separation - window.before * grid.velocity, grid.velocity}, inside, false, 0.0};
    m.touching = dot(m.at.separation, m.at.separation) < core_ * core_;
    // Both are in the contact: one that was pushed there from outside the well fell into it.
    if (m.touching && !m.inside) approach(m);
    double left = window.length();
    bool flies = true;
    for (int segments = 0; left > 0.0; segments++) {
      if (segments == max_segments) {
        step.normal.unresolved = true;
        break;
      }
      const Meeting next = m.touching ? Meeting{0.0, contact} : next_meeting(m, load, left);
      if (next.wait >= left) {
        m.at = flown(m.at, load, left);
        break;
      }
      flies = false;
      m.at = flown(m.at, load, next.wait);
      left -= next.wait;
      if (next.with == contact) {
        left -= advance_contact(m, left, step.normal, load);
      } else if (next.with == edge_from_outside) {
        approach(m);
      } else {
        leave(m);
        if (m.inside) left -= rest_at_edge(m, left, load, step.normal);
      }
      if (step.normal.unresolved) break;
    }
    step.inside = m.inside;
    step.overlap_at_end = m.touching ? m.overlap : core_ - norm(m.at.separation);
    step.interacts = !flies;
    if (flies) return step;  // not to carry the rounding of no change into the motion
    step.set_change(grid, window, load, m.at);
    return step;
  }

 protected:
  /// `core` [length]: the distance at which contact begins; 0: contact is followed elsewhere.
  WellPair(const contact::LinearSpringDashpot& spring, const contact::Adhesion& well,
           double contact_distance, double core, double step)
      : contact_(spring, well.cutoff > 0.0 ? contact::Adhesion{} : well, contact_distance, step),
        core_(core),
        edge_(contact_distance + well.cutoff),
        range_(well.cutoff),
        depth_(well.tail_energy),
        inverse_mass_(1.0 / spring.reduced_mass()) {}

 private:
  /// More than any well has that is wide enough to be one; a pair along whose edge nearly nothing
  /// moves could have any number of captures.
  static constexpr int max_segments = 1000;
  /// Normal speed over speed that is rounding.
  static constexpr double rounding = 1e-15;

  enum Surface { contact, edge_from_outside, edge_from_inside };
  struct Meeting {
    double wait;  ///< [time]
    Surface with;
  };
  struct Motion {
    RelativeState at;
    bool inside;
    bool touching;
    double overlap;  ///< while touching
  };

  /// Whether the pair is farther from contact and edge than it can fly, as most pairs in their
  /// wells are.
  bool meets_nothing(const RelativeState& grid, const StepWindow& window,
                     const Vector3& load) const {
    const double length = window.length();
    return is_clear_by(std::max(window.before, window.after) * norm(grid.velocity) +
                           0.5 * length * length * norm(load),
                       grid.separation);
  }

  /// What is met next, if anything is within `time`.
  Meeting next_meeting(const Motion& m, const Vector3& load, double time) const {
    if (!m.inside) return {time_to_fall_to(edge_, m.at, load, time), edge_from_outside};
    const double fall = core_ > 0.0 ? time_to_fall_to(core_, m.at, load, time) : hard_sphere::never;
    if (is_none(load)) {
      if (fall < hard_sphere::never) return {fall, contact};
      // Along the edge: neither in nor out.
      const double b = dot(m.at.separation, m.at.velocity);
      const double ww = dot(m.at.velocity, m.at.velocity);
      const double rr = dot(m.at.separation, m.at.separation);
      if (rr >= edge_ * edge_ && b * b <= rounding * rounding * rr * ww)
        return {hard_sphere::never, edge_from_inside};
    }
    const double rise = time_to_rise_to(edge_, m.at, load, time);
    if (fall <= rise) return {fall, contact};
    return {rise, edge_from_inside};
  }

  /// Brings to rest a captured pair that `load` presses against the edge from inside, too slowly to
  /// leave it for a hundredth of `time`: its bounces never end, and an edge without width carries
  /// any load. Returns the time that is left, all of it at rest along the normal; the pair goes on
  /// across it.
  double rest_at_edge(Motion& m, double time, const Vector3& load, NormalRecord& record) const {
    const double distance = norm(m.at.separation);
    const Vector3 normal = (1.0 / distance) * m.at.separation;
    const double rate = dot(normal, m.at.velocity), outward = dot(normal, load);
    if (!(outward > 0.0) || -2.0 * rate > 0.01 * time * outward) return 0.0;
    record.dissipated += 0.5 / inverse_mass_ * rate * rate;
    m.at.velocity -= rate * normal;
    const Vector3 there = m.at.separation + time * m.at.velocity;
    m.at.separation = (edge_ / norm(there)) * there;
    const Vector3 end = (1.0 / edge_) * m.at.separation;
    m.at.velocity -= dot(end, m.at.velocity) * end;
    return time;
  }

  /// Changes the velocity by the impulse J(u), u the speed of approach.
  template <class Impulse>
  void push(Motion& m, Impulse impulse) const {
    const Vector3 normal = (1.0 / norm(m.at.separation)) * m.at.separation;
    m.at.velocity += inverse_mass_ * impulse(-dot(normal, m.at.velocity)) * normal;
  }

  /// A pair that others pushed into the contact may already part; it does so faster then.
  void approach(Motion& m) const {
    push(m, [&](double u) {
      const double in = square_well::approach_impulse(std::abs(u), depth_, inverse_mass_);
      return u < 0.0 ? -in : in;
    });
    m.inside = true;
  }

  void leave(Motion& m) const {
    push(m, [&](double u) {
      m.inside = !square_well::escapes(u, depth_, inverse_mass_);
      return m.inside ? square_well::capture_impulse(u, inverse_mass_)
                      : square_well::escape_impulse(u, depth_, inverse_mass_);
    });
  }

  double advance_contact(Motion& m, double time, NormalRecord& record, const Vector3& load) const {
    m.touching = true;
    return contact_.advance_inside(m.at, time, m.touching, m.overlap, record, load);
  }

  SpherePair contact_;
  double core_;
  double edge_;
  double range_;
  double depth_;
  double inverse_mass_;
};

}  // namespace cohesion::event_stepping
