// SPDX-License-Identifier: GPL-2.0-only
#include "soft_contacts/pair_gran_cohesive.h"

#include <algorithm>
#include <string>

#include "advice/warning_filter.h"
#include "atom.h"
#include "comm.h"
#include "common/engine_api.h"
#include "common/guarded.h"
#include "common/plausible_sizes.h"
#include "contact_step/fix_contact_step.h"
#include "engine/flight_report.h"
#include "engine/largest_radii.h"
#include "engine/special_pairs.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "soft_contacts/cohesion_laws.h"
#include "update.h"

using namespace LAMMPS_NS;
using cohesion::Vector3;
using cohesion::contact_solver::Body;

template <class Cohesion>
PairGranCohesive<Cohesion>::PairGranCohesive(LAMMPS* lammps)
    : Pair(lammps),
      coefficients(lammps),
      advice_filter(std::make_unique<cohesion::advice::WarningFilter>()),
      close_pairs(lammps),
      largest_range(0.0),
      friction(false),
      is_active(false),
      needs_list(true),
      history_stale(false),
      per_pair(0),
      contact_step(nullptr),
      history(lammps, Cohesion::STYLE) {
  single_enable = 1;
  restartinfo = 1;
  no_virial_fdotr_compute = 1;
  finitecutflag = 1;
  beyond_contact = 1;
  FixContactStep::reserve(lmp);
}

template <class Cohesion>
PairGranCohesive<Cohesion>::~PairGranCohesive() {
  delete[] svector;
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::allocate() {
  allocated = 1;
  const int types = atom->ntypes;
  memory->create(setflag, types + 1, types + 1, "pair:setflag");
  memory->create(cutsq, types + 1, types + 1, "pair:cutsq");
  coefficients.make_room(types, setflag);
}

/* ---------------------------------------------------------------------- */

template <class Cohesion>
void PairGranCohesive<Cohesion>::coeff(int narg, char** arg) {
  if (narg < 4)
    error->all(FLERR, std::string("pair_coeff of ") + Cohesion::STYLE + " takes 'i j " +
                          Cohesion::COEFFICIENTS);
  if (!allocated) allocate();
  coefficients.read(narg, arg);
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::init_style() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR,
               coefficients.message_prefix() + " acts between spheres; use 'atom_style sphere'");
  contact_step = FixContactStep::of(lmp);
  // pair_style hybrid of several versions of the engine copies these numbers beyond their end.
  if (force->pair == this && single_extra == 0) {
    svector = new double[SINGLE_EXTRA];
    single_extra = SINGLE_EXTRA;
  }
  require_time_step(lmp, coefficients.message_prefix());
  require_plausible_spheres(lmp, coefficients.message_prefix());
  require_whole_special_factors(lmp, this, coefficients.message_prefix(), true);
  largest_radius = largest_radii(lmp);
  smallest_radius = smallest_radii(lmp, largest_radius);
  coefficients.start();
  is_active = coefficients.any_active();
  if (coefficients.scheme() == Scheme::exact)
    pair_contacts.emplace(contacts_of_run<ExactContact>());
  else
    pair_contacts.emplace(contacts_of_run<SampledContact>());
  friction = false;
  largest_range = 0.0;
  warned_of_flight = false;
  close_pairs.start(flight_allowance());
  needs_list = is_active || per_pair > 0 || bound_pairs_are_read();
  if (!needs_list) {
    list = nullptr;
    return;
  }
  engine_api::request_history_list(neighbor, this, instance_me);
  const int needed = values_per_pair();
  if (per_pair == 0) per_pair = needed;
  if (per_pair < needed)
    error->all(FLERR,
               coefficients.message_prefix() +
                   ": rolling_friction cannot begin here: the contacts of the run before, or "
                   "of the restart file, remember no rolling; give it from the first run on");
  history.init(this, per_pair);
}

template <class Cohesion>
bool PairGranCohesive<Cohesion>::bound_pairs_are_read() const {
  return std::any_of(modify->fix, modify->fix + modify->nfix,
                     [](Fix* fix) { return dynamic_cast<BoundPairsReader*>(fix) != nullptr; });
}

