// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_COMPUTE_GRAN_ENERGY_H
#define COHESION_COMPUTE_GRAN_ENERGY_H

#include "common/energy_tally_of_runs.h"
#include "energy_tally.h"
#include "liggghts_api.h"

namespace LIGGGHTS {
namespace Cohesion {

/// compute ID all gran/energy: the energy tally at the time level.
/// Doc: docs/liggghts-styles/compute_gran_energy.md
class ComputeGranularEnergy : public LAMMPS_NS::engine_api::StyleCompute,
                              public LAMMPS_NS::EnergyTallyCompute {
 public:
  ComputeGranularEnergy(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  ~ComputeGranularEnergy() override;
  void pre_delete(bool) override;

  void init() override;
  void compute_vector() override;
  double compute_scalar() override;
  void begin_run() override;
  void end_run() override;

 private:
  void work_out();

  LAMMPS_NS::TallyOfRuns tally_;
  LAMMPS_NS::SameParticles particles_;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
