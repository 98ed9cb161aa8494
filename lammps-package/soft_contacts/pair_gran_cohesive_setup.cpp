// SPDX-License-Identifier: GPL-2.0-only
// The part of PairGranCohesive for set-up of a run and for outputs between two steps.
#include <algorithm>
#include <cmath>

#include "atom.h"
#include "common/distinct_places.h"
#include "contact_solver/contact_output.h"
#include "contact_step/altered_particles.h"
#include "contact_step/fix_contact_step.h"
#include "neigh_list.h"
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/pair_gran_cohesive.h"

using namespace LAMMPS_NS;
using namespace cohesion::contact_solver;
using cohesion::Vector3;

/// Calls what(i, j, has_history, values) for each pair of the neighbour list.
template <class Cohesion>
template <class What>
void PairGranCohesive<Cohesion>::for_each_listed(const What& what) const {
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      double* const values = &history->firstvalue[i][per_pair * jj];
      if (history->firstflag[i][jj]) ContactState::restore_signs(values);
      what(i, list->firstneigh[i][jj] & NEIGHMASK, history->firstflag[i][jj], values);
    }
  }
}

/// Whether the stored state is that of a pair in range.
static bool is_inside(int has_history, const double* values) {
  if (!has_history) return false;
  const ContactState known = ContactState::stored(values);
  return known.in_range() || known.phase == ContactState::unknown;
}

/// Clears all histories, after steps in which no contact was computed.
template <class Cohesion>
void PairGranCohesive<Cohesion>::forget_all() {
  history_stale = false;
  for_each_listed([](int, int, int& has_history, double*) { has_history = 0; });
}

/// Whether the stored state of a pair does not say whether it is in range: a script has changed its
/// gap, or the range of the law between its particles.
template <class Cohesion>
bool PairGranCohesive<Cohesion>::is_altered(int i, int j) const {
  const AlteredParticles& altered = contact_step->altered_particles();
  return coefficients.has_other_ranges() || altered.has_other_gap(i, j) ||
         coefficients.have_other_ranges(
             coefficients.pair_index(atom->type[i], atom->type[j]),
             coefficients.pair_index(altered.type_before(i), altered.type_before(j)));
}

