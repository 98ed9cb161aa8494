// SPDX-License-Identifier: GPL-2.0-only
#include "contact_step/close_pairs.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "common/box_shear.h"
#include "domain.h"
#include "fix_neigh_history.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "prefetch.h"

using namespace LAMMPS_NS;

void ClosePairs::start(double allowed) {
  allowed_ = allowed;
  positions_.clear();
}

void ClosePairs::update(const NeighList& list, double reach, double travelled, long radii,
                        const FixNeighHistory& known, int each) {
  const bool new_list = neighbor->ago == 0;
  travelled_ += travelled;
  if (new_list || positions_.empty() || may_have_come(reach, radii == radii_version_)) {
    each_ = each;
    find(list, known, new_list);
    radii_version_ = radii;
  } else if (++since_counted_ == STEPS_OF_A_COUNT) {
    count_remembered();
  }
  reach_ = reach;
}

void ClosePairs::count_remembered() {
  const auto remembered = std::count_if(pairs_.begin(), pairs_.begin() + count_,
                                        [](const ClosePair& p) { return *p.has_history != 0; });
  most_remembered_ = 2 * static_cast<std::size_t>(remembered) > count_;
  since_counted_ = 0;
}

inline bool ClosePairs::is_near(const ClosePair& p, const double* x, const double* radius) const {
  const double dx = x[3 * p.j] - x[3 * p.i], dy = x[3 * p.j + 1] - x[3 * p.i + 1],
               dz = x[3 * p.j + 2] - x[3 * p.i + 2];
  const double reach = radius[p.i] + radius[p.j] + reach_;
  return dx * dx + dy * dy + dz * dz <= 1.0002 * reach * reach;
}

/// Selects the near pairs of a block of close pairs into `near`, and returns their end.
const ClosePair** ClosePairs::find_near(const ClosePair* first, const ClosePair* stop,
                                        const ClosePair** near) const {
  const double* const x = atom->x[0];
  const double* const radius = atom->radius;
  const ClosePair** last = near;
  const double* const v = atom->v[0];
  const double* const spin = atom->omega[0];
  if (most_remembered_) {  // as in packings, whose histories are contiguous in memory
    for (const ClosePair* p = first; p != stop; p++) {
      const std::ptrdiff_t own = 3 * std::ptrdiff_t{p->j};
      cohesion::prefetch_line(x + own);
      cohesion::prefetch_line(v + own);
      cohesion::prefetch_line(spin + own);
      if (*p->has_history || is_near(*p, x, radius)) *last++ = p;
    }
    return last;
  }
  for (const ClosePair* p = first; p != stop; p++) {
    *last = p;  // without a branch, since the processor could not predict it
    last += (*p->has_history != 0) | is_near(*p, x, radius);
  }
  for (const ClosePair** p = near; p != last; p++) {
    cohesion::prefetch_numbers((*p)->history, each_);
    cohesion::prefetch_numbers(v + 3 * (*p)->j, 3);
    cohesion::prefetch_numbers(spin + 3 * (*p)->j, 3);
  }
  return last;
}

/// Whether a pair outside the close pairs may have a gap below `reach`. Where neither radii nor the
/// box have changed, the displacement of the fastest particle decides this in most steps.
bool ClosePairs::may_have_come(double reach, bool radii_as_found) const {
  if (radii_as_found && !domain->box_change && reach + 2.0 * travelled_ <= allowed_) return false;
  return reach + come_closer() > allowed_;
}

/// Upper bound of the decrease of a pair's gap since the last search, [length].
double ClosePairs::come_closer() const {
  const double* const now = atom->x[0];
  const double* const then = positions_.data();
  const double* const radius = atom->radius;
  double furthest = 0.0, growth = 0.0;
  for (std::size_t k = 0; k < positions_.size(); k += 3) {
    const double dx = now[k] - then[k], dy = now[k + 1] - then[k + 1],
                 dz = now[k + 2] - then[k + 2];
    furthest = std::max(furthest, dx * dx + dy * dy + dz * dz);
  }
  for (std::size_t i = 0; i < radii_.size(); i++) growth = std::max(growth, radius[i] - radii_[i]);
  return 2.0 * (std::sqrt(furthest) + growth);
}

/// Finds the pairs with a gap below `allowed`.
void ClosePairs::find(const NeighList& list, const FixNeighHistory& known, bool new_list) {
  count_ = 0;
  travelled_ = 0.0;
  positions_.clear();
  if (atom->nlocal + atom->nghost == 0) return;
  const int movers = number_of_movers(lmp);
  positions_.assign(atom->x[0], atom->x[0] + 3 * movers);
  radii_.assign(atom->radius, atom->radius + movers);
  const double* const x = atom->x[0];
  const double* const radius = atom->radius;
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    const int* const neighbors = list.firstneigh[i];
    const int count = list.numneigh[i];
    const double xi = x[3 * i], yi = x[3 * i + 1], zi = x[3 * i + 2];
    // The factor leaves room for the impulses of other contacts within a step.
    const double near_i = 1.0001 * radius[i] + allowed_;
    if (pairs_.size() < count_ + count) pairs_.resize(2 * count_ + count);
    ClosePair* const first = pairs_.data() + count_;
    ClosePair* last = first;
    for (int jj = 0; jj < count; jj++) {
      const int j = neighbors[jj] & NEIGHMASK;
      const double dx = x[3 * j] - xi;
      const double dy = x[3 * j + 1] - yi;
      const double dz = x[3 * j + 2] - zi;
      const double near = near_i + radius[j];
      // Without a branch, since the processor could not predict it.
      *last = {i, j, known.firstflag[i] + jj, known.firstvalue[i] + each_ * jj};
      last += dx * dx + dy * dy + dz * dz <= near * near;
    }
    count_ = last - pairs_.data();
    if (new_list) forget_others(known.firstflag[i], count, first, last);
  }
  count_remembered();
}

/// Clears the histories of pairs that are no longer close. Only particles that a script has
/// displaced can have one.
void ClosePairs::forget_others(int* has_history, int count, const ClosePair* near,
                               const ClosePair* end) {
  for (int jj = 0; jj < count; jj++) {
    if (near != end && near->has_history == has_history + jj)
      near++;
    else
      has_history[jj] = 0;
  }
}
