// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_INTEGRATED_PARTICLES_H
#define COHESION_INTEGRATED_PARTICLES_H

#include <cstring>

#include "fix.h"
#include "modify.h"
#include "unturned_spheres.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Which particles a force can move: those that a fix integrates, unless fix freeze holds them or
/// fix move or nve/noforce leads them.
class MobileParticles {
 public:
  explicit MobileParticles(const LAMMPS_NS::Modify* modify) {
    for (int k = 0; k < modify->nfix; k++) {
      const LAMMPS_NS::Fix* const fix = modify->fix[k];
      if (std::strcmp(fix->style, "freeze") == 0) frozen_ |= fix->groupbit;
      const bool leads =
          std::strcmp(fix->style, "move") == 0 || std::strcmp(fix->style, "nve/noforce") == 0;
      if (fix->time_integrate && !leads) mobile_ |= fix->groupbit;
      if (fix->time_integrate && !LAMMPS_NS::only_translates(fix)) turned_ |= fix->groupbit;
    }
  }

  /// Moment of inertia over mass and square of the radius: as fix nve/sphere turns the particle.
  static double inertia_factor(int dimension) { return dimension == 2 ? 0.5 : 0.4; }

  bool moves(int mask) const { return (mask & mobile_) && !(mask & frozen_); }
  /// Whether a particle moves and nothing turns it.
  bool is_not_turned(int mask) const { return moves(mask) && !(mask & turned_); }

 private:
  int mobile_ = 0;
  int frozen_ = 0;
  int turned_ = 0;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
