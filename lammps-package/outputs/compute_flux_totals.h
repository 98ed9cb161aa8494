// SPDX-License-Identifier: GPL-2.0-only
#ifndef LMP_COMPUTE_FLUX_TOTALS_H
#define LMP_COMPUTE_FLUX_TOTALS_H

#include "compute.h"
#include "momentum_flux.h"

namespace LAMMPS_NS {

/// What compute hard/stress and compute gran/stress are: a global array of momentum times distance
/// carried so far, a row for each kind, summed over the processes.
class ComputeFluxTotals : public Compute {
 public:
  ComputeFluxTotals(class LAMMPS*, int, char**, int kinds);
  ~ComputeFluxTotals() override;

  void init() override {}
  void compute_array() override;

 protected:
  /// Of this process: as many as there are kinds.
  virtual const cohesion::MomentumFlux* totals() = 0;
};

}  // namespace LAMMPS_NS

#endif
