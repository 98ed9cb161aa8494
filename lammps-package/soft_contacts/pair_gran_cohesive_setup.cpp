// SPDX-License-Identifier: GPL-2.0-only
// The part of PairGranCohesive that knows pairs at set-up of a run, and between two steps.
#include <algorithm>

#include "atom.h"
#include "common/distinct_places.h"
#include "contact_step/fix_contact_step.h"
#include "neigh_list.h"
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/pair_gran_cohesive.h"

using namespace LAMMPS_NS;
using namespace cohesion::contact_solver;
using cohesion::Vector3;

/// Calls what(i, j, has_history, values): whether the pair has a history, and that.
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

/// A pair of which nothing else is known is in the list of histories where it stands in range.
static bool is_inside(int has_history, const double* values) {
  if (!has_history) return false;
  const ContactState known = ContactState::stored(values);
  return known.in_range() || known.phase == ContactState::unknown;
}

/// After steps in which nothing acted.
template <class Cohesion>
void PairGranCohesive<Cohesion>::forget_all() {
  history_stale = false;
  for_each_listed([](int, int, int& has_history, double*) { has_history = 0; });
}

/// Sets which pairs are in range by where they are, where their histories do not tell: of pairs
/// without one, of those that something else than their motion has altered, and of all where laws
/// have other ranges.
template <class Cohesion>
void PairGranCohesive<Cohesion>::find_in_range() {
  std::visit(
      [this](auto& contacts) {
        contacts.clear();
        for_each_listed([&](int i, int j, int& has_history, double* values) {
          if (has_history && !step->is_altered(i, j) && !coefficients.has_other_ranges()) return;
          const double apart = distance(i, j);
          // Contacts are made for those only that some contact could reach.
          bool near = moves(i, j) && apart < atom->radius[i] + atom->radius[j] + largest_range;
          if (near) {
            const auto& law = contacts.all[contact(contacts, particles(), i, j)];
            near = is_inside(has_history, values) ? apart < law.bodies().distance() + law.range()
                                                  : law.is_in_range(apart);
          }
          const ContactHistory known =
              (has_history ? ContactHistory::stored(values, per_pair) : ContactHistory())
                  .moved(near);
          known.store(values, per_pair);
          has_history = !known.normal.is_outside() || near;
        });
      },
      any_contacts);
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
  if (!step->energy_tally.is_active()) return;
  for_each_with_history([this](int, int j, const StoredEnergies& stored) {
    step->energy_tally.store_normal(j < atom->nlocal ? 1.0 : 0.5, stored);
  });
}

/// Contacts without friction leave alone what is remembered of springs, and may get friction again.
template <class Cohesion>
void PairGranCohesive<Cohesion>::forget_springs() {
  for_each_listed([this](int, int, int has_history, double* values) {
    if (has_history) std::fill(values + HistorySize::normal_only, values + per_pair, 0.0);
  });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::tally_energies_at_setup() {
  for_each_with_history([this](int i, int j, const StoredEnergies& stored) {
    const Vector3 d = particles().relative_state(i, j).separation;
    ev_tally_xyz(i, j, atom->nlocal, 0, stored.spring + stored.adhesion, 0.0, 0.0, 0.0, 0.0, -d.x,
                 -d.y, -d.z);
  });
}

/// Calls what(i, j, energies) for each pair with a history.
template <class Cohesion>
template <class What>
void PairGranCohesive<Cohesion>::for_each_with_history(const What& what) {
  std::visit(
      [&](auto& contacts) {
        contacts.clear();
        for_each_listed([&](int i, int j, int has_history, const double* values) {
          if (!has_history || !moves(i, j)) return;
          const auto& c = contacts.all[contact(contacts, particles(), i, j)];
          what(i, j,
               c.stored(particles().relative_state(i, j).separation,
                        ContactHistory::stored(values, per_pair)));
        });
      },
      any_contacts);
}

/// Appends the pairs within the range of the attraction, where that binds; else those within the
/// range of contact and adhesion, of those that have a history or, where nothing acts, would have
/// one.
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

#define COHESION_INSTANTIATE(style, Law)                                \
  template void PairGranCohesive<Law>::forget_all();                    \
  template void PairGranCohesive<Law>::tally_energies_at_setup();       \
  template void PairGranCohesive<Law>::continue_run();                  \
  template void PairGranCohesive<Law>::require_distinct_places() const; \
  template void PairGranCohesive<Law>::append_bound(std::vector<std::array<int, 2>>&) const;
COHESION_PAIR_LAWS(COHESION_INSTANTIATE)
