// SPDX-License-Identifier: GPL-2.0-only
// The part of PairGranCohesive that computes the pairs of a step.
#include <algorithm>
#include <type_traits>

#include "atom.h"
#include "comm.h"
#include "common/guarded.h"
#include "contact_step/fix_contact_step.h"
#include "engine/flight_report.h"
#include "engine/largest_radii.h"
#include "error.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/pair_gran_cohesive.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::contact_solver;
using cohesion::Vector3;

template <class Cohesion>
void PairGranCohesive<Cohesion>::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  coefficients.require_committed();
  if (update->whichflag == 2)
    error->all(FLERR,
               coefficients.message_prefix() + " follows motion in time; it cannot be minimized");
  if (!is_active) {
    history_stale = true;
    return;
  }
  if (contact_step->resumes()) {
    repeat_forces();
    return;
  }
  contact_step->compute_contacts([this] {
    begin_step();
    with_contacts([this](auto& contacts, auto size) { compute_contacts<size>(contacts); });
  });
}

/// Calls what(contacts, history size) with the types of this style's scheme.
template <class Cohesion>
template <class What>
void PairGranCohesive<Cohesion>::with_contacts(const What& what) {
  guarded(lmp, coefficients.message_prefix(), [&] {
    std::visit(
        [&](auto& contacts) {
          if (per_pair == HistorySize::with_rolling)
            what(contacts, std::integral_constant<int, HistorySize::with_rolling>());
          else if (friction)
            what(contacts, std::integral_constant<int, HistorySize::with_friction>());
          else
            what(contacts, std::integral_constant<int, HistorySize::normal_only>());
        },
        any_contacts);
  });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::begin_step() {
  if (history_stale) forget_all();
  if (neighbor->ago == 0) check_radii(lmp, coefficients.message_prefix(), largest_radius);
  if (contact_step->starts()) require_distinct_places();
  find_close();
}

/// Energy of spring and adhesion.
static double energy(const StoredEnergies& stored) { return stored.spring + stored.adhesion; }

/// Finds the pairs that may touch in this step. The neighbour list always contains the pairs with a
/// gap up to the flight allowance, and in the step of its rebuild those up to a skin more. If
/// particles fly farther than half of the allowance, it is rebuilt in each step, before the speed
/// can double.
template <class Cohesion>
void PairGranCohesive<Cohesion>::find_close() {
  // Both particles fly a whole step. The sampled scheme finds them as far beyond the edge.
  constexpr double flights = 4.0;
  const double flown = flights * contact_step->flight(), always = flight_allowance();
  const double at_most = always + neighbor->skin;
  const double now = neighbor->ago == 0 ? at_most : always;
  if (flown > now) stop_at_flight(flown / flights, now / flights);
  if (flown > 0.5 * always) contact_step->next_reneighbor = update->ntimestep + 1;
  if (flown > 0.7 * at_most) warn_of_flight(flown / flights, at_most / flights);
  const double reach = largest_range + flown;
  close_pairs.allow(largest_range + (flown > always ? at_most : always));
  // flight() is that of half a step.
  close_pairs.update(*list, reach, 2.0 * contact_step->flight(), contact_step->version_of_radii(),
                     {history->firstflag, history->firstvalue, per_pair});
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::stop_at_flight(double flight, double allowed) {
  error->one(FLERR,
             "{}: particles fly up to {} in half a step and could miss a contact, the neighbour "
             "list allows for {}: use a smaller time step or a skin above {}. The fastest: {}",
             coefficients.message_prefix(), flight, allowed, neighbor->skin * flight / allowed,
             report_fastest(lmp));
}

/// With the skin that the text names, the warning does not recur.
template <class Cohesion>
void PairGranCohesive<Cohesion>::warn_of_flight(double flight, double allowed) {
  if (warned_of_flight) return;
  warned_of_flight = true;
  if (comm->me == 0)
    error->warning(
        FLERR,
        "{}: particles fly up to {} in half a step, above 70 % of the {} at which the run "
        "stops, since they could miss a contact: use a smaller time step or a skin above {}",
        coefficients.message_prefix(), flight, allowed, neighbor->skin * flight / (0.7 * allowed));
}

template <class Cohesion>
template <int SIZE, class Contact>
void PairGranCohesive<Cohesion>::compute_contacts(Contacts<Contact>& contacts) {
  namespace contact = cohesion::contact;
  contacts.clear();
  // A loop for each normal law, of results that stay in registers; one for laws that differ and for
  // steps with momentum fluxes.
  const auto law = coefficients.only_law();
  if (Contact::is_exact && !contact_step->sums_flux() && law) {
    switch (*law) {
      case contact::LawKind::linear:
        return compute_by<SIZE, LinearContact>(contacts);
      case contact::LawKind::hertz:
        return compute_by<SIZE, IntegratedContact<contact::HertzSpringDashpot>>(contacts);
      case contact::LawKind::jkr:
        return compute_by<SIZE, IntegratedContact<contact::JkrSpringDashpot>>(contacts);
    }
  }
  compute_by<SIZE, ContactMotion>(contacts);
}

/// The same, with contacts that move by `By`.
template <class Cohesion>
template <int SIZE, class By, class Contact>
void PairGranCohesive<Cohesion>::compute_by(Contacts<Contact>& contacts) {
  const ContactForces<Contact, SIZE> forces(atom, contact_step);
  const StaggeredParticles now = particles();
  const auto loop = [&](auto tallies) {
    const bool full = evflag || contact_step->energy_tally.is_read() || !forces.may_persist();
    const bool sums_flux = std::is_same_v<By, ContactMotion> && contact_step->sums_flux();
    close_pairs.for_each_near([&](const ClosePair& pair) __attribute__((always_inline)) {
      const int i = pair.i, j = pair.j;
      const int index = contact_index(contacts, now, i, j);
      if (index == contacts.NONE) return hold(i, j, *pair.has_history, pair.history);
      const Contact& contact = contacts.all[index];
      FrictionalStep result;
      if (full || !*pair.has_history ||
          !forces.template apply_persistent<By, tallies>(contact, i, j, StaggeredPair{now, i, j},
                                                         pair.history, result))
        compute_contact<SIZE>(forces, contact, i, j, *pair.has_history, pair.history);
      else if (sums_flux)
        add_flux(forces.owned_fraction(j), now.motion(i, j), contact, result);
    });
  };
  if (contact_step->energy_tally.is_active())
    loop(std::true_type());
  else
    loop(std::false_type());
}

template <class Cohesion>
template <class Contact>
[[gnu::noinline]] void PairGranCohesive<Cohesion>::add_flux(double fraction, const PairMotion& now,
                                                            const Contact& c,
                                                            const FrictionalStep& result) {
  contact_step->flux.add(fraction, now.relative.separation, result.action.impulse,
                         c.by_contact(now, result));
}

/// Computes a pair in a step with output as in any other step, with what it stores. Returns false
/// for contacts that are not persistent.
template <class Cohesion>
template <int SIZE, class Contact>
bool PairGranCohesive<Cohesion>::read_persistent(const ContactForces<Contact, SIZE>& forces,
                                                 const Contact& c, int i, int j, double* values) {
  if (!forces.may_persist()) return false;
  const StaggeredParticles now = particles();
  double before[SIZE];
  std::copy_n(values, SIZE, before);
  FrictionalStep result;
  const StaggeredPair pair{now, i, j};
  const bool tallies = contact_step->energy_tally.is_active();
  if (!(tallies
            ? forces.template apply_persistent<ContactMotion, true>(c, i, j, pair, values, result)
            : forces.template apply_persistent<ContactMotion, false>(c, i, j, pair, values,
                                                                     result)))
    return false;
  const PairMotion motion = now.motion(i, j);
  const StoredEnergies stored = c.template stored_persistent<SIZE>(motion, before, values);
  if (tallies) contact_step->energy_tally.store(forces.owned_fraction(j), stored);
  if (contact_step->sums_flux()) add_flux(forces.owned_fraction(j), motion, c, result);
  if (evflag) tally(i, j, motion.relative.separation, energy(stored), result.action.impulse);
  return true;
}

/// Computes any pair. A pair out of range that may enter it in this step gets a history: only pairs
/// without one can stand in range without having moved there.
template <class Cohesion>
template <int SIZE, class Contact>
[[gnu::noinline]] void PairGranCohesive<Cohesion>::compute_contact(
    const ContactForces<Contact, SIZE>& forces, const Contact& c, int i, int j, int& has_history,
    double* values) {
  const bool reads = evflag || contact_step->energy_tally.is_read();
  if (reads && has_history && read_persistent<SIZE>(forces, c, i, j, values)) return;
  const StaggeredParticles now = particles();
  ContactState::restore_signs(values);
  ContactHistory known = has_history && !contact_step->starts()
                             ? ContactHistory::stored(values, SIZE)
                             : ContactHistory::unknown();
  if (known.normal.is_outside() &&
      !c.within_reach(now.relative_state(i, j), contact_step->moved_by_forces())) {
    has_history = 0;
    return;
  }
  if (!has_history) std::fill_n(values, per_pair, 0.0);
  const PairMotion motion = now.motion(i, j);
  ContactEnergies energies;
  const FrictionalStep result =
      forces.apply(c, i, j, motion, {}, known,
                   reads || contact_step->energy_tally.is_active() ? &energies : nullptr, reads);
  known.store(values, SIZE);
  has_history = 1;
  if (contact_step->sums_flux()) add_flux(forces.owned_fraction(j), motion, c, result);
  if (evflag)
    tally(i, j, motion.relative.separation, energy(energies.stored), result.action.impulse);
}

/// Leaves two particles that forces do not move in range of each other, unless a fix moves one
/// relative to the other.
template <class Cohesion>
void PairGranCohesive<Cohesion>::hold(int i, int j, int& has_history, double* values) const {
  if (!has_history) return;
  const bool led = contact_step->is_led(i) || contact_step->is_led(j);
  if (led && contact_step->carries_along(i, particles().relative_state(i, j).velocity)) {
    has_history = 0;
    return;
  }
  ContactState::restore_signs(values);
  const ContactState held = ContactState::stored(values).hold();
  held.store(values);
  has_history = held.phase != ContactState::outside;
}

/// Adds energy and virial of a pair; the impulse acts on j.
template <class Cohesion>
void PairGranCohesive<Cohesion>::tally(int i, int j, const Vector3& separation, double energy,
                                       const Vector3& impulse) {
  const Vector3 on_i = -contact_step->impulses.kick() * impulse;
  ev_tally_xyz(i, j, atom->nlocal, 0, energy, 0.0, on_i.x, on_i.y, on_i.z, -separation.x,
               -separation.y, -separation.z);
}

#define COHESION_INSTANTIATE(style, Law)                  \
  template void PairGranCohesive<Law>::compute(int, int); \
  template void PairGranCohesive<Law>::tally(int, int, const Vector3&, double, const Vector3&);
COHESION_PAIR_LAWS(COHESION_INSTANTIATE)
