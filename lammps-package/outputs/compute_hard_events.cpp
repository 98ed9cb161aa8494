// SPDX-License-Identifier: GPL-2.0-only
#include "outputs/compute_hard_events.h"

#include <algorithm>

#include "error.h"
#include "hard_spheres/fix_hard_events.h"
#include "update.h"

using namespace LAMMPS_NS;

// Quantities by kind of pairs, then two numbers of the run, then the same quantities of walls, then
// two of the rule of rest.
static constexpr int BY_KIND = HardEventTotals::quantities * HardEventTotals::kinds;
static constexpr int ELASTIC = BY_KIND;
static constexpr int MOST_EVENTS = BY_KIND + 1;
static constexpr int WALLS = BY_KIND + 2;
static constexpr int AT_REST = WALLS + BY_KIND;
static constexpr int GIVEN_AT_REST = AT_REST + 1;
static constexpr int ENTRIES = AT_REST + 2;

ComputeHardEvents::ComputeHardEvents(LAMMPS* lammps, int narg, char** arg)
    : Compute(lammps, narg, arg), events_(FixHardEvents::find_or_create(lammps)) {
  if (narg != 3) error->all(FLERR, "compute hard/events takes no further arguments");
  if (igroup != 0)
    error->all(FLERR, "compute hard/events sums over all particles; its group must be 'all'");
  vector_flag = 1;
  extvector = -1;
  size_vector = ENTRIES;
  vector = new double[ENTRIES];
  extlist = new int[ENTRIES];
  std::fill_n(extlist, ENTRIES, 1);
  extlist[MOST_EVENTS] = 0;
}

ComputeHardEvents::~ComputeHardEvents() {
  delete[] vector;
  delete[] extlist;
}

void ComputeHardEvents::init() {}

void ComputeHardEvents::compute_vector() {
  invoked_vector = update->ntimestep;
  const HardEventTotals& totals = events_->totals();
  double mine[ENTRIES] = {};
  for (int walls = 0; walls < 2; walls++)
    for (int quantity = 0; quantity < HardEventTotals::quantities; quantity++)
      for (int kind = 0; kind < HardEventTotals::kinds; kind++)
        mine[walls * WALLS + quantity * HardEventTotals::kinds + kind] =
            totals.sums[walls][quantity][kind];
  mine[ELASTIC] = totals.elastic;
  mine[AT_REST] = totals.rest_rule_collisions;
  mine[GIVEN_AT_REST] = totals.rest_rule_energy;
  MPI_Allreduce(mine, vector, ENTRIES, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(&totals.most_events, vector + MOST_EVENTS, 1, MPI_DOUBLE, MPI_MAX, world);
}
