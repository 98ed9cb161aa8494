// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include "contact/adhesion.h"
#include "contact/normal_law.h"
#include "contact_solver/contact_state.h"
#include "contact_solver/energy_account.h"
#include "contact_solver/pair_course.h"

namespace cohesion::contact_solver {

/// Normal motion of one contact with a spring, a dashpot and an adhesion, one force a step:
/// positions x_n at the time levels are samples of the motion, exact ones with a linear spring, and
/// staggered velocities are (x_(n+1) - x_n)/dt.
///
/// A persistent contact has a discrete force of its law (linear_contact.h, integrated_contact.h).
///
/// A step in which the pair enters or leaves the range, is captured or turns round in the gap is
/// resolved: integrated from the true state at n under a constant external acceleration, in
/// closed form but for contacts whose law has none, and the force is the one that puts the pair
/// where it is at n+1. Only the true velocity there is not the staggered one, and its offset is
/// stored. The external acceleration is that of the step before; the energy account
/// (energy_account.h) corrects what this changes of the energy.
///
/// Forces are central at the time levels: angular momentum is conserved to round-off. A slow load
/// parts a contact at F_ad.
///
/// Source: derived here, see docs/theory/exact_contacts.md.
class ContactSolver : public PairCourse {
 public:
  /// Whether no force acts on pairs in range that are clear of contact and edge: is_clear().
  static constexpr bool may_be_idle = false;

  /// contact_distance [length]: of the centres at touch, or the radius next to a wall; step [time].
  ContactSolver(const contact::NormalLaw& law, const contact::Adhesion& adhesion,
                double contact_distance, double step)
      : ContactSolver(law, adhesion, contact_distance, step, adhesion.cutoff, adhesion.cutoff) {}

  /// Whether anything can happen to a pair in the step that begins here. `external`
  /// [length/time^2]: acceleration of the distance by other forces.
  bool within_reach(const StaggeredMotion& now, double external) const {
    const double inwards = std::max(-now.rate, 0.0) + std::max(-external, 0.0) * step();
    return now.distance <= outer_distance() + step() * inwards;
  }

  /// Whether the force of the last step was an impulse, which other contacts do not see.
  virtual bool gave_impulse(const ContactState& /*state*/) const { return false; }
  /// The acceleration along the normal by other forces in the last step, [length/time^2], from that
  /// by all forces but impulses. The contact's own force acted along the normal of that time.
  double external(double by_all, const StaggeredMotion& now, const ContactState& state) const {
    const double own = persistent_force(state);
    if (own == 0.0) return by_all;
    const double along = now.distance - step() * now.rate;
    return by_all - own / reduced_mass_ * along / std::hypot(along, step() * now.sideways);
  }

  /// A step of a contact that was persistent in the last one and certainly is in this one. False,
  /// and nothing done, where that is not certain. The other forces are known from the motion.
  bool advance_persistent(const DistanceMotion& now, ContactState& state,
                          PersistentStep& step) const {
    // The most frequent contact is worth a call of its own; it needs no energy at touch.
    if (const auto* const linear = std::get_if<LinearContact>(&contact()))
      return advance_persistent(*linear, now, 0.0, state, step);
    const double touch_energy = adhesion_energy(0.0);
    return std::visit(
        [&](const auto& by) { return advance_persistent(by, now, touch_energy, state, step); },
        contact());
  }
  /// The same by contact(), of its own type. touch_energy: adhesion_energy() at touch.
  template <class Contact>
  [[gnu::always_inline]] bool advance_persistent(const Contact& by, const DistanceMotion& now,
                                                 double touch_energy, ContactState& state,
                                                 PersistentStep& step) const {
    const double outward = outward_of(now.rate, state.last_rate, state.force);
    ContactPoint point{contact_distance() - now.distance, now.rate};
    if (!by.advance_persistent(point, outward, now, state, touch_energy, step)) return false;
    go_on(now.rate, outward - now.centrifugal, step, state);
    return true;
  }

  /// Any step. `external` as above, constant in the step; `velocity_step` [time]: how long the
  /// force acts on the velocity that leads to the next time level: step(), but half of it in the
  /// first step of a run, whose velocity is that of the time level itself.
  ContactStep advance(const StaggeredMotion& now, double external, double velocity_step,
                      ContactState& state) const {
    ContactStep result;
    if (velocity_step == step() && (state.in_contact() || stands_in_contact(now, state)) &&
        stays_persistent(now, external, state, result))
      return result;
    return resolve(now, external, velocity_step, state);
  }

