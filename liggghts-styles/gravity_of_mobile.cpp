// SPDX-License-Identifier: GPL-2.0-or-later
#include "gravity_of_fixes.h"
#include "integrated_particles.h"
#include "liggghts_api.h"

std::vector<std::pair<int, cohesion::Vector3>> LAMMPS_NS::engine_api::gravity_of_mobile(
    LAMMPS* lmp, int groupbit) {
  const LIGGGHTS::Cohesion::GravityOfFixes gravity(lmp->modify);
  const LIGGGHTS::Cohesion::IntegratedParticles mobile(lmp);
  std::vector<std::pair<int, cohesion::Vector3>> found;
  for (int i = 0; i < lmp->atom->nlocal; i++) {
    const int mask = lmp->atom->mask[i];
    if ((mask & groupbit) && mobile.moves(mask)) found.emplace_back(i, gravity.on(mask));
  }
  return found;
}
