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

/// Finds the particles that a script has displaced, resized or given another type between two runs.
/// The stored state of their contacts does not say whether they are in range now.
class AlteredParticles : protected Pointers {
 public:
  explicit AlteredParticles(LAMMPS* lammps) : Pointers(lammps) {}

  /// Numbers stored per particle at the end of a run: position, radius, type and ID.
  static constexpr int SAVED = 6;
  /// Numbers per particle that describe its alteration (Alteration).
  static constexpr int EACH = 4;

  void save(int i, double* values) const;
  void save_box() { box_.store(domain); }
  static tagint id_of(const double* saved) { return static_cast<tagint>(saved[SAVED - 1]); }
  void save_id(int i, double* values) const { values[SAVED - 1] = atom->tag[i]; }

  /// Allocates the alterations of all particles and ghosts, none of them altered yet.
  void start() { by_.assign(atom->nlocal + atom->nghost, {}); }
  /// Compares own particle i with the numbers of save(). Returns whether it was altered.
  bool compare(int i, const double* saved);
  /// The alteration of particle or ghost i; the owner of a ghost sends its values.
  double* of(int i) { return by_[i].data(); }
  /// Frees the alterations; from then on no particle counts as altered.
  void forget() { by_.clear(); }

  /// Whether the distance of particle i and particle or ghost j, or the law between them, may have
  /// changed other than by their motion. j < 0: a wall.
  bool is_altered(int i, int j) const;

 private:
  using Alteration = std::array<double, EACH>;  // displacement, and 1 for another radius or type

  bool is_displaced(const cohesion::Vector3& by) const;

  std::vector<Alteration> by_;  // per particle and ghost
  BoxSides box_;                // at the end of the last run
};

}  // namespace LAMMPS_NS

#endif