/// Decides by their distance which pairs are in range if their histories do not determine it: pairs
/// without a history, pairs that a script has altered, and all pairs where ranges of laws have
/// changed.
template <class Cohesion>
void PairGranCohesive<Cohesion>::find_in_range() {
  std::visit(
      [this](auto& all) {
        all.clear();
        for_each_listed([&](int i, int j, int& has_history, double* values) {
          if (has_history && !is_altered(i, j)) return;
          const double apart = distance(i, j);
          // The contact is needed only for pairs within the largest range.
          bool near = moves(i, j) && apart < atom->radius[i] + atom->radius[j] + largest_range;
          if (near) {
            const auto& contact = all.between(i, j);
            near = is_inside(has_history, values)
                       ? apart < contact.bodies().distance() + contact.range()
                       : contact.is_in_range(apart);
          }
          const ContactHistory known =
              (has_history ? ContactHistory::stored(values, per_pair) : ContactHistory())
                  .moved(near);
          known.store(values, per_pair);
          has_history = !known.normal.is_outside() || near;
        });
      },
      contacts_by_scheme());
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::require_distinct_places() const {
  LAMMPS_NS::require_distinct_places(lmp, coefficients.message_prefix(), list,
                                     [this](int i, int j) { return moves(i, j); });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::continue_run() {
  if (!is_active) return;
  require_distinct_places();
  if (history_stale) forget_all();
  find_in_range();
  if (!friction) forget_springs();
  if (!contact_step->energy_tally.is_active()) return;
  for_each_with_history([this](int, int j, const auto& contact, const Vector3& separation,
                               const ContactHistory& known) {
    contact_step->energy_tally.store_normal(j < atom->nlocal ? 1.0 : 0.5,
                                            contact.stored(separation, known));
  });
}

/// Clears the tangential springs. Contacts without friction do not update them, and a later run may
/// have friction again.
template <class Cohesion>
void PairGranCohesive<Cohesion>::forget_springs() {
  for_each_listed([this](int, int, int has_history, double* values) {
    if (has_history) std::fill(values + ContactHistory::normal_only, values + per_pair, 0.0);
  });
}

/// Adds the forces of the last step while a run that continues it is set up: for outputs alone,
/// since the first step begins with all forces of the last one.
template <class Cohesion>
void PairGranCohesive<Cohesion>::repeat_forces() {
  for_each_with_history([this](int i, int j, const auto& contact, const Vector3& separation,
                               const ContactHistory& known) {
    const auto forces = forces_of(contact, separation, known, contact_step->forces_length());
    contact_step->repeat_forces(i, j, forces);
    if (!evflag) return;
    const StoredEnergies stored = contact.stored(separation, known);
    ev_tally_xyz(i, j, atom->nlocal, 0, stored.potential(), 0.0, -forces.impulse.x,
                 -forces.impulse.y, -forces.impulse.z, -separation.x, -separation.y, -separation.z);
  });
}

/// Calls what(i, j, contact, separation, history) for each pair with a history.
template <class Cohesion>
template <class What>
void PairGranCohesive<Cohesion>::for_each_with_history(const What& what) {
  std::visit(
      [&](auto& all) {
        all.clear();
        for_each_listed([&](int i, int j, int has_history, double* values) {
          if (!has_history || !moves(i, j)) return;
          ContactState::restore_signs(values);
          what(i, j, all.between(i, j), separation(i, j), ContactHistory::stored(values, per_pair));
        });
      },
      contacts_by_scheme());
}

/// The history of j in the list of i, or null.
template <class Cohesion>
const double* PairGranCohesive<Cohesion>::stored_history(int i, int j) const {
  const int* const listed = list->firstneigh[i];
  for (int jj = 0; jj < list->numneigh[i]; jj++)
    if ((listed[jj] & NEIGHMASK) == j)
      return history->firstflag[i][jj] ? &history->firstvalue[i][per_pair * jj] : nullptr;
  return nullptr;
}

static void put(const Vector3& a, double factor, double* numbers) {
  numbers[0] = factor * a.x;
  numbers[1] = factor * a.y;
  numbers[2] = factor * a.z;
}

template <class Cohesion>
double PairGranCohesive<Cohesion>::single(int i, int j, int, int, double rsq, double, double,
                                          double& over_distance) {
  over_distance = 0.0;
  std::fill_n(svector, single_extra, 0.0);
  if (single_extra > 0) svector[1] = atom->radius[i] + atom->radius[j] - std::sqrt(rsq);
  if (!is_active || history_stale || !moves(i, j)) return 0.0;
  // Another neighbour list may contain the pair in the other order.
  const double* in_list = stored_history(i, j);
  const bool swapped = !in_list && j < atom->nlocal;
  if (swapped) in_list = stored_history(j, i);
  if (!in_list) return 0.0;
  std::vector<double> values(in_list, in_list + per_pair);
  ContactState::restore_signs(values.data());
  const ContactOutput found = std::visit(
      [&](auto& all) {
        return output_of(all.between(i, j), separation(i, j),
                         ContactHistory::stored(values.data(), per_pair),
                         contact_step->forces_length());
      },
      contacts_by_scheme());
  over_distance = found.force / std::sqrt(rsq);
  if (single_extra > 0) {
    svector[0] = found.place;
    svector[2] = found.limiting;
    svector[3] = norm(found.friction);
    put(found.friction, swapped ? -1.0 : 1.0, svector + 4);
    put(found.rolling_torque, swapped ? -1.0 : 1.0, svector + 7);
  }
  return found.energy;
}

/// Appends the bound pairs: those within the range of the attraction if the law binds by range,
/// otherwise those whose history is in range. Where no contact is computed, touching pairs count.
template <class Cohesion>
void PairGranCohesive<Cohesion>::append_bound(std::vector<std::array<int, 2>>& pairs) const {
  for_each_listed([&](int i, int j, int has_history, const double* values) {
    bool bound;
    if constexpr (Cohesion::BINDS_IN_RANGE) {
      const int types = coefficients.pair_index(atom->type[i], atom->type[j]);
      const double range = coefficients.range_of_attraction(types);
      bound =
          range > 0.0 && moves(i, j) && distance(i, j) < atom->radius[i] + atom->radius[j] + range;
    } else {
      bound = history_stale ? moves(i, j) && distance(i, j) < atom->radius[i] + atom->radius[j]
                            : is_inside(has_history, values);
    }
    if (bound) pairs.push_back({i, j});
  });
}

#define COHESION_INSTANTIATE(style, Law)                                                    \
  template void PairGranCohesive<Law>::forget_all();                                        \
  template void PairGranCohesive<Law>::repeat_forces();                                     \
  template void PairGranCohesive<Law>::continue_run();                                      \
  template void PairGranCohesive<Law>::require_distinct_places() const;                     \
  template double PairGranCohesive<Law>::single(int, int, int, int, double, double, double, \
                                                double&);                                   \
  template void PairGranCohesive<Law>::append_bound(std::vector<std::array<int, 2>>&) const;
COHESION_PAIR_LAWS(COHESION_INSTANTIATE)
