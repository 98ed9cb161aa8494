// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/linear_spring_dashpot.h"
#include "contact_solver/contact_state.h"
#include "contact_solver/damped_oscillator.h"

namespace cohesion::contact_solver {

/// A contact with a linear spring-dashpot and a constant attraction, in closed form.
///
/// In a persistent contact the motion about its equilibrium x_e obeys
///
///   x_(n+1) = 2 c x_n - d x_(n-1)    c = exp(-alpha dt) cos(q dt)    d = exp(-2 alpha dt)
///
/// so that one discrete force of the usual form is exact at any step:
///
///   f = K' x - eta' u - (K'/K) F_ad      K' = mu (1 + d - 2 c)/dt^2    eta' = mu (1 - d)/dt
///
/// with the overlap x and the mean rate u of the last step, of the distance. A load L changes the
/// overlap at rest by L/K' in the place of L/K. The extra force -(1 - K'/K) mu b, with the other
/// acceleration b of the same step, would correct this. It needs another loop over the contacts and
/// another exchange between ranks, and b would lack the extra forces of other contacts. With those
/// of the previous step elastic clusters gain energy.
///
/// This force ends at (K'/K) F_ad where the overlap is zero, and a contact bears F_ad. So a contact
/// is taut where an outward load above half of F_ad has brought it below x_t = q F_ad/K, and has a
/// stiffer spring there:
///
///   f = K_t x - eta' u - F_ad      K_t x_t - F_ad = K' x_t - (K'/K) F_ad
///
/// A free oscillation stays exact. In resolved steps the load acts so that a contact has the same
/// overlap at rest.
///
/// Of its energy account (energy_account.h): while the contact is persistent, R has besides the
/// energy that the discrete spring stores; its dissipation is a quadratic form of two staggered
/// rates. The forces act along the normals of their time levels. Where the pair turns with the
/// centrifugal acceleration z, R also changes by (f_n - f_(n-1)) z dt^2/4 and a part of third
/// order. In a resolved step the dashpot dissipates eta u^2 for the time of contact with the mean
/// rate u of the step, which the particles have one step later: R changes by the difference then.
///
/// Source: derived here, see docs/theory/exact_contacts.md.
class LinearContact {
 public:
  /// attraction [force]: F_ad; step [time].
  LinearContact(const contact::LinearSpringDashpot& spring, double attraction, double step)
      : oscillator_(spring.stiffness() / spring.reduced_mass(),
                    0.5 * spring.damping() / spring.reduced_mass()),
        whole_step_(oscillator_.propagator(step)),
        discrete_(oscillator_.on_grid(step, spring.reduced_mass())),
        reduced_mass_(spring.reduced_mass()),
        inverse_mass_(1.0 / spring.reduced_mass()),
        adhesion_(attraction),
        pull_(attraction / spring.reduced_mass()),
        bearable_(attraction > 0.0 ? pull_ : std::numeric_limits<double>::infinity()),
        attraction_(discrete_.stiffness * pull_ / oscillator_.w0_squared()),
        weight_(step < 0.5 * spring.contact_time() ? spring.stiffness() / discrete_.stiffness
                                                   : 1.0),
        taut_overlap_(taut_part * attraction / spring.stiffness()),
        taut_stiffness_(taut_stiffness(spring.stiffness(), discrete_.stiffness)),
        damping_(spring.damping()),
        half_damping_(0.5 * discrete_.damping * step) {
    if (damping_ > 0.0) set_dissipation();
  }

  /// K_t [force/length] of a contact with stiffness K and discrete stiffness K'; it does not depend
  /// on F_ad.
  static double taut_stiffness(double stiffness, double discrete) {
    return discrete + (stiffness - discrete) / taut_part;
  }

  /// K' and eta'.
  const DiscreteConstants& discrete_spring() const { return discrete_; }

  /// Energy stored in the spring at overlap x, [energy].
  double spring_energy(double x) const {
    return x > 0.0 ? 0.5 * reduced_mass_ * oscillator_.w0_squared() * x * x : 0.0;
  }

