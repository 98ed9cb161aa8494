// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/normal_law.h"
#include "contact_solver/first_root.h"
#include "contact_solver/flight.h"
#include "contact_solver/normal_motion.h"

namespace cohesion::contact_solver {

/// What can happen to a pair within a step, integrated from its true motion at a time level: flight
/// outside the range of the adhesion, its edge, and contact (normal_motion.h).
class PairCourse {
 public:
  virtual ~PairCourse() = default;

  double range() const { return range_; }
  /// Distance up to which a pair is in range, [length].
  double outer_distance() const { return contact_distance_ + range_; }
  /// Distance up to which a pair comes into range, [length].
  double entry_distance() const { return contact_distance_ + entry_; }
  double step() const { return step_; }
  /// What moves the pair in contact.
  const ContactMotion& contact() const { return motion_.contact(); }

  double spring_energy(double overlap) const { return motion_.spring_energy(overlap); }
  virtual double adhesion_energy(double overlap) const { return motion_.adhesion_energy(overlap); }

 protected:
  /// contact_distance [length]: of the centres at touch, or the radius next to a wall; step [time];
  /// range, entry [length]: gaps up to which a pair is inside, and at which it comes inside.
  PairCourse(const contact::NormalLaw& law, const contact::Adhesion& adhesion,
             double contact_distance, double step, double range, double entry)
      : motion_(law, adhesion, step),
        contact_distance_(contact_distance),
        range_(range),
        entry_(entry),
        step_(step) {}

  double contact_distance() const { return contact_distance_; }

  /// Integrates everything that can happen to a pair in a step; whether anything did.
  bool move(Flight& now, double external, bool& in_range, NormalRecord& record) const {
    StepCourse course{!in_range && starts_in_range(now), now.distance < contact_distance_};
    in_range = in_range || course.event;
    course.entered = course.event;
    double left = step_;
    for (int segments = 0; left > 0.0 && !record.unresolved; segments++) {
      if (segments == max_segments) {
        record.unresolved = true;
      } else if (in_range) {
        left -= move_in_range(now, left, external, in_range, course, record);
      } else {
        left -= fly(now, left, external, in_range);
        course.event = course.event || in_range;
        course.touching = course.entered = in_range;
      }
    }
    return course.event;
  }

  /// What a step has brought so far.
  struct StepCourse {
    bool event;  ///< whether anything but free flight
    /// Of a range that begins at touch: the pair is in contact, which rounding of its distance does
    /// not say where it has just touched or parted.
    bool touching;
    bool entered = false;  ///< the pair has come into range since the last call of move_in_range()
  };
  /// Moves a pair in range for at most `time`, up to the next change of what acts on it. Returns
  /// the time it took.
  virtual double move_in_range(Flight& now, double time, double external, bool& in_range,
                               StepCourse& course, NormalRecord& record) const {
    course.event = true;
    return advance_in_range(now, time, external, in_range, record);
  }

  /// Centrifugal acceleration of a turning pair.
  double turning(const Flight& now) const {
    if (!(contact_distance_ > 0.0)) return now.outward(0.0);
    const double rate = now.distance / contact_distance_ * now.sideways;
    return rate * rate / contact_distance_;
  }
  /// The same and that by other forces.
  double outward_acceleration(const Flight& now, double external) const {
    return turning(now) + external;
  }
  bool stays_in_contact(Flight& now, double outward, NormalRecord& record) const {
    Overlap s{contact_distance_ - now.distance, -now.radial};
    if (!motion_.advance_whole_step(s, outward, record)) return false;
    put(now, s);
    return true;
  }

  void put(Flight& now, const Overlap& s) const {
    const double distance = contact_distance_ - s.x;
    now = {distance, -s.v, now.sideways * now.distance / distance};
  }

  /// Advances a pair in the range of the adhesion, until it leaves it or the time is over; returns
  /// the time it took.
  double advance_in_range(Flight& now, double time, double external, bool& in_range,
                          NormalRecord& record) const {
    Overlap s{contact_distance_ - now.distance, -now.radial};
    const double taken =
        motion_.advance(s, time, outward_acceleration(now, external), in_range, record);
    put(now, s);
    return taken;
  }

  /// Moves a pair in contact for at most `time`, and returns the time it took until it parted
  /// (`touching` is then false), or `time`.
  double advance_in_contact(Flight& now, double time, double external, bool& touching,
                            NormalRecord& record) const {
    Overlap s{contact_distance_ - now.distance, -now.radial};
    const double outward = outward_acceleration(now, external);
    const double taken =
        std::visit([&](const auto& c) { return c.advance(s, time, outward, record); }, contact());
    touching = taken >= time;
    put(now, s);
    return taken;
  }

  /// Lets a pair that counts as outside, but was pushed inside, enter where it is, if it approaches
  /// or already overlaps.
  bool starts_in_range(Flight& now) const {
    if (now.distance >= entry_distance()) return false;
    if (now.radial >= 0.0 && now.distance >= contact_distance_) return false;
    enter(now);
    return true;
  }

  virtual void enter(Flight& now) const {
    now.radial = -motion_.enter({contact_distance_ - now.distance, -now.radial}).v;
  }

  /// Flies outside the range until its edge is met or the time is over; returns the time it took.
  /// Across the normal the flight is straight; along it the other forces act.
  double fly(Flight& now, double time, double external, bool& in_range) const {
    const double outer = entry_distance();
    const Flight start = now;
    double t = time;
    if (start.distance >= outer) {
      const double drive = start.outward(external);
      const bool at_edge = start.distance == outer;
      const bool comes_in = start.radial < 0.0 || (start.radial == 0.0 && drive < 0.0);
      const double meet =
          at_edge && comes_in ? 0.0 : first_root(start.distance - outer, start.radial, drive);
      if (meet < time) {
        t = meet;
        in_range = true;
      }
    }
    now = in_range ? start.at_meeting(t, time, external, outer) : start.after(t, external);
    if (in_range) enter(now);
    return t;
  }

 private:
  /// A pair flies in, turns and flies out again; more often only by rounding at a grazed edge.
  static constexpr int max_segments = 100;

  NormalMotion motion_;
  double contact_distance_;
  double range_;
  double entry_;
  double step_;
};

}  // namespace cohesion::contact_solver
