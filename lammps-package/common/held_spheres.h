// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_HELD_SPHERES_H
#define COHESION_HELD_SPHERES_H

#include <string>
#include <vector>

namespace LAMMPS_NS {

// Spheres of which fix setforce, lineforce or planeforce decides how they move, in both engines.

/// The groups of particles that no contact moves, since such fixes set their whole force.
class HeldGroups {
 public:
  HeldGroups() = default;
  explicit HeldGroups(const class LAMMPS*);

  /// By the mask of a particle.
  bool hold(int mask) const {
    if (mask & single_) return true;
    for (const int bits : together_)
      if ((mask & bits) == bits) return true;
    return false;
  }
  bool any() const { return single_ != 0 || !together_.empty(); }
  /// Bits of the groups each of which one fix holds by itself.
  int held_by_one_fix() const { return single_; }

 private:
  int single_ = 0;
  std::vector<int> together_;  // bits of groups whose common members are held
};

/// Collective. A contact moves a sphere in all directions or in none. Where a fix holds spheres
/// along some directions only, and a contact of theirs may point along these, the run stops if
/// contacts of it are integrated exactly (`exact`); else it warns. All is well where particles lie
/// in one layer, or on one line, and move in it. `where` stands in front of messages. Returns
/// whether it warned.
bool require_whole_holds(class LAMMPS*, const std::string& where, bool exact);

/// Collective. Warns of spheres with friction that are held in their places and that a fix would
/// turn: those of HeldGroups do not turn. `turned`: bits of the groups that fixes turn;
/// has_friction: by type. Returns whether there are any.
bool warn_of_held_turned(const class LAMMPS*, const HeldGroups&, int turned,
                         const std::vector<bool>& has_friction);

}  // namespace LAMMPS_NS

#endif
