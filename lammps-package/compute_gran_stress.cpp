// SPDX-License-Identifier: GPL-2.0-only
#include "compute_gran_stress.h"

#include "error.h"
#include "fix_event_step.h"
#include "memory.h"
#include "update.h"

using namespace LAMMPS_NS;
using cohesion::event_stepping::FluxParts;

ComputeGranStress::ComputeGranStress(LAMMPS* lammps, int narg, char** arg)
    : Compute(lammps, narg, arg), step(FixEventStep::of(lammps)) {
  if (narg != 3) error->all(FLERR, "compute gran/stress takes no further arguments");
  if (igroup != 0)
    error->all(FLERR, "compute gran/stress sums over all particles; its group must be 'all'");
  step->sum_flux();
  array_flag = 1;
  extarray = 1;
  size_array_rows = FluxParts::parts;
  size_array_cols = 6;
  memory->create(array, size_array_rows, size_array_cols, "gran/stress:array");
}

ComputeGranStress::~ComputeGranStress() { memory->destroy(array); }

void ComputeGranStress::compute_array() {
  invoked_array = update->ntimestep;
  // Both are one block of rows.
  MPI_Allreduce(step->flux.of.data(), &array[0][0], size_array_rows * size_array_cols, MPI_DOUBLE,
                MPI_SUM, world);
}
