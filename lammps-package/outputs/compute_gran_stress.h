// SPDX-License-Identifier: GPL-2.0-only
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(gran/stress,ComputeGranStress);
// clang-format on
#else

#ifndef LMP_COMPUTE_GRAN_STRESS_H
#define LMP_COMPUTE_GRAN_STRESS_H

#include <memory>

#include "contact_solver/flux_parts.h"
#include "outputs/compute_flux_totals.h"

namespace LAMMPS_NS {

/// compute ID all gran/stress: momentum times distance that contact and adhesion of the soft
/// cohesive pair styles have carried. Doc: docs/lammps-package/compute_gran_stress.md
class ComputeGranStress : public ComputeFluxTotals {
 public:
  ComputeGranStress(class LAMMPS*, int, char**);

  void init() override;

 protected:
  const cohesion::MomentumFlux* totals() override;

 private:
  class FixContactStep* step;
  std::shared_ptr<const void> reader;                 // while there is one the flux is summed
  cohesion::contact_solver::FluxParts before, since;  // this was defined
};

}  // namespace LAMMPS_NS

#endif
#endif