  /// The overlap at which contact ends, [length].
  static constexpr double lowest_overlap() { return 0.0; }
  /// What friction has besides spring and dashpot, [force].
  double friction_load() const { return adhesion_; }

  /// Moves a contact that certainly lasts for the whole step, as advance() does. `outward`
  /// [length/time^2]: what pulls it apart. False, and nothing done, where that is not certain.
  bool advance_whole_step(Overlap& s, double outward, NormalRecord& record) const {
    if (!(s.x > 0.0)) return false;
    const double drive = pull_ - resolved_outward(outward);
    const Overlap end = oscillator_.after(whole_step_, s, drive);
    if (!DampedOscillator::stays_positive(s, end)) return false;
    record_contact(s, end, whole_step_.time, drive, record);
    return true;
  }
  /// Moves a contact for at most `time` [time], until it parts. Returns the time it took.
  double advance(Overlap& s, double time, double outward, NormalRecord& record) const {
    const double drive = pull_ - resolved_outward(outward);
    const auto propagator = time == whole_step_.time ? whole_step_ : oscillator_.propagator(time);
    Overlap end = oscillator_.after(propagator, s, drive);
    time = std::min(time, oscillator_.first_zero(s, drive, time, end));
    record_contact(s, end, time, drive, record);
    return time;
  }

  /// The force of a contact that was in contact throughout the last step. False where it is not
  /// certain to be in contact until the next time level under the acceleration `outward` of the
  /// last step, or does not bear that load.
  [[gnu::always_inline]] bool advance_persistent(const ContactPoint& now, double outward,
                                                 const DistanceMotion& at,
                                                 const ContactState& state, double /*touch_energy*/,
                                                 PersistentStep& step) const {
    const bool taut = is_taut(now.overlap, outward);
    if (!force_of(now, taut, outward, step)) return false;
    set_dissipated(state.last_rate, now.rate, step);
    step.account += work_of_turning(step.force, state.force, at);
    if (taut || was_taut(state)) step.account += work_beyond_stored(now, was_taut(state), taut);
    return true;
  }
  /// The same in the first step after a resolved one.
  bool begin_persistent(const ContactPoint& now, double outward, const StaggeredMotion& at,
                        const ContactState& state, PersistentStep& step) const {
    // A contact that is first seen at rest under tension is there because of a load.
    const bool is_new = state.is_new();
    const bool taut = is_taut(now.overlap, is_new ? pull_ : outward);
    const double borne = is_new ? std::max(outward, -force(now, taut) * inverse_mass_) : outward;
    if (!force_of(now, taut, borne, step)) return false;
    step.account =
        0.5 * whole_step_.time * step.force * at.rate + spring_potential(now.overlap, taut);
    return true;
  }
  /// The part of spring and dashpot at a time level that a persistent contact has reached, [force].
  double repulsion(const ContactPoint& now, const ContactState& state) const {
    return force(now, was_taut(state)) + adhesion_;
  }

  /// Of a persistent contact: R up to this time level without the work of the force that begins
  /// here.
  double account(const ContactPoint& now, const StaggeredMotion& at, const ContactState& state,
                 double /*adhesion_energy*/) const {
    const bool taut = was_taut(state);
    const double begins = force(now, taut);
    const DistanceMotion motion =
        DistanceMotion::of_pair(at.distance, 1.0 / at.distance, at.rate,
                                at.rate * at.rate + at.sideways * at.sideways, whole_step_.time);
    return state.account + dissipated(state.last_rate, now.rate) +
           (taut ? work_beyond_stored(now, taut, taut) : 0.0) +
           work_of_turning(begins, state.force, motion) - spring_potential(now.overlap, taut) -
           0.5 * whole_step_.time * begins * at.rate;
  }
  /// What the dashpot of a persistent contact has dissipated since the last time level, [energy].
  double dissipation(const ContactPoint& now, const StaggeredMotion&, const ContactState& state,
                     double /*adhesion_energy*/) const {
    PersistentStep step;
    set_dissipated(state.last_rate, now.rate, step);
    return step.dissipated;
  }
  /// The true rate of the distance at a time level that a persistent contact has reached, by the
  /// closed form through the last two overlaps. outward [length/time^2]: acceleration by load and
  /// turning.
  double true_rate(const ContactPoint& now, const StaggeredMotion& at, double outward,
                   const ContactState&, double /*adhesion_energy*/) const {
    const double dt = whole_step_.time;
    const double before = std::hypot(at.distance - dt * at.rate, dt * at.sideways);
    const double equilibrium = (pull_ - resolved_outward(outward)) / oscillator_.w0_squared();
    const double is = now.overlap - equilibrium, was = is + at.distance - before;
    const double rate = (is - whole_step_.xx * was) / whole_step_.xv;
    return -(whole_step_.vx * was + whole_step_.vv * rate);
  }