  /// The true rate of the distance at the time level by the contact itself, less the staggered one.
  double offset(const StaggeredMotion& now, double external, const ContactState& state) const {
    return true_rate(now, external, state) - now.rate - 0.5 * step() * external;
  }
  /// The overlap at which contact ends, [length].
  double lowest_overlap() const {
    return std::visit([](const auto& c) { return c.lowest_overlap(); }, contact());
  }
  /// What friction has besides the force of spring and dashpot, [force].
  double friction_load() const {
    return std::visit([](const auto& c) { return c.friction_load(); }, contact());
  }
  /// The discrete force of spring and dashpot at a time level that a persistent contact has
  /// reached, [force].
  double repulsion(const StaggeredMotion& now, const ContactState& state) const {
    return std::visit([&](const auto& c) { return c.repulsion(point(now), state); }, contact());
  }
  /// The energy of spring and adhesion by the energy account, less that of their laws: staggered
  /// velocities have another kinetic energy than the true motion, under a load the discrete spring
  /// is less stiff, and other forces are known a step late. `force` [force]: at this time level. It
  /// contains the sum of exchanged(), which all contacts together only pass to each other.
  double account_energy(const StaggeredMotion& now, double external, double force,
                        const ContactState& state) const {
    if (state.is_outside()) return -account_.work(force, now);
    return -account_up_to(now, external, state) - account_.work(force, now) -
           stored(now, state.in_range());
  }
  double exchanged(double external, const ContactState& state) const {
    return state.is_outside() ? 0.0 : account_.exchanged(persistent_force(state), external, state);
  }
  /// What the dashpot has dissipated since the last time level, as far as it is known only now,
  /// [energy].
  double dissipated(const StaggeredMotion& now, const ContactState& state) const {
    return std::visit(
        [&](const auto& c) {
          return state.is_persistent()
                     ? c.dissipation(point(now), now, state,
                                     adhesion_energy(contact_distance() - now.distance))
                     : c.late_dissipation(now, state);
        },
        contact());
  }

  /// Of a contact with friction: EnergyAccount.
  void leave_out_exchange() { account_.leave_out_exchange(); }

 protected:
  /// range [length]: gap up to which a pair is inside, the adhesion's or that of a derived law;
  /// entry [length]: gap at which it comes inside.
  ContactSolver(const contact::NormalLaw& law, const contact::Adhesion& adhesion,
                double contact_distance, double step, double range, double entry)
      : PairCourse(law, adhesion, contact_distance, step, range, entry),
        reduced_mass_(contact::reduced_mass(law)),
        inverse_step_(1.0 / step),
        inverse_mass_(1.0 / reduced_mass_),
        account_(reduced_mass_, step) {}

  /// A step that is not certainly persistent.
  virtual ContactStep resolve(const StaggeredMotion& at, double external, double velocity_step,
                              ContactState& state) const {
    ContactStep result;
    const ContactState before = state;
    const bool first = velocity_step < step();
    bool in_range = before.in_range();
    // Before the first step of a run nothing has moved.
    const bool found_in_range =
        before.phase == ContactState::held ||
        ((first ? before.is_outside() : before.phase == ContactState::unknown) &&
         at.stands_within(entry_distance(), first ? 0.0 : step()));
    if (found_in_range) in_range = true;
    Flight now{at.distance, first ? at.rate : true_rate(at, external, before), at.sideways};
    const Flight start = now;
    const double outward = outward_acceleration(start, external);
    const double account = first || found_in_range ? EnergyAccount::at_start(stored(at, in_range))
                                                   : account_up_to(at, external, before);
    const bool touches = in_range && stays_in_contact(now, outward, result.record);
    const bool event = !touches && move(now, external, in_range, result.record);
    const bool flies = !touches && !event;
    state = {};
    state.phase = in_range ? ContactState::inside : ContactState::outside;
    if (flies && before.has_nothing_pending()) {
      if (in_range) {
        state.account = account;
        state.force_before = persistent_force(before);
        state.external_before = external;
      }
      return result;  // not to carry the rounding of no change into the force
    }
    // The distance is the pair's; direction and flight across it are those of its particles.
    const double across = step() * at.sideways;
    const double along = std::sqrt(std::max(now.distance * now.distance - across * across, 0.0));
    const double mean = (along - at.distance) / step();
    result.force = reduced_mass_ * ((mean - at.rate) / velocity_step - external);
    if (flies && !before.in_range() && settles(at, external, account, before, result.force))
      state.phase = ContactState::settling;
    if (event) state.phase = in_range ? ContactState::entered : ContactState::left;
    if (result.record.contact_time >= step()) state.phase = ContactState::touching;
    // Of the distance, along the normal at the next time level.
    const double staggered = (along * mean + across * at.sideways) / now.distance;
    if (!flies) state.velocity_offset = now.radial - staggered - 0.5 * step() * external;
    state.last_rate = at.mean_rate(step());
    state.force = result.force;
    state.force_before = persistent_force(before);
    state.external_before = external;
    state.contact_time = result.record.contact_time;
    result.dissipated = std::visit(
        [&](const auto& c) {
          return c.early_dissipation(result.record.dissipated, state.contact_time, staggered);
        },
        contact());
    state.account = account +
                    (first ? account_.work_of_first_force(result.force, at, mean)
                           : account_.work(result.force, at)) +
                    result.dissipated;
    // What the discrete force does later or earlier than the motion counts as the spring's.
    const double true_force = reduced_mass_ * ((now.radial - start.radial) / step() - outward);
    result.repulsion = result.record.repulsion_impulse / step() + result.force - true_force;
    return result;
  }

