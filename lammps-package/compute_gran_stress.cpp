// SPDX-License-Identifier: GPL-2.0-only
#include "compute_gran_stress.h"

#include "fix_event_step.h"

using namespace LAMMPS_NS;

ComputeGranStress::ComputeGranStress(LAMMPS* lammps, int narg, char** arg)
    : ComputeFluxTotals(lammps, narg, arg, cohesion::event_stepping::FluxParts::parts),
      step(FixEventStep::of(lammps)) {
  step->sum_flux();
}

const cohesion::MomentumFlux* ComputeGranStress::totals() const { return step->flux.of.data(); }
