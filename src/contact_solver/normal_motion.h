// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include "contact/adhesion.h"
#include "contact/normal_law.h"
#include "contact_solver/first_root.h"
#include "contact_solver/integrated_contact.h"
#include "contact_solver/linear_contact.h"

namespace cohesion::contact_solver {

/// Motion of a pair in contact, by its normal law: in closed form, or by integration.
using ContactMotion = std::variant<LinearContact, IntegratedContact<contact::HertzSpringDashpot>,
                                   IntegratedContact<contact::JkrSpringDashpot>>;

/// attraction [force]: constant in contact; step [time].
inline ContactMotion contact_motion(const contact::NormalLaw& law, double attraction, double step) {
  if (const auto* linear = std::get_if<contact::LinearSpringDashpot>(&law))
    return LinearContact(*linear, attraction, step);
  if (const auto* hertz = std::get_if<contact::HertzSpringDashpot>(&law))
    return IntegratedContact(*hertz, attraction, step);
  return IntegratedContact(std::get<contact::JkrSpringDashpot>(law), attraction, step);
}

/// Whether a pair that a load presses against the edge of its range, with the acceleration
/// `outward` [length/time^2], and that comes back from there at `speed` [length/time], is at the
/// edge again within a quarter of the step [time]: then it rests there.
inline bool bounces_too_fast(double speed, double outward, double step) {
  return 2.0 * speed <= 0.25 * step * outward;
}

/// Exact motion of the surfaces of one pair along their common normal: free flight outside the
/// range of the adhesion (the caller's business: it depends on the geometry), constant force in the
/// gap, spring and dashpot with constant force in contact. x is the overlap,
/// negative in the gap.
///
/// The tail is an edge of height E_tail: crossed inwards with a gain in speed, outwards with a
/// loss, or, when the energy does not suffice, reflected (capture). An outward load L works on the
/// way through the tail. With the kinetic energy E at the edge and the barrier B of the tail under
/// this load (hamaker/law.h) a pair
///
///   E > E_tail         leaves at the edge with sqrt(v^2 - 2 E_tail/mu)
///   B <= E <= E_tail   flies on under the load alone, still inside, and leaves at rest where the
///                      load has done the work that is missing, (E_tail - E)/L beyond the edge;
///                      never beyond H_out
///   else               is captured
///
/// so that a slow load parts a contact at F_ad, where B is 0.
///
/// Source: derived here, see
/// docs/theory/exact_contacts.md.
class NormalMotion {
 public:
  /// `step` [time]: the usual length of a step.
  NormalMotion(const contact::NormalLaw& law, const contact::Adhesion& adhesion, double step)
      : contact_(contact_motion(law, adhesion.force, step)),
        adhesion_(adhesion),
        reduced_mass_(contact::reduced_mass(law)),
        step_(step),
        pull_(adhesion.force / reduced_mass_),
        edge_(2.0 * adhesion.tail_energy / reduced_mass_) {}

  const ContactMotion& contact() const { return contact_; }
  double range() const { return adhesion_.cutoff; }
  double reduced_mass() const { return reduced_mass_; }

  /// Enters the range at s.x: the speed gains the tail's energy and, below the edge, the work of
  /// the adhesion up to there. The direction of v is kept.
  Overlap enter(Overlap s) const {
    const double gain = edge_ + 2.0 * pull_ * within_range(s.x);
    return {s.x, std::copysign(std::sqrt(s.v * s.v + gain), s.v)};
  }

  /// Moves a contact that certainly lasts for the whole step, as advance() does. Returns false,
  /// and changes nothing, where that is not certain.
  bool advance_whole_step(Overlap& s, double outward, NormalRecord& record) const {
    return std::visit([&](const auto& c) { return c.advance_whole_step(s, outward, record); },
                      contact_);
  }

  /// Advances a pair inside the range from `s` for at most `time`, and returns the time it took
  /// until it left the range (`inside` is then false), or `time`. `outward` [length/time^2]: what
  /// pulls it apart, by its turning and by other forces. Adds what happened to `record`.
  double advance(Overlap& s, double time, double outward, bool& inside,
                 NormalRecord& record) const {
    const double drive = pull_ - outward;
    double left = time;
    inside = true;
    for (int phases = 0; inside && left > 0.0; phases++) {
      if (phases == max_phases) {
        record.unresolved = true;
        break;
      }
      const bool touching = s.x > 0.0 || (s.x == 0.0 && (s.v > 0.0 || (s.v == 0.0 && drive > 0.0)));
      if (touching)
        left -= std::visit([&](const auto& c) { return c.advance(s, left, outward, record); },
                           contact_);
      else if (!is_leaving(s, outward))
        left -= cross_gap(s, left, outward);
      if (is_leaving(s, outward)) left -= leave(s, left, outward, inside, record);
    }
    return time - std::max(left, 0.0);
  }

  /// Energy stored in the spring at overlap x, [energy].
  double spring_energy(double x) const {
    return std::visit([x](const auto& c) { return c.spring_energy(x); }, contact_);
  }

