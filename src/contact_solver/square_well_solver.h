// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "contact_solver/contact_solver.h"
#include "square_well/impulses.h"

namespace cohesion::contact_solver {

/// A square well around a contact whose positions are exact samples of the motion:
/// ContactSolver with the well in the place of the adhesion.
///
/// Inside without contact the pair flies as outside: straight across its normal, along it under
/// what external cause. At the edge it gets the impulse of approach, escape or capture
/// (square_well/impulses.h) when it is there. So the well may be as wide as the particles. A pair
/// in its well that meets neither edge nor contact has exactly no force.
///
/// Which surface is next is decided by what is remembered and the sense of the motion, not by the
/// distance alone: one that other forces pushed beyond the edge has its event when it moves that
/// way.
///
/// Source: square_well/impulses.h (impulses at the edge), contact_solver.h (contact).
class SquareWellSolver : public ContactSolver {
 public:
  static constexpr bool may_be_idle = true;

  /// `well`: no force; `cutoff` the gap at the edge, `tail_energy` the depth. contact_distance
  /// [length]: of the centres at touch, or the radius beside a wall; step [time].
  SquareWellSolver(const contact::NormalLaw& law, const contact::Adhesion& well,
                   double contact_distance, double step)
      : ContactSolver(law, well.cutoff > 0.0 ? contact::Adhesion{} : well, contact_distance, step,
                      well.cutoff, well.cutoff),
        depth_(well.tail_energy),
        inverse_mass_(1.0 / contact::reduced_mass(law)) {}

  /// At the edge, and what is left of it in the next step.
  bool gave_impulse(const ContactState& state) const override { return state.contact_time == 0.0; }

  /// Whether a pair in the well is farther from contact and edge than `way` [length]; square
  /// [length^2]: of its distance.
  bool is_clear(double square, double way) const {
    const double inner = contact_distance() + way, outer = outer_distance() - way;
    return outer > 0.0 && square > inner * inner && square < outer * outer;
  }

  /// The energy of a pair in the well, wherever it is, [energy].
  double adhesion_energy(double /*overlap*/) const override { return -depth_; }

 protected:
  ContactStep resolve(const StaggeredMotion& now, double external, double velocity_step,
                      ContactState& state) const override {
    const bool flies = state.phase == ContactState::inside && state.force == 0.0 &&
                       state.force_before == 0.0 && meets_nothing(now, external);
    return flies ? ContactStep{} : ContactSolver::resolve(now, external, velocity_step, state);
  }

  double move_in_range(Flight& now, double time, double external, bool& in_range,
                       StepCourse& course, NormalRecord& record) const override {
    if (range() == 0.0)
      return ContactSolver::move_in_range(now, time, external, in_range, course, record);
    const double touch = time_to_touch(now, external), out = time_to_edge(now, external);
    double t = std::min(touch, out);
    if (t >= time) {
      now = now.after(time, external);
      return time;
    }
    course.event = true;
    const bool touches = touch <= out;
    if (t > 0.0)
      now = now.at_meeting(t, time, external, touches ? contact_distance() : outer_distance());
    if (touches) {
      bool touching = true;
      return t + advance_in_range(now, time - t, external, touching, record);
    }
    in_range = !leave(now);
    if (!in_range) return t;
    if (bounces_too_fast(-now.radial, now.outward(external), step()))
      return t + rest(now, time - t, external, record);
    return t + whole_bounces(now, time - t, external);
  }

  /// Gives the impulse of approach. A pair that other forces pushed inside may already part; it
  /// does so faster then.
  void enter(Flight& now) const override {
    if (range() == 0.0) return ContactSolver::enter(now);
    const double u = std::abs(now.radial);
    const double faster =
        u - inverse_mass_ * square_well::approach_impulse(u, depth_, inverse_mass_);
    now.radial = now.radial > 0.0 ? faster : -faster;
  }

 private:
  /// Whether the pair is farther from contact and edge than it can fly, as most pairs in their
  /// wells are.
  bool meets_nothing(const StaggeredMotion& now, double external) const {
    const double way = step() * (std::abs(now.rate) + now.sideways + step() * std::abs(external));
    return is_clear(now.distance * now.distance, way);
  }

  double time_to_touch(const Flight& now, double external) const {
    const double gap = now.distance - contact_distance();
    const double drive = now.outward(external);
    const bool approaches = now.radial < 0.0 || (now.radial == 0.0 && drive < 0.0);
    if (gap < 0.0 || (gap == 0.0 && approaches)) return 0.0;
    return first_root(gap, now.radial, drive);
  }

  /// A pair beyond its edge that comes back has not left it.
  double time_to_edge(const Flight& now, double external) const {
    const double gap = std::max(outer_distance() - now.distance, 0.0);
    if (gap == 0.0 && now.radial > 0.0) return 0.0;
    return first_root(gap, -now.radial, -now.outward(external));
  }

  /// Gives the impulse at the edge to a pair that moves out; returns false where it is turned back.
  bool leave(Flight& now) const {
    const double u = -now.radial;
    const bool escapes = square_well::escapes(u, depth_, inverse_mass_);
    now.radial += inverse_mass_ * (escapes ? square_well::escape_impulse(u, depth_, inverse_mass_)
                                           : square_well::capture_impulse(u, inverse_mass_));
    return escapes;
  }

  /// Brings such a pair to rest; its energy counts as the dashpot's. A load that grows has pushed
  /// it a little beyond the edge since the step before: it goes back there, where that is no
  /// farther than the load moves it in this time. Returns the time at rest.
  double rest(Flight& now, double time, double external, NormalRecord& record) const {
    record.dissipated += 0.5 / inverse_mass_ * now.radial * now.radial;
    const double beyond = now.distance - outer_distance();
    if (beyond > 0.0 && beyond <= now.outward(external) * time * time)
      now.distance = outer_distance();
    now.radial = 0.0;
    return time;
  }

  /// Skips the bounces, within `time`, of a pair that its turning or other forces press against the
  /// edge: whole ones leave it as it is. Returns the time they take.
  double whole_bounces(const Flight& now, double time, double external) const {
    const double drive = now.outward(external);
    if (drive <= 0.0 || now.radial * now.radial >= 2.0 * drive * range()) return 0.0;
    const double period = -2.0 * now.radial / drive;
    return std::floor(time / period) * period;
  }

  double depth_;
  double inverse_mass_;
};

/// The edge of a square well alone, around a contact that another style computes: the force of that
/// one acts as any other does. Exact where the well is wider than the way of a step, so that no
/// pair is in contact and at the edge within the same step.
class WellEdgeSolver final : public SquareWellSolver {
 public:
  WellEdgeSolver(const contact::NormalLaw& law, const contact::Adhesion& well,
                 double contact_distance, double step)
      : SquareWellSolver(law, {0.0, contact_distance + well.cutoff, well.tail_energy}, 0.0, step) {}

  /// The spring is the other style's.
  double spring_energy(double /*overlap*/) const { return 0.0; }
};

}  // namespace cohesion::contact_solver
