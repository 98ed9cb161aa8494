// SPDX-License-Identifier: GPL-2.0-only
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(gran/energy,ComputeGranEnergy);
// clang-format on
#else

#ifndef LMP_COMPUTE_GRAN_ENERGY_H
#define LMP_COMPUTE_GRAN_ENERGY_H

#include <memory>

#include "compute.h"
#include "energy_book.h"
#include "energy_companions.h"

namespace LAMMPS_NS {

/// compute ID all gran/energy: the energy book of the event scheme at the end of the step's motion,
/// half a step after the grid point. Doc: docs/lammps-package/compute_gran_energy.md
class ComputeGranEnergy : public Compute {
 public:
  ComputeGranEnergy(class LAMMPS*, int, char**);
  ~ComputeGranEnergy() override;

  void init() override;
  void compute_vector() override;
  double compute_scalar() override;

 private:
  void add_sums(double* entries, double factor) const;

  class FixEventStep* step;
  std::shared_ptr<const void> reader;             // while there is one the book is kept
  double before[cohesion::energy_book::ENTRIES];  // what the book had summed when this was defined
  cohesion::energy_book::Opened opened;
  SameParticles particles;
};

}  // namespace LAMMPS_NS

#endif
#endif
