// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_LAW_FROM_SCRIPT_H
#define COHESION_LAW_FROM_SCRIPT_H

#include <cmath>
#include <string>

#include "common/message.h"
#include "common/plausible_sizes.h"
#include "error.h"
#include "hamaker/forms.h"
#include "hamaker/range_of_validity.h"
#include "lammps.h"
#include "named_table.h"
#include "sphere.h"

namespace LAMMPS_NS {

/// What `make` gives; a parameter that cannot be right stops LAMMPS with `where` (style and types)
/// in front of the core's own message.
template <class Make>
auto from_script(LAMMPS* lmp, const std::string& where, Make make) {
  try {
    return make();
  } catch (const cohesion::InvalidParameter& bad) {
    lmp->error->all(FLERR, where + ": " + bad.what());
    throw;
  }
}

/// The row of the form called `name`.
inline const cohesion::hamaker::Form* hamaker_form_from_script(LAMMPS* lmp,
                                                               const std::string& where,
                                                               const std::string& name) {
  return from_script(
      lmp, where, [&] { return &cohesion::find_by_name(cohesion::hamaker::forms, "form", name); });
}

/// Stops LAMMPS at cut-offs that are not far below the radii, and at asperities too flat for them;
/// nothing is asked where there are no particles yet. radius_j infinite: a wall.
inline void require_far_below_radius(LAMMPS* lmp, const std::string& where,
                                     const cohesion::hamaker::Form& form,
                                     const cohesion::hamaker::HamakerParameters& p, double radius_i,
                                     double radius_j) {
  if (radius_i == 0.0 || radius_j == 0.0) return;
  const auto geometry = std::isfinite(radius_j) ? cohesion::two_spheres(radius_i, radius_j)
                                                : cohesion::sphere_and_plane(radius_i);
  try {
    cohesion::hamaker::require_far_below_radius(form, p, geometry);
    cohesion::hamaker::require_weakened_by_asperities(form, p, geometry);
  } catch (const cohesion::InvalidParameter& bad) {
    stop(lmp, FLERR, where, ": ", bad.what(), units_of_lengths(lmp));
  }
}

}  // namespace LAMMPS_NS

#endif
