// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_PARTICLES_AT_WALLS_H
#define COHESION_PARTICLES_AT_WALLS_H

#include <functional>
#include <string>
#include <vector>

#include "contact_solver/wall.h"
#include "engine/region_faces.h"
#include "lammps.h"

namespace LAMMPS_NS {

/// A wall as a script writes it, with its position as far as it has moved; other_side: of a plane
/// with the same position.
std::string name_of_wall(const cohesion::contact_solver::Wall&,
                         const cohesion::contact_solver::WallState& now, bool other_side = false);

/// The walls of a fix as a run begins.
struct WallsAtStart {
  const std::vector<cohesion::contact_solver::Wall>& walls;
  cohesion::contact_solver::WallState state;
  int groupbit;
  /// Overlap over diameter above which a particle does not rest on a wall but was put into it.
  double deep;
  /// What becomes of such a particle.
  const char* effect;
  /// Further walls, which count behind the others; may be null.
  const std::vector<RegionFaces>* regions = nullptr;

  int count() const { return static_cast<int>(walls.size() + (regions ? regions->size() : 0)); }
  bool is_region(int w) const { return w >= static_cast<int>(walls.size()); }
  const RegionFaces& region(int w) const { return (*regions)[w - walls.size()]; }
  std::string name(int w) const;
  /// What to change in a script to exchange the front and the back of wall w; empty if that is
  /// impossible.
  std::string words_of_other_side(int w) const;
  /// Distance of a centre from wall w, not positive behind it, [length].
  double distance(int w, const cohesion::Vector3& centre) const;
};

/// Collective: warns of particles that stand behind a wall of a fix, or reach deep into it, as a
/// run begins: of all of them once, with one that shows which they are. Those of which is_new(i,
/// wall) is not true, and those that nothing moves, do not count. `where` stands in front of the
/// message. Returns whether there are any.
bool warn_of_particles_at_walls(LAMMPS*, const std::string& where, const WallsAtStart&,
                                const std::function<bool(int i, int wall)>& is_new);

}  // namespace LAMMPS_NS

#endif
