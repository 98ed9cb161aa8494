// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_ALTERED_PARTICLES_H
#define COHESION_ALTERED_PARTICLES_H

#include <array>
#include <vector>

#include "atom.h"
#include "common/box_sides.h"
#include "pointers.h"
#include "vector3.h"

namespace LAMMPS_NS {

/// The particles that a script has displaced, or given another size or type, between two runs: what
/// is remembered of their contacts does not tell whether they are in range now.
class AlteredParticles : protected Pointers {
 public:
  explicit AlteredParticles(LAMMPS* lammps) : Pointers(lammps) {}

  /// Numbers that the last run leaves of a particle: position, radius, type and ID.
  static constexpr int SAVED = 6;
  /// Numbers that say what a particle was altered by.
  static constexpr int EACH = 4;

  void save(int i, double* values) const;
  void save_box() { box_.store(domain); }
  static tagint id_of(const double* saved) { return static_cast<tagint>(saved[SAVED - 1]); }
  void save_id(int i, double* values) const { values[SAVED - 1] = atom->tag[i]; }

  /// Room for particles and ghosts of which none is altered.
  void start() { by_.assign(atom->nlocal + atom->nghost, {}); }
  /// Compares own particle i with what save() left of it; gives whether it is altered.
  bool compare(int i, const double* saved);
  /// By what particle or ghost i was altered: those of ghosts come from their owners.
  double* of(int i) { return by_[i].data(); }
  /// Without room no particle is altered.
  void forget() { by_.clear(); }

  /// Whether anything but the motion of particle i and of particle or ghost j may have changed how
  /// near they are, or what acts between them; j < 0: a wall.
  bool is_altered(int i, int j) const;

 private:
  using Alteration = std::array<double, EACH>;  // displacement, and 1 for another radius or type

  bool is_displaced(const cohesion::Vector3& by) const;

  std::vector<Alteration> by_;  // per particle and ghost
  BoxSides box_;                // at the end of the last run
};

}  // namespace LAMMPS_NS

#endif
