// SPDX-License-Identifier: GPL-2.0-only
#include "outputs/compute_flux_totals.h"

#include "error.h"
#include "memory.h"
#include "update.h"

using namespace LAMMPS_NS;

ComputeFluxTotals::ComputeFluxTotals(LAMMPS* lammps, int narg, char** arg, int kinds)
    : Compute(lammps, narg, arg) {
  if (narg != 3) error->all(FLERR, "compute {} takes no further arguments", style);
  if (igroup != 0)
    error->all(FLERR, "compute {} sums over all particles; its group must be 'all'", style);
  array_flag = 1;
  extarray = 1;
  size_array_rows = kinds;
  size_array_cols = 6;
  memory->create(array, size_array_rows, size_array_cols, "flux_totals:array");
}

ComputeFluxTotals::~ComputeFluxTotals() { memory->destroy(array); }

void ComputeFluxTotals::compute_array() {
  invoked_array = update->ntimestep;
  // Both are one block of rows.
  MPI_Allreduce(totals()->data(), &array[0][0], size_array_rows * size_array_cols, MPI_DOUBLE,
                MPI_SUM, world);
}
