// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_INTEGRATED_PARTICLES_H
#define COHESION_INTEGRATED_PARTICLES_H

#include <cstring>

#include "common/held_spheres.h"
#include "common/unturned_spheres.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Which particles a force can move: those that a fix integrates, unless fix freeze holds them, fix
/// setforce, lineforce or planeforce sets their whole force, or fix move or nve/noforce leads them.
class IntegratedParticles {
 public:
  explicit IntegratedParticles(const LAMMPS_NS::LAMMPS* lmp) : held_(lmp), any_held_(held_.any()) {
    const LAMMPS_NS::Modify* const modify = lmp->modify;
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

  bool moves(int mask) const {
    return (mask & mobile_) && !(mask & frozen_) && !(any_held_ && held_.hold(mask));
  }
  /// Whether a particle moves and turns.
  bool is_free(int mask) const { return moves(mask) && (mask & turned_); }
  /// Whether all particles do, whatever their groups: bit 1 is that of group all.
  bool all_are_free() const { return is_free(1) && frozen_ == 0 && !any_held_; }
  /// Whether a particle moves and nothing turns it.
  bool is_not_turned(int mask) const { return moves(mask) && !(mask & turned_); }

  /// Those that forces which fixes set hold, or lead.
  const LAMMPS_NS::HeldGroups& held() const { return held_; }
  /// Bits of the groups that fixes turn.
  int turned_groups() const { return turned_; }
  /// Whether a fix would turn a particle that is held in its place.
  bool is_held_but_turned(int mask) const { return (mask & turned_) && held_.hold(mask); }

 private:
  LAMMPS_NS::HeldGroups held_;
  bool any_held_;
  int mobile_ = 0;
  int frozen_ = 0;
  int turned_ = 0;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
