// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_BOX_SHEAR_H
#define COHESION_BOX_SHEAR_H

#include "domain.h"
#include "shear/since_list.h"

// The shear of the engine's box, where particles that leave it through a sheared face change their
// velocity; without that the box may be deformed, but its images do not shear.

namespace LAMMPS_NS {

inline double middle_height(const Domain* domain) {
  return 0.5 * (domain->boxlo[1] + domain->boxhi[1]);
}

/// As a rate, [1/time].
inline cohesion::shear::BoxShear rate_of_shear(const Domain* domain) {
  return {domain->deform_vremap ? domain->h_rate[5] / domain->yprd : 0.0, middle_height(domain)};
}

/// Since a list of neighbours was made, a time `ago` before now.
inline cohesion::shear::BoxShear shear_since(const cohesion::shear::SinceList& list,
                                             const Domain* domain, double ago = 0.0) {
  if (!domain->deform_vremap) return {0.0, middle_height(domain)};
  return list.sheared(domain->xy - ago * domain->h_rate[5], domain->yprd, middle_height(domain));
}

}  // namespace LAMMPS_NS

#endif
