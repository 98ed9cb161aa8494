// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_COMPUTE_GRAN_ENERGY_H
#define COHESION_COMPUTE_GRAN_ENERGY_H

#include "common/energy_tally_of_runs.h"

namespace LIGGGHTS {
namespace Cohesion {

/// compute ID all gran/energy: the energy tally at the time level.
/// Doc: docs/liggghts-styles/compute_gran_energy.md
class ComputeGranularEnergy : public LAMMPS_NS::EnergyTallyCompute {
 public:
  ComputeGranularEnergy(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  void pre_delete(bool) override;

 private:
  bool is_read() override;
  void add_to(double* entries) override;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