  /// Sets the force of a pair that has left its range so that its account closes; whether the
  /// account stays open.
  bool settles(const StaggeredMotion& at, double external, double account,
               const ContactState& before, double& force) const {
    const bool settling = before.phase == ContactState::settling;
    if (settling) force = 0.0;  // but for rounding
    const bool closed = account_.settle(at, external, account, force);
    // The other forces may have changed what the step after the first one does.
    return !settling || !closed || account_.is_open(at, account, before);
  }

 private:
  /// Whether a pair without a stored motion touches, and did so before the last step. Where it is
  /// released under a load, the load of that step is not known: a step that is resolved without it
  /// would give the contact half of its force.
  bool stands_in_contact(const StaggeredMotion& now, const ContactState& state) const {
    // A neck lasts beyond touch; without a stored state there is none.
    const double end = state.phase == ContactState::held ? lowest_overlap() : 0.0;
    return state.is_new() && now.stands_within(contact_distance() - end, step());
  }
  bool stays_persistent(const StaggeredMotion& now, double external, ContactState& state,
                        ContactStep& result) const {
    if (state.is_persistent()) {
      const DistanceMotion distance =
          DistanceMotion::of_pair(now.distance, 1.0 / now.distance, now.rate,
                                  now.rate * now.rate + now.sideways * now.sideways, step());
      PersistentStep next;
      if (!advance_persistent(distance, state, next)) return false;
      result.force = next.force;
      result.repulsion = next.repulsion;
    } else {
      const double outward = outward_acceleration({now.distance, now.rate, now.sideways}, external);
      const ContactPoint here = point(now);
      PersistentStep first;
      const bool begins = std::visit(
          [&](const auto& c) { return c.begin_persistent(here, outward, now, state, first); },
          contact());
      if (!begins) return false;
      first.account += state.is_new() ? EnergyAccount::at_start(stored(now, true))
                                      : account_up_to(now, external, state) - state.account -
                                            account_.exchanged(state.force, external, state);
      result.force = first.force;
      result.repulsion = first.repulsion;
      go_on(here.rate, external, first, state);
    }
    result.record.contact_time = step();
    result.record.repulsion_impulse = step() * result.repulsion;
    result.record.repulsion_at_end = result.repulsion;
    return true;
  }

  /// What the other forces and the turning do to the distance of a persistent contact.
  double outward_of(double mean_rate, double last_rate, double force) const {
    return (mean_rate - last_rate) * inverse_step_ - force * inverse_mass_;
  }
  [[gnu::always_inline]] void go_on(double rate, double external, PersistentStep& result,
                                    ContactState& state) const {
    state.account += result.account;
    if (account_.exchanges()) {
      result.exchanged = account_.exchanged(state.force, external, state);
      state.account += result.exchanged;
      state.force_before = state.force;
      state.external_before = external;
    } else {
      state.force_before = state.external_before = 0.0;  // a later run may read them
    }
    state.phase = result.taut ? ContactState::taut : ContactState::persistent;
    state.velocity_offset = result.true_rate;
    state.last_rate = rate;
    state.force = result.force;
    state.contact_time = step();
  }

  double persistent_force(const ContactState& state) const {
    return gave_impulse(state) ? 0.0 : state.force;
  }

  /// The energy in the contact of a pair at the position where it is first found.
  double stored(const StaggeredMotion& now, bool in_range) const {
    if (!in_range) return 0.0;
    const double overlap = contact_distance() - now.distance;
    return spring_energy(overlap) + adhesion_energy(overlap);
  }

  /// The true rate of the distance at the time level: the staggered one, the external acceleration
  /// for half a step and the stored offset; in a persistent contact by its law.
  double true_rate(const StaggeredMotion& now, double external, const ContactState& state) const {
    if (!state.is_persistent()) return now.rate + state.velocity_offset + 0.5 * step() * external;
    const double outward = outward_acceleration({now.distance, now.rate, now.sideways}, external);
    const ContactPoint here = point(now);
    return std::visit(
        [&](const auto& c) {
          return c.true_rate(here, now, outward, state, adhesion_energy(here.overlap));
        },
        contact());
  }

  ContactPoint point(const StaggeredMotion& now) const {
    return {contact_distance() - now.distance, now.mean_rate(step())};
  }

  /// R up to this time level without the work of the force that begins here, which is not known
  /// yet.
  double account_up_to(const StaggeredMotion& now, double external,
                       const ContactState& state) const {
    const double exchanged = account_.exchanged(persistent_force(state), external, state);
    const ContactPoint here = point(now);
    return exchanged + std::visit(
                           [&](const auto& c) {
                             return state.is_persistent()
                                        ? c.account(here, now, state, adhesion_energy(here.overlap))
                                        : state.account + c.late_dissipation(now, state) +
                                              account_.work_of_last(state.force, now);
                           },
                           contact());
  }

  double reduced_mass_;
  double inverse_step_;
  double inverse_mass_;
  EnergyAccount account_;
};

}  // namespace cohesion::contact_solver
