// SPDX-License-Identifier: GPL-2.0-only
#include "compute_hard_stress.h"

#include "error.h"
#include "fix_hard_events.h"
#include "memory.h"
#include "update.h"

using namespace LAMMPS_NS;

ComputeHardStress::ComputeHardStress(LAMMPS* lammps, int narg, char** arg)
    : Compute(lammps, narg, arg), events_(FixHardEvents::of(lammps)) {
  if (narg != 3) error->all(FLERR, "compute hard/stress takes no further arguments");
  if (igroup != 0)
    error->all(FLERR, "compute hard/stress sums over all particles; its group must be 'all'");
  events_->sum_flux();
  array_flag = 1;
  extarray = 1;
  size_array_rows = HardEventTotals::kinds;
  size_array_cols = 6;
  memory->create(array, size_array_rows, size_array_cols, "hard/stress:array");
}

ComputeHardStress::~ComputeHardStress() { memory->destroy(array); }

void ComputeHardStress::compute_array() {
  invoked_array = update->ntimestep;
  // Both are one block of rows.
  MPI_Allreduce(events_->totals().flux.data(), &array[0][0], size_array_rows * size_array_cols,
                MPI_DOUBLE, MPI_SUM, world);
}
