// SPDX-License-Identifier: GPL-2.0-only
// The part of PairGranCohesive that looks at pairs where they stand, between two steps.
#include <algorithm>

#include "atom.h"
#include "fix_event_step.h"
#include "hamaker_cohesion.h"
#include "neigh_list.h"
#include "pair_gran_cohesive.h"
#include "square_well_cohesion.h"

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

static bool is_inside(int kept, const double* values) {
  return kept && ContactMemory::from(values, HistorySize::normal_only).in_range();
}

/// What a pair that is `near`, or not, remembers from now on. What its last step owes the grid
/// stays.
static ContactMemory moved(ContactMemory known, bool near) {
  using Phase = ContactMemory::Phase;
  const bool owes = known.phase == Phase::inside || known.phase == Phase::left;
  if (!owes) return near ? ContactMemory::seen_inside() : ContactMemory();
  known.phase = near ? Phase::inside : Phase::left;
  return known;
}

/// After steps in which no pair was followed (`afresh`), or where something else than their motion
/// brought particles where they are or laws have other ranges; those that are still in range
/// remember what they did.
template <class Cohesion>
void PairGranCohesive<Cohesion>::begin_where_they_are(bool afresh) {
  rested = false;
  std::visit(
      [this, afresh](auto& contacts) {
        contacts.clear();
        for_each_listed([&](int i, int j, int& kept, double* values) {
          // Contacts are made for those only that some contact could reach.
          const bool near =
              moves(i, j) && closer(largest_range, i, j) &&
              closer(contacts.all[contact(contacts, particles(), i, j)].range(), i, j);
          if (near && is_inside(kept, values) && !afresh) return;
          const bool remembered = kept && !afresh;
          const ContactMemory known =
              moved(remembered ? ContactMemory::from(values, per_pair) : ContactMemory(), near);
          known.to(values, per_pair);
          kept = near || known.phase == ContactMemory::left;
        });
      },
      any_contacts);
}

/// Energies of the pairs where they stand, for a run that takes over the forces of the last one.
template <class Cohesion>
void PairGranCohesive<Cohesion>::book_standing() {
  if (!acts) return;
  if (rested) begin_where_they_are(true);
  if (step->box_changed() || coefficients.has_other_ranges()) begin_where_they_are(false);
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

/// Bound are the pairs within the range of contact and adhesion, of those that are followed or,
/// where nothing acts, would be.
template <class Cohesion>
void PairGranCohesive<Cohesion>::append_bound(std::vector<std::array<int, 2>>& pairs) const {
  for_each_listed([&](int i, int j, int kept, const double* values) {
    if (rested ? moves(i, j) && closer(0.0, i, j) : is_inside(kept, values))
      pairs.push_back({i, j});
  });
}

template void PairGranCohesive<HamakerCohesion>::begin_where_they_are(bool);
template void PairGranCohesive<HamakerCohesion>::tally_standing();
template void PairGranCohesive<HamakerCohesion>::book_standing();
template void PairGranCohesive<HamakerCohesion>::append_bound(
    std::vector<std::array<int, 2>>&) const;
template void PairGranCohesive<SquareWellCohesion>::begin_where_they_are(bool);
template void PairGranCohesive<SquareWellCohesion>::tally_standing();
template void PairGranCohesive<SquareWellCohesion>::book_standing();
template void PairGranCohesive<SquareWellCohesion>::append_bound(
    std::vector<std::array<int, 2>>&) const;
template void PairGranCohesive<SquareWellOverlay>::begin_where_they_are(bool);
template void PairGranCohesive<SquareWellOverlay>::tally_standing();
template void PairGranCohesive<SquareWellOverlay>::book_standing();
template void PairGranCohesive<SquareWellOverlay>::append_bound(
    std::vector<std::array<int, 2>>&) const;