template <class Cohesion>
int PairGranCohesive<Cohesion>::values_per_pair() const {
  return coefficients.any_rolls() ? ContactHistory::with_rolling : ContactHistory::with_friction;
}

/// The part of the skin reserved for the flight of both particles within a step. A fifth suffices
/// wherever the engine's own check of the neighbour list is valid.
template <class Cohesion>
double PairGranCohesive<Cohesion>::flight_allowance() const {
  return 0.2 * neighbor->skin;
}

template <class Cohesion>
double PairGranCohesive<Cohesion>::init_one(int i, int j) {
  double range = coefficients.prepare(i, j, largest_radius[i], largest_radius[j]);
  // Pairs are bound up to this range, and a load may carry one this far before it leaves.
  if (Cohesion::BINDS_IN_RANGE)
    range = std::max(range, coefficients.range_of_attraction(coefficients.pair_index(i, j)));
  coefficients.require_short(i, j, smallest_radius[i], smallest_radius[j]);
  require_plausible_range(lmp, coefficients.message_prefix(),
                          largest_radius[i] + largest_radius[j] + range);
  const auto& contact = coefficients.contact(coefficients.pair_index(i, j));
  friction = friction || contact.friction > 0.0;
  if (!needs_list) return largest_radius[i] + largest_radius[j];
  largest_range = std::max(largest_range, range);
  close_pairs.start(largest_range + flight_allowance());
  return largest_radius[i] + largest_radius[j] + range + flight_allowance();
}

template <class Cohesion>
template <class Contact>
PairContacts<Contact> PairGranCohesive<Cohesion>::contacts_of_run() {
  const auto create = [this](int i, int j, const Body& a, const Body& b) {
    const int types = coefficients.pair_index(atom->type[i], atom->type[j]);
    return contact_step->contact<Contact>(
        coefficients.contact(types),
        coefficients.template attraction<typename Contact::Attraction>(types, a.radius, b.radius),
        a, b);
  };
  const auto add_to_tally = [this](int i, int j, const Vector3& separation, double energy,
                                   const Vector3& impulse) {
    tally(i, j, separation, energy, impulse);
  };
  return {lmp, contact_step, create, add_to_tally};
}

/* ---------------------------------------------------------------------- */

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
    const int size = friction || per_pair == ContactHistory::with_rolling
                         ? per_pair
                         : ContactHistory::normal_only;
    guarded(lmp, coefficients.message_prefix(), [this, size] {
      std::visit(
          [this, size](auto& c) { c.compute(close_pairs, size, coefficients.only_law(), evflag); },
          contacts_by_scheme());
    });
  });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::begin_step() {
  if (history_stale) forget_all();
  if (neighbor->ago == 0) check_radii(lmp, coefficients.message_prefix(), largest_radius);
  if (contact_step->starts()) require_distinct_places();
  find_close();
}

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
                     *history, per_pair);
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

/// Adds energy and virial of a pair; the impulse acts on j.
template <class Cohesion>
void PairGranCohesive<Cohesion>::tally(int i, int j, const Vector3& separation, double energy,
                                       const Vector3& impulse) {
  const Vector3 on_i = -contact_step->impulses.kick() * impulse;
  ev_tally_xyz(i, j, atom->nlocal, 0, energy, 0.0, on_i.x, on_i.y, on_i.z, -separation.x,
               -separation.y, -separation.z);
}

/* ---------------------------------------------------------------------- */

template <class Cohesion>
void PairGranCohesive<Cohesion>::write_restart(FILE* fp) {
  write_restart_settings(fp);
  coefficients.write(fp);
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::read_restart(FILE* fp) {
  read_restart_settings(fp);
  allocate();
  coefficients.read(fp);
}

#define COHESION_INSTANTIATE(style, Law) template class LAMMPS_NS::PairGranCohesive<Law>;
COHESION_PAIR_LAWS(COHESION_INSTANTIATE)
