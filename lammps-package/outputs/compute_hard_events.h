// SPDX-License-Identifier: GPL-2.0-only
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(hard/events,ComputeHardEvents);
// clang-format on
#else

#ifndef LMP_COMPUTE_HARD_EVENTS_H
#define LMP_COMPUTE_HARD_EVENTS_H

#include "compute.h"

namespace LAMMPS_NS {

/// compute ID all hard/events: sums over the events of pair_style hard/squarewell and its walls,
/// by kind. Doc: docs/lammps-package/compute_gran_stress.md
class ComputeHardEvents : public Compute {
 public:
  ComputeHardEvents(class LAMMPS*, int, char**);
  ~ComputeHardEvents() override;

  void init() override;
  void compute_vector() override;

 private:
  class FixHardEvents* events_;
};

}  // namespace LAMMPS_NS

#endif
#endif
