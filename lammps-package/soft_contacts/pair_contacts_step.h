// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_PAIR_CONTACTS_STEP_H
#define COHESION_PAIR_CONTACTS_STEP_H

// The members of PairContacts that compute the pairs of a step: for the units that instantiate it.
#include <algorithm>
#include <type_traits>

#include "contact_solver/exact_contact.h"
#include "soft_contacts/pair_contacts.h"

namespace LAMMPS_NS {

using cohesion::contact_solver::ContactMotion;

template <class Contact>
void PairContacts<Contact>::compute(const ClosePairs& pairs, int size,
                                    std::optional<cohesion::contact::LawKind> only_law,
                                    bool tallies) {
  tallies_ = tallies;
  per_pair_ = pairs.each();
  clear();
  if (size == ContactHistory::with_rolling)
    compute_sized<ContactHistory::with_rolling>(pairs, only_law);
  else if (size == ContactHistory::with_friction)
    compute_sized<ContactHistory::with_friction>(pairs, only_law);
  else
    compute_sized<ContactHistory::normal_only>(pairs, only_law);
}

template <class Contact>
template <int SIZE>
void PairContacts<Contact>::compute_sized(const ClosePairs& pairs,
                                          std::optional<cohesion::contact::LawKind> only_law) {
  using namespace cohesion::contact;
  using namespace cohesion::contact_solver;
  // A loop for each normal law, of results that stay in registers; one for laws that differ and for
  // steps with momentum fluxes.
  if (Contact::is_exact && !step_->sums_flux() && only_law) {
    switch (*only_law) {
      case LawKind::linear:
        return compute_by<SIZE, LinearContact>(pairs);
      case LawKind::hertz:
        return compute_by<SIZE, IntegratedContact<HertzSpringDashpot>>(pairs);
      case LawKind::jkr:
        return compute_by<SIZE, IntegratedContact<JkrSpringDashpot>>(pairs);
    }
  }
  compute_by<SIZE, ContactMotion>(pairs);
}

/// The same, with contacts that move by `By`.
template <class Contact>
template <int SIZE, class By>
void PairContacts<Contact>::compute_by(const ClosePairs& pairs) {
  const ContactForces<Contact, SIZE> forces(atom, step_);
  const StaggeredParticles now = particles();
  const auto loop = [&](auto tallies) {
    const bool full = tallies_ || step_->energy_tally.is_read() || !forces.may_persist();
    const bool sums_flux = std::is_same_v<By, ContactMotion> && step_->sums_flux();
    pairs.for_each_near([&](const ClosePair& pair) __attribute__((always_inline)) {
      const int i = pair.i, j = pair.j;
      const int index = index_of(now, i, j);
      if (index == NONE) return hold(i, j, *pair.has_history, pair.history);
      const Contact& contact = all_[index];
      FrictionalStep result;
      if (full || !*pair.has_history ||
          !forces.template apply_persistent<By, tallies>(contact, i, j, StaggeredPair{now, i, j},
                                                         pair.history, result))
        compute_contact<SIZE>(forces, contact, i, j, *pair.has_history, pair.history);
      else if (sums_flux)
        add_flux(forces.owned_fraction(j), now.motion(i, j), contact, result);
    });
  };
  if (step_->energy_tally.is_active())
    loop(std::true_type());
  else
    loop(std::false_type());
}

template <class Contact>
[[gnu::noinline]] void PairContacts<Contact>::add_flux(double fraction, const PairMotion& now,
                                                       const Contact& c,
                                                       const FrictionalStep& result) {
  step_->add_flux(fraction, now.separation, result.impulse, c.by_contact(now, result));
}

/// Computes a pair in a step with output as in any other step, with what it stores. Returns false
/// for contacts that are not persistent.
template <class Contact>
template <int SIZE>
bool PairContacts<Contact>::read_persistent(const ContactForces<Contact, SIZE>& forces,
                                            const Contact& c, int i, int j, double* values) {
  if (!forces.may_persist()) return false;
  const StaggeredParticles now = particles();
  double before[SIZE];
  std::copy_n(values, SIZE, before);
  FrictionalStep result;
  const StaggeredPair pair{now, i, j};
  const bool tallies = step_->energy_tally.is_active();
  if (!(tallies
            ? forces.template apply_persistent<ContactMotion, true>(c, i, j, pair, values, result)
            : forces.template apply_persistent<ContactMotion, false>(c, i, j, pair, values,
                                                                     result)))
    return false;
  const PairMotion motion = now.motion(i, j);
  const StoredEnergies stored = c.template stored_persistent<SIZE>(motion, before, values);
  if (tallies) step_->energy_tally.store(forces.owned_fraction(j), stored);
  if (step_->sums_flux()) add_flux(forces.owned_fraction(j), motion, c, result);
  if (tallies_) tally_(i, j, motion.separation, stored.potential(), result.impulse);
  return true;
}

/// Computes any pair. A pair out of range that may enter it in this step gets a history: only pairs
/// without one can stand in range without having moved there.
template <class Contact>
template <int SIZE>
[[gnu::noinline]] void PairContacts<Contact>::compute_contact(
    const ContactForces<Contact, SIZE>& forces, const Contact& c, int i, int j, int& has_history,
    double* values) {
  const bool reads = tallies_ || step_->energy_tally.is_read();
  if (reads && has_history && read_persistent<SIZE>(forces, c, i, j, values)) return;
  const StaggeredParticles now = particles();
  ContactState::restore_signs(values);
  ContactHistory known = has_history && !step_->starts() ? ContactHistory::stored(values, SIZE)
                                                         : ContactHistory::unknown();
  if (known.normal.is_outside() &&
      !c.within_reach(now.separation(i, j), now.velocity(i, j), step_->moved_by_forces())) {
    has_history = 0;
    return;
  }
  if (!has_history) std::fill_n(values, per_pair_, 0.0);
  const PairMotion motion = now.motion(i, j);
  ContactEnergies energies;
  const FrictionalStep result =
      forces.apply(c, i, j, motion, {}, known,
                   reads || step_->energy_tally.is_active() ? &energies : nullptr, reads);
  known.store(values, SIZE);
  has_history = 1;
  if (step_->sums_flux()) add_flux(forces.owned_fraction(j), motion, c, result);
  if (tallies_) tally_(i, j, motion.separation, energies.stored.potential(), result.impulse);
}

/// Leaves two particles that forces do not move in range of each other, unless a fix moves one
/// relative to the other.
template <class Contact>
void PairContacts<Contact>::hold(int i, int j, int& has_history, double* values) const {
  if (!has_history) return;
  const bool led = step_->is_led(i) || step_->is_led(j);
  if (led && step_->carries_along(i, particles().velocity(i, j))) {
    has_history = 0;
    return;
  }
  ContactState::restore_signs(values);
  const ContactState held = ContactState::stored(values).hold();
  held.store(values);
  has_history = held.phase != ContactState::outside;
}

}  // namespace LAMMPS_NS

#endif
