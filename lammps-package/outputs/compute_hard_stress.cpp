// SPDX-License-Identifier: GPL-2.0-only
#include "outputs/compute_hard_stress.h"

#include "hard_spheres/fix_hard_events.h"

using namespace LAMMPS_NS;

ComputeHardStress::ComputeHardStress(LAMMPS* lammps, int narg, char** arg)
    : ComputeFluxTotals(lammps, narg, arg, HardEventTotals::kinds),
      events_(FixHardEvents::find_or_create(lammps)) {
  events_->enable_flux();
}

const cohesion::MomentumFlux* ComputeHardStress::totals() { return events_->totals().flux.data(); }
