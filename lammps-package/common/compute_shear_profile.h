// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(shear/profile,ComputeShearProfile);
// clang-format on
#else

#ifndef LMP_COMPUTE_SHEAR_PROFILE_H
#define LMP_COMPUTE_SHEAR_PROFILE_H

#include "common/engine_api.h"
#include "shear/mean_profile.h"
#include "shear/slip.h"

namespace LAMMPS_NS {

/// compute ID group shear/profile: mean profile of a sheared box, granular temperature, slip and
/// kinetic stress about it. Doc: docs/lammps-package/fix_deform_shear.md
class ComputeShearProfile : public engine_api::StyleCompute {
 public:
  ComputeShearProfile(class LAMMPS*, int, char**);
  ~ComputeShearProfile() override;

  void init() override {}
  double compute_scalar() override;
  void compute_vector() override;
  void compute_array() override;

 private:
  void measure();

  int layer_number;
  bigint measured_step;
  cohesion::shear::MeanProfile profile;  // relative to the nominal one
  cohesion::shear::Layers layers;
};

}  // namespace LAMMPS_NS

#endif
#endif