  /// What the dashpot of a resolved step has dissipated with the rate at its end, [energy].
  double late_dissipation(const StaggeredMotion& at, const ContactState& state) const {
    return damping_ * state.contact_time * at.rate * at.rate;
  }
  /// What a resolved step dissipates, less what its dashpot will with the rate `mean` along the
  /// normal at its end.
  double early_dissipation(double dissipation, double contact_time, double mean) const {
    return dissipation - damping_ * contact_time * mean * mean;
  }

 private:
  /// The fraction of the way of a step that a contact must be away from its end to be certain to
  /// last.
  static constexpr double certain = 0.1;
  /// q, the overlap x_t over that of a contact at rest without a load. A small one makes the spring
  /// much stiffer, a large one changes the free oscillation.
  static constexpr double taut_part = 0.3;

  /// The outward acceleration of a contact that is resolved, such that its overlap at rest is that
  /// of a persistent contact: otherwise a contact that changes from one to the other would begin to
  /// swing, and spheres that bounce under their weight would gain energy. No contact bears more
  /// than F_ad, and a larger load acts unchanged.
  double resolved_outward(double outward) const {
    const double slack = (1.0 - taut_part) * pull_ / weight_;
    if (!(pull_ > 0.0) || outward <= slack) return weight_ * outward;
    if (outward >= pull_) return outward;
    return pull_ * (1.0 - taut_part * (pull_ - outward) / (pull_ - slack));
  }

  /// Whether a persistent contact is taut under the acceleration `outward` of the last step.
  [[gnu::always_inline]] bool is_taut(double overlap, double outward) const {
    return overlap < taut_overlap_ && outward > 0.5 * pull_;
  }
  static bool was_taut(const ContactState& state) { return state.phase == ContactState::taut; }

  /// Of spring and adhesion at overlap x, [force].
  [[gnu::always_inline]] double spring_force(double x, bool taut) const {
    return taut && x < taut_overlap_ ? taut_stiffness_ * x - adhesion_
                                     : discrete_.stiffness * x - attraction_;
  }
  /// The integral of spring_force() over the overlap, [energy].
  double spring_potential(double x, bool taut) const {
    const double slack = x * (0.5 * discrete_.stiffness * x - attraction_);
    const double below = taut ? std::min(x - taut_overlap_, 0.0) : 0.0;
    return slack + 0.5 * (taut_stiffness_ - discrete_.stiffness) * below * below;
  }
  /// The work of spring and adhesion in the last step, the mean of both forces times the way, less
  /// the decrease of their potential, [energy]: 0 but where the spring changes. taut_before, taut:
  /// at the two time levels.
  [[gnu::noinline]] double work_beyond_stored(const ContactPoint& now, bool taut_before,
                                              bool taut) const {
    const double before = now.overlap + whole_step_.time * now.rate;
    return spring_potential(now.overlap, taut) - spring_potential(before, taut_before) -
           0.5 * (spring_force(before, taut_before) + spring_force(now.overlap, taut)) *
               (now.overlap - before);
  }

