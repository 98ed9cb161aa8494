// SPDX-License-Identifier: GPL-2.0-only
#include "soft_contacts/pair_gran_cohesive.h"

#include <algorithm>
#include <string>

#include "advice/warning_filter.h"
#include "atom.h"
#include "common/engine_api.h"
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
#include "soft_contacts/cohesion_laws.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::contact_solver;
using cohesion::Vector3;

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
    any_contacts.template emplace<static_cast<int>(Scheme::exact)>();
  else
    any_contacts.template emplace<static_cast<int>(Scheme::sampled)>();
  std::visit([this](auto& contacts) { contacts.last.resize(coefficients.type_pairs()); },
             any_contacts);
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
  return coefficients.any_rolls() ? HistorySize::with_rolling : HistorySize::with_friction;
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
