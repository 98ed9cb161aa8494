// SPDX-License-Identifier: GPL-2.0-only
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(hard/stress,ComputeHardStress);
// clang-format on
#else

#ifndef LMP_COMPUTE_HARD_STRESS_H
#define LMP_COMPUTE_HARD_STRESS_H

#include "outputs/compute_flux_totals.h"

namespace LAMMPS_NS {

/// compute ID all hard/stress: momentum times distance that the events of pair_style
/// hard/squarewell have carried, by kind. Doc: docs/lammps-package/compute_gran_stress.md
class ComputeHardStress : public ComputeFluxTotals {
 public:
  ComputeHardStress(class LAMMPS*, int, char**);

 protected:
  const cohesion::MomentumFlux* totals() override;

 private:
  class FixHardEvents* events_;
};

}  // namespace LAMMPS_NS

#endif
#endif