  [[gnu::always_inline]] double force(const ContactPoint& now, bool taut) const {
    return spring_force(now.overlap, taut) - discrete_.damping * now.rate;
  }
  [[gnu::always_inline]] bool force_of(const ContactPoint& now, bool taut, double outward,
                                       PersistentStep& step) const {
    if (!(outward < bearable_)) return false;
    const double dt = whole_step_.time;
    step.force = force(now, taut);
    step.repulsion = step.force + adhesion_;
    step.taut = taut;
    const double change = dt * (step.force * inverse_mass_ + outward);
    // Between two time levels it may dip below both, by dt/8 of the change where what pulls is
    // constant.
    const double least = dt * (certain * std::abs(now.rate) + 0.25 * std::max(-change, 0.0));
    return now.overlap > least && now.overlap - dt * (now.rate + change) > least;
  }

  /// Records an interval of contact, from s to `end`.
  void record_contact(Overlap& s, Overlap end, double time, double drive,
                      NormalRecord& record) const {
    const double w0_squared = oscillator_.w0_squared();
    record.contact_time += time;
    record.repulsion_impulse += reduced_mass_ * (drive * time - (end.v - s.v));
    record.repulsion_at_end =
        reduced_mass_ * (w0_squared * end.x + 2.0 * oscillator_.alpha() * end.v);
    record.dissipated +=
        reduced_mass_ * (0.5 * (s.v * s.v - end.v * end.v) +
                         (s.x - end.x) * (0.5 * w0_squared * (s.x + end.x) - drive));
    s = end;
  }

  /// The work of the forces of this and the last time level in the step between them, which act
  /// along the normals there, less their work on the distance, [energy].
  [[gnu::always_inline]] double work_of_turning(double force, double last_force,
                                                const DistanceMotion& at) const {
    const double dt = whole_step_.time, change = dt * at.rate * at.inverse;
    return 0.25 * dt * dt * at.centrifugal *
           (force - last_force + change * (force - 2.0 * last_force));
  }
  /// The dissipation in closed form from one time level to the next of a persistent contact, less
  /// the work of the discrete dashpot, from the mean rates before and after the first one. R
  /// changes by it, since the discrete spring stores what it works.
  [[gnu::always_inline]] double dissipated(double before, double after) const {
    return before * (before_before_ * before + before_after_ * after) +
           after_after_ * after * after;
  }
  [[gnu::always_inline]] void set_dissipated(double before, double after,
                                             PersistentStep& step) const {
    step.account = dissipated(before, after);
    step.dissipated = step.account + half_damping_ * after * (before + after);
  }
  void set_dissipation() {
    const DampedOscillator::Propagator& p = whole_step_;
    const auto of = [&](double before, double after) {
      const double stretch =
          -(reduced_mass_ * (after - before) / p.time + discrete_.damping * before) /
          discrete_.stiffness;
      const double next = stretch + p.time * after;
      const double rate = (next - p.xx * stretch) / p.xv;
      const double next_rate = p.vx * stretch + p.vv * rate;
      const double lost = 0.5 * reduced_mass_ *
                          (rate * rate - next_rate * next_rate +
                           oscillator_.w0_squared() * (stretch * stretch - next * next));
      return lost - 0.5 * discrete_.damping * p.time * after * (after + before);
    };
    before_before_ = of(1.0, 0.0);
    after_after_ = of(0.0, 1.0);
    before_after_ = of(1.0, 1.0) - before_before_ - after_after_;
  }

  DampedOscillator oscillator_;
  DampedOscillator::Propagator whole_step_;
  DiscreteConstants discrete_;
  double reduced_mass_;
  double inverse_mass_;
  double adhesion_;        // F_ad
  double pull_;            // F_ad/mu
  double bearable_;        // load at which a persistent contact parts; infinite without F_ad
  double attraction_;      // (K'/K) F_ad
  double weight_;          // K/K'; 1 where no contact persists
  double taut_overlap_;    // x_t
  double taut_stiffness_;  // K_t
  double damping_;         // of the contact, [mass/time]
  double half_damping_;    // eta' dt/2, [mass]
  double before_before_ = 0.0, before_after_ = 0.0, after_after_ = 0.0;  // of dissipated()
};

}  // namespace cohesion::contact_solver