  /// Energy of the adhesion of a pair that counts as inside at overlap x, zero far away, [energy].
  /// Beyond the range that is the energy of the whole tail.
  double adhesion_energy(double x) const {
    return -adhesion_.tail_energy - adhesion_.force * within_range(x);
  }

 private:
  /// A pair that turns round this often in one step rattles in a well far too thin for the step.
  static constexpr int max_phases = 1000;

  /// How far overlap x is within the range, [length].
  double within_range(double x) const { return std::max(adhesion_.cutoff + x, 0.0); }

  /// The acceleration of a pair that is not in contact; beyond the range only its load acts.
  double drive_at(double x, double outward) const {
    return x < -adhesion_.cutoff ? -outward : pull_ - outward;
  }
  /// Whether a pair at the edge of the range, or beyond it, moves out.
  bool is_leaving(Overlap s, double outward) const {
    return s.x <= -adhesion_.cutoff && (s.v < 0.0 || (s.v == 0.0 && drive_at(s.x, outward) < 0.0));
  }

  /// What becomes of a pair that is leaving. Returns the time it took.
  double leave(Overlap& s, double time, double outward, bool& inside, NormalRecord& record) const {
    const double remaining = s.v * s.v - edge_;
    if (remaining >= 0.0 || edge_ == 0.0) {
      s.v = -std::sqrt(std::max(remaining, 0.0));
      inside = false;
      return 0.0;
    }
    const double energy = 0.5 * reduced_mass_ * s.v * s.v, load = reduced_mass_ * outward;
    const double start = s.x;
    const hamaker::Tail* const tail = adhesion_.tail;
    if (tail && outward > 0.0 && energy >= tail->barrier(load, -start, adhesion_.geometry)) {
      // To where the load has done the work that is missing; within the tail.
      const double end = start + 0.5 * remaining / outward;
      constexpr double rounding = 1e-12;  // the end may be H_out itself
      if (-end <= (1.0 + rounding) * tail->outer_cutoff()) {
        const double taken = in_gap(s, time, end, start, -outward);
        if (taken < time) {
          s = {end, 0.0};
          inside = false;
        }
        return taken;
      }
    }
    if (rests_at_edge(s, outward)) return rest(s, time, outward, record);
    // One that lost its load on the way turns round where the tail has taken its energy.
    double taken = 0.0;
    if (tail && start < -adhesion_.cutoff && energy > tail->work_up_to(-start, adhesion_.geometry))
      taken = in_gap(s, time, -tail->outer_cutoff(), start, -outward);
    if (taken < time) s.v = std::abs(s.v);
    return taken;
  }

  /// Whether the load keeps a captured pair at the edge, in bounces that do not cross the range.
  bool rests_at_edge(Overlap s, double outward) const {
    const double drive = drive_at(s.x, outward);
    const bool crosses = adhesion_.cutoff > 0.0 && s.v * s.v > 2.0 * s.x * drive;
    return drive < 0.0 && !crosses && bounces_too_fast(-s.v, -drive, step_);
  }

  /// Brings such a pair to rest; its energy counts as the dashpot's. A load that grows has pushed
  /// it a little beyond the edge since the step before: it goes back there, where that is no
  /// farther than the load moves it in this time. Returns the time at rest.
  double rest(Overlap& s, double time, double outward, NormalRecord& record) const {
    record.dissipated += 0.5 * reduced_mass_ * s.v * s.v;
    const bool pushed = -adhesion_.cutoff - s.x <= -drive_at(s.x, outward) * time * time;
    s = {pushed ? -adhesion_.cutoff : s.x, 0.0};
    return time;
  }

  /// Moves a pair that is not in contact and not leaving. Returns the time that it took.
  double cross_gap(Overlap& s, double time, double outward) const {
    const double drive = drive_at(s.x, outward);
    if (s.x < -adhesion_.cutoff) return in_gap(s, time, s.x, -adhesion_.cutoff, drive);
    return in_gap(s, time, -adhesion_.cutoff, 0.0, drive);
  }

  /// Moves a pair with a constant acceleration between the overlaps `low` < `high` <= 0, until it
  /// reaches one of them or `time` ends. Returns the time that it took.
  double in_gap(Overlap& s, double time, double low, double high, double drive) const {
    const double touch = first_root(high - s.x, -s.v, -drive);
    const double out = first_root(s.x - low, s.v, drive);
    const double t = std::min(std::min(touch, out), time);
    s = {s.x + t * (s.v + 0.5 * drive * t), s.v + drive * t};
    // Rounding must not carry the pair across the edge.
    if (t < time)
      s = out < touch ? Overlap{low, std::min(s.v, 0.0)} : Overlap{high, std::max(s.v, 0.0)};
    return t;
  }

  ContactMotion contact_;
  contact::Adhesion adhesion_;
  double reduced_mass_;
  double step_;
  double pull_;
  double edge_;
};

}  // namespace cohesion::contact_solver
