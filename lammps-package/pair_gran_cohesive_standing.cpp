// SPDX-License-Identifier: GPL-2.0-only
// The part of PairGranCohesive that looks at pairs where they stand, between two steps.
#include <algorithm>

#include "atom.h"
#include "cohesion_laws.h"
#include "fix_event_step.h"
#include "neigh_list.h"
#include "pair_gran_cohesive.h"

using namespace LAMMPS_NS;
using namespace cohesion::event_stepping;
using cohesion::Vector3;

/// Calls what(i, j, kept, values): whether the pair has a history, and that.
template <class Cohesion>
template <class What>
void PairGranCohesive<Cohesion>::for_each_listed(const What& what) const {
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++)
      what(i, list->firstneigh[i][jj] & NEIGHMASK, history->firstflag[i][jj],
           &history->firstvalue[i][per_pair * jj]);
  }
}

/// After steps in which no pair was followed (`afresh`), or something else than their motion
/// brought particles where they are; those that are still in range remember what they did.
template <class Cohesion>
void PairGranCohesive<Cohesion>::begin_where_they_are(bool afresh) {
  rested = false;
  std::visit(
      [this, afresh](auto& contacts) {
        contacts.clear();
        for_each_listed([&](int i, int j, int& kept, double* values) {
          // Contacts are made for those only that some contact could reach.
          bool near = moves(i, j) && closer(largest_range, i, j);
          if (near) {
            const auto& law = contacts.all[contact(contacts, particles(), i, j)];
            near = closer(kept && !afresh ? law.range() : range_at_start(law), i, j);
          }
          if (near && kept && !afresh) return;
          (near ? ContactMemory::seen_inside() : ContactMemory()).to(values, per_pair);
          kept = near;
        });
      },
      any_contacts);
}

/// Energies of the pairs where they stand, for a run that takes over the forces of the last one.
template <class Cohesion>
void PairGranCohesive<Cohesion>::book_standing() {
  if (!acts) return;
  if (rested) begin_where_they_are(true);
  if (step->box_changed()) begin_where_they_are(false);
  if (!step->book.is_kept()) return;
  for_each_standing([this](int, int j, const StoredEnergies& stored) {
    step->book.store_again(j < atom->nlocal ? 1.0 : 0.5, stored);
  });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::tally_standing() {
  for_each_standing([this](int i, int j, const StoredEnergies& stored) {
    const Vector3 d = particles().apart(i, j).separation;
    ev_tally_xyz(i, j, atom->nlocal, 0, stored.spring + stored.adhesion, 0.0, 0.0, 0.0, 0.0, -d.x,
                 -d.y, -d.z);
  });
}

/// Calls what(i, j, energies) for each pair with a history.
template <class Cohesion>
template <class What>
void PairGranCohesive<Cohesion>::for_each_standing(const What& what) {
  std::visit(
      [&](auto& contacts) {
        contacts.clear();
        for_each_listed([&](int i, int j, int kept, const double* values) {
          if (!kept || !moves(i, j)) return;
          const auto& c = contacts.all[contact(contacts, particles(), i, j)];
          what(i, j, c.stored(particles().motion(i, j), ContactMemory::from(values, per_pair)));
        });
      },
      any_contacts);
}

static bool is_inside(int kept, const double* values) {
  return kept && ContactMemory::from(values, HistorySize::normal_only).in_range();
}

/// Bound are the pairs within the range of contact and adhesion, of those that are followed or,
/// where nothing acts, would be.
template <class Cohesion>
void PairGranCohesive<Cohesion>::append_bound(std::vector<std::array<int, 2>>& pairs) const {
  for_each_listed([&](int i, int j, int kept, const double* values) {
    if (rested ? moves(i, j) && closer(0.0, i, j) : is_inside(kept, values))
      pairs.push_back({i, j});
  });
}

#define COHESION_INSTANTIATE(style, Law)                           \
  template void PairGranCohesive<Law>::begin_where_they_are(bool); \
  template void PairGranCohesive<Law>::tally_standing();           \
  template void PairGranCohesive<Law>::book_standing();            \
  template void PairGranCohesive<Law>::append_bound(std::vector<std::array<int, 2>>&) const;
COHESION_PAIR_LAWS(COHESION_INSTANTIATE)
