// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_BOX_SHEAR_H
#define COHESION_BOX_SHEAR_H

#include "atom.h"
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

inline bool in_box(Domain* domain, double* x) {
  double place[3];
  if (domain->triclinic) domain->x2lamda(x, place);
  const double* const at = domain->triclinic ? place : x;
  const double* const low = domain->triclinic ? domain->boxlo_lamda : domain->boxlo;
  const double* const high = domain->triclinic ? domain->boxhi_lamda : domain->boxhi;
  for (int k = 0; k < 3; k++)
    if (domain->periodicity[k] && (at[k] < low[k] || at[k] >= high[k])) return false;
  return true;
}

/// Own particles outside the box go back into it with the velocity of the image that they become,
/// as when the engine makes lists: for restart files the engine puts them back with the velocity
/// that they have. All others stay as they are, to the last digit.
inline void put_into_box(Atom* atom, Domain* domain) {
  const auto height = [](imageint image) { return (image >> IMGBITS & IMGMASK) - IMGMAX; };
  for (int i = 0; i < atom->nlocal; i++) {
    if (in_box(domain, atom->x[i])) continue;
    const auto before = height(atom->image[i]);
    domain->remap(atom->x[i], atom->image[i]);
    if (domain->deform_vremap && (atom->mask[i] & domain->deform_groupbit))
      atom->v[i][0] -= static_cast<double>(height(atom->image[i]) - before) * domain->h_rate[5];
  }
}

}  // namespace LAMMPS_NS

#endif
