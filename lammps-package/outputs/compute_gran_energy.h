// SPDX-License-Identifier: GPL-2.0-only
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(gran/energy,ComputeGranEnergy);
// clang-format on
#else

#ifndef LMP_COMPUTE_GRAN_ENERGY_H
#define LMP_COMPUTE_GRAN_ENERGY_H

#include <memory>

#include "common/energy_tally_of_runs.h"
#include "energy_tally.h"

namespace LAMMPS_NS {

/// compute ID all gran/energy: the energy tally of contacts at the grid point, with the true
/// motion there. Doc: docs/lammps-package/compute_gran_energy.md
class ComputeGranEnergy : public EnergyTallyCompute {
 public:
  ComputeGranEnergy(class LAMMPS*, int, char**);

  void init() override;
  void begin_run() override;

 private:
  bool is_read() override;
  void add_to(double* entries) override;

  class FixContactStep* step;
  std::shared_ptr<const void> reader;              // keeps the tally of contacts active
  double before[cohesion::energy_tally::ENTRIES];  // what there was when this was defined
};

}  // namespace LAMMPS_NS

#endif
#endif
