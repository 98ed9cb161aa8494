// SPDX-License-Identifier: GPL-2.0-only
// The part of PairGranCohesive that computes the pairs of a step.
#include <algorithm>
#include <type_traits>

#include "atom.h"
#include "cohesion_laws.h"
#include "comm.h"
#include "error.h"
#include "fix_event_step.h"
#include "flight_report.h"
#include "guarded.h"
#include "largest_radii.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran_cohesive.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::event_stepping;
using cohesion::Vector3;

template <class Cohesion>
void PairGranCohesive<Cohesion>::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  coefficients.require_committed();
  if (update->whichflag == 2)
    error->all(FLERR, coefficients.where() + " follows motion in time; it cannot be minimized");
  if (!is_active) {
    history_stale = true;
    return;
  }
  if (step->resumes()) {
    if (evflag) tally_energies_at_setup();
    return;
  }
  step->run_corrector([this] {
    with_contacts([this](auto& contacts, auto size) { compute_forces<size>(contacts); });
  });
}

/// Calls what(contacts, size of their history).
template <class Cohesion>
template <class What>
void PairGranCohesive<Cohesion>::with_contacts(const What& what) {
  guarded(lmp, coefficients.where(), [&] {
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
void PairGranCohesive<Cohesion>::classify() {
  if (!is_active) return;
  if (history_stale) forget_all();
  if (neighbor->ago == 0) check_radii(lmp, coefficients.where(), largest_radius);
  if (step->starts()) require_distinct_places();
  with_contacts([this](auto& contacts, auto size) { classify<size>(contacts); });
}

/// The same, in scheme event only.
template <class Cohesion>
template <class What>
void PairGranCohesive<Cohesion>::with_event_contacts(const What& what) {
  if (is_active)
    with_contacts([&](auto& contacts, auto size) {
      if constexpr (std::is_same_v<std::decay_t<decltype(contacts)>, Contacts<EventContact>>)
        what(contacts, size);
    });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::follow_disturbed() {
  with_event_contacts([this](auto& contacts, auto size) { follow_disturbed<size>(contacts); });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::follow_far() {
  with_event_contacts([this](auto& contacts, auto size) {
    contacts_now.follow_far(
        ContactsOfStep<EventContact, size>(atom, step), step, contacts.all,
        [this](const LastingContact& p) { return particles().motion(p.i, p.j); });
  });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::couple_lasting() {
  with_event_contacts([this](auto& contacts, auto size) { couple_lasting<size>(contacts); });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::predict() {
  with_event_contacts([this](auto& contacts, auto size) {
    contacts_now.predict(ContactsOfStep<EventContact, size>(atom, step), step, contacts.all);
  });
}

/// Energy of spring and adhesion.
static double energy(const StoredEnergies& stored) { return stored.spring + stored.adhesion; }

/// Finds the pairs that may touch in this step. The list of neighbours always contains the pairs
/// with a gap up to the allowance for flight; in the step in which it is built, it contains those
/// with a gap up to a skin more. So it is built in each step from half of the allowance on, before
/// the speed has doubled.
template <class Cohesion>
void PairGranCohesive<Cohesion>::find_close() {
  // Both fly a whole step from the grid point; sampled, they are found as far beyond the edge.
  constexpr double flights = 4.0;
  const double flown = flights * step->flight(), always = flight_allowance();
  const double at_most = always + neighbor->skin;
  const double now = neighbor->ago == 0 ? at_most : always;
  if (flown > now) stop_at_flight(flown / flights, now / flights);
  if (flown > 0.5 * always) step->next_reneighbor = update->ntimestep + 1;
  if (flown > 0.7 * at_most) warn_of_flight(flown / flights, at_most / flights);
  const double reach = largest_range + flown;
  close_pairs.allow(largest_range + (flown > always ? at_most : always));
  // A flight is of half a step.
  close_pairs.update(*list, reach, 2.0 * step->flight(), step->version_of_radii(),
                     {history->firstflag, history->firstvalue, per_pair});
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::stop_at_flight(double flight, double allowed) {
  error->one(FLERR,
             "{}: particles fly up to {} in half a step and could miss a contact, the neighbour "
             "list allows for {}: use a smaller time step or a skin above {}. The fastest: {}",
             coefficients.where(), flight, allowed, neighbor->skin * flight / allowed,
             report_fastest(lmp));
}

/// The skin that it names ends the warning.
template <class Cohesion>
void PairGranCohesive<Cohesion>::warn_of_flight(double flight, double allowed) {
  if (warned_of_flight) return;
  warned_of_flight = true;
  if (comm->me == 0)
    error->warning(
        FLERR,
        "{}: particles fly up to {} in half a step, above 70 % of the {} at which the run "
        "stops, since they could miss a contact: use a smaller time step or a skin above {}",
        coefficients.where(), flight, allowed, neighbor->skin * flight / (0.7 * allowed));
}

/// Calls what(i, j, has_history, history) for the pairs that may touch in this step.
template <class Cohesion>
template <class What>
[[gnu::always_inline]] inline void PairGranCohesive<Cohesion>::for_each_close(const What& what) {
  close_pairs.for_each_near([&](const ClosePair& pair) __attribute__((always_inline)) {
    what(pair.i, pair.j, *pair.has_history, pair.history);
  });
}

/// Adds what a contact does to the sums of momentum flux, if somebody reads them.
template <class Cohesion>
auto PairGranCohesive<Cohesion>::flux_sum() {
  return [sums = step->sums_flux(), this](int j, const PairMotion& grid, const Vector3& impulse,
                                          const auto& by_contact, double factor) {
    if (sums)
      step->flux.add(factor * (j < atom->nlocal ? 1.0 : 0.5), grid.relative.separation, impulse,
                     by_contact());
  };
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::classify(Contacts<EventContact>& contacts) {
  contacts_now.clear();
  contacts.clear();
  const ContactsOfStep<EventContact, SIZE> scatter(atom, step);
  find_close();
  const LastingForces<EventContact, SIZE> lasting(atom, step);
  const bool recorded = step->energy_tally.is_active() || step->sums_flux();
  const ParticlesOnGrid grid = particles();
  for_each_close([&](int i, int j, int& has_history,
                     double* values) __attribute__((always_inline)) {
    const int c = contact(contacts, grid, i, j);
    if (c == contacts.NONE) return forget_if_led(i, j, has_history);
    if (has_history && !recorded && lasting.apply(contacts.all[c], i, j, grid.motion(i, j), values))
      contacts_now.lasting.add() = {i, j, c, values};
    else
      classify_one<SIZE>(scatter, contacts.all[c], c, i, j, has_history, values);
  });
}

/// What is remembered of two particles that forces do not move holds until something else moves one
/// along the other.
template <class Cohesion>
void PairGranCohesive<Cohesion>::forget_if_led(int i, int j, int& has_history) const {
  if (!has_history || !(step->is_led(i) || step->is_led(j))) return;
  const Vector3 w = particles().relative_state(i, j).velocity;
  if (dot(w, w) > 0.0) has_history = 0;
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::classify_one(const ContactsOfStep<EventContact, SIZE>& scatter,
                                              const EventContact& law, int contact, int i, int j,
                                              int& has_history, double* values) {
  if (!has_history || values[0] == ContactMemory::beyond) {
    const bool is_known = has_history;
    has_history = 0;
    const RelativeState now = particles().relative_state(i, j);
    if (!law.within_reach(now, step->flight())) return;
    std::fill_n(values, per_pair, 0.0);
    if (!is_known && law.stands_within(now, range_at_start(law), last_step()))
      ContactMemory::seen_inside().to(values, per_pair);
  }
  has_history = 1;
  contacts_now.classify<SIZE>(scatter, step, law, contact, i, j, particles().motion(i, j), values,
                              step->only_contacts_act(), flux_sum());
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::follow_disturbed(Contacts<EventContact>& contacts) {
  const ContactsOfStep<EventContact, SIZE> scatter(atom, step);
  contacts_now.follow_disturbed<SIZE>(
      scatter, step, contacts.all,
      [this](const LastingContact& p) { return particles().motion(p.i, p.j); }, flux_sum());
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::couple_lasting(Contacts<EventContact>& contacts) {
  contacts_now.couple_lasting<SIZE>(
      ContactsOfStep<EventContact, SIZE>(atom, step), step, contacts.all,
      [this](const LastingContact& p) { return particles().motion(p.i, p.j); });
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::compute_forces(Contacts<EventContact>& contacts) {
  const ContactsOfStep<EventContact, SIZE> scatter(atom, step);
  if (evflag)
    contacts_now.for_each_lasting<SIZE>(
        contacts.all, [this](const LastingContact& p) { return particles().motion(p.i, p.j); },
        [](const LastingContact&) { return true; },
        [&](const LastingContact& p, const ContactMemory&, const ContactMemory& known,
            const PairMotion& grid, const auto& action) {
          tally(p.i, p.j, grid.relative.separation,
                energy(contacts.all[p.contact].stored(grid, known)), action().impulse);
        });
  if (evflag)
    for (const LastingContact& p : contacts_now.idle) {
      const PairMotion grid = particles().motion(p.i, p.j);
      const ContactMemory known = ContactMemory::from(p.history, SIZE);
      tally(p.i, p.j, grid.relative.separation, energy(contacts.all[p.contact].stored(grid, known)),
            {});
    }
  // The corrector replaces what a contact remembers.
  std::vector<double> before;
  if (evflag)
    for (const FollowedContact& p : contacts_now.followed)
      before.push_back(energy(contacts.all[p.contact].stored(
          particles().motion(p.i, p.j), ContactMemory::as_stored(p.history, SIZE))));
  std::size_t next = 0;
  const auto sum = flux_sum();
  contacts_now.correct(scatter, step, contacts.all,
                       [&](int j, const PairMotion& grid, const Vector3& impulse,
                           const auto& by_contact, double factor) {
                         sum(j, grid, impulse, by_contact, factor);
                         if (!evflag) return;
                         tally(contacts_now.followed[next].i, j, grid.relative.separation,
                               before[next], impulse);
                         next++;
                       });
}

/// Sampled contacts do not wait for each other.
template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::classify(Contacts<SampledContact>&) {
  find_close();
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::compute_forces(Contacts<SampledContact>& contacts) {
  contacts.clear();
  const ContactsOfStep<SampledContact, SIZE> scatter(atom, step);
  const SampledForces<SampledContact, SIZE> forces(atom, step);
  const bool recorded = step->energy_tally.is_active() || step->sums_flux() || evflag ||
                        step->impulses.are_told_apart();
  const ParticlesOnGrid grid = particles();
  for_each_close([&](int i, int j, int& has_history, double* values)
                     __attribute__((always_inline)) {
                       const int c = contact(contacts, grid, i, j);
                       if (c == contacts.NONE) return forget_if_led(i, j, has_history);
                       const SampledContact& law = contacts.all[c];
                       if (!has_history) {
                         const RelativeState now = grid.relative_state(i, j);
                         if (!law.within_reach(now)) return;
                         std::fill_n(values, per_pair, 0.0);
                         values[0] = law.stands_within(now, range_at_start(law), last_step());
                       }
                       if (recorded || values[0] < 0.0)
                         has_history = sample<SIZE>(scatter, law, i, j, values);
                       else
                         has_history = forces.apply(law, i, j, grid.motion(i, j), values);
                       // One that others pushed into the range has not come there by its motion.
                       if (!has_history) has_history = law.within_reach(grid.relative_state(i, j));
                     });
}

/// A sampled contact whose impulse goes into tallies. Returns whether it remembers anything.
template <class Cohesion>
template <int SIZE>
[[gnu::noinline]] bool PairGranCohesive<Cohesion>::sample(
    const ContactsOfStep<SampledContact, SIZE>& scatter, const SampledContact& c, int i, int j,
    double* values) {
  const PairMotion grid = particles().motion(i, j);
  ContactMemory known = ContactMemory::from(values, SIZE);
  const SampledStep now = LAMMPS_NS::sample(scatter, step, c, i, j, grid, known);
  known.to(values, SIZE);
  flux_sum()(j, grid, now.action.impulse, [&] { return c.by_contact(grid, now); }, 1.0);
  if (evflag)
    tally(i, j, grid.relative.separation, energy(c.stored(grid, known)), now.action.impulse);
  return known.in_range();
}

/// Energy and virial, of an impulse on j.
template <class Cohesion>
void PairGranCohesive<Cohesion>::tally(int i, int j, const Vector3& separation, double energy,
                                       const Vector3& impulse) {
  const Vector3 on_i = -step->impulses.kick() * impulse;
  ev_tally_xyz(i, j, atom->nlocal, 0, energy, 0.0, on_i.x, on_i.y, on_i.z, -separation.x,
               -separation.y, -separation.z);
}

#define COHESION_INSTANTIATE(style, Law)                   \
  template void PairGranCohesive<Law>::compute(int, int);  \
  template void PairGranCohesive<Law>::classify();         \
  template void PairGranCohesive<Law>::follow_disturbed(); \
  template void PairGranCohesive<Law>::follow_far();       \
  template void PairGranCohesive<Law>::couple_lasting();   \
  template void PairGranCohesive<Law>::predict();          \
  template void PairGranCohesive<Law>::tally(int, int, const Vector3&, double, const Vector3&);
COHESION_PAIR_LAWS(COHESION_INSTANTIATE)
