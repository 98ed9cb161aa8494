// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_WALL_HISTORY_H
#define COHESION_WALL_HISTORY_H

#include <algorithm>

#include "atom.h"
#include "contact_solver/wall.h"
#include "engine/atom_numbers.h"
#include "fix.h"

namespace LAMMPS_NS {

/// The contact histories of each particle with each wall of a fix: `per_wall` numbers, the first of
/// which is the in-range flag or one of the flags below.
class WallHistory : public AtomNumbers {
 public:
  /// Flag of a particle that has not met the wall yet.
  static constexpr double NOT_KNOWN = -1.0;
  /// Flag of a particle on which the wall does not act (contact_solver/wall.h: is_behind()).
  static constexpr double BEHIND = -2.0;

  explicit WallHistory(LAMMPS* lammps) : AtomNumbers(lammps) {}

  void start(int walls, int per_wall) {
    walls_ = walls;
    per_wall_ = per_wall;
    resize(walls * per_wall);
  }
  /// Whether the particle has no history with this wall, or is out of range.
  bool is_new(int i, int wall) const { return *of(i, wall) == NOT_KNOWN || *of(i, wall) == 0.0; }
  /// Whether the wall does not act on a particle; sets its flag. distance, clear: as in
  /// is_behind().
  static bool keep_behind(double& flag, double distance, double clear) {
    if (flag > 0.0 || !cohesion::contact_solver::is_behind(flag == BEHIND, distance, clear))
      return false;
    flag = BEHIND;
    return true;
  }
  /// The contact with one wall continues with another one.
  void hand_over(int i, int from, int to) const {
    std::copy_n(of(i, from), per_wall_, of(i, to));
    std::fill_n(of(i, from), per_wall_, 0.0);
  }
  double* of(int i, int wall) const { return AtomNumbers::of(i) + wall * per_wall_; }

  void begin(int i) const {
    clear(i);
    for (int wall = 0; wall < walls_; wall++) *of(i, wall) = NOT_KNOWN;
  }

 private:
  int walls_ = 0;
  int per_wall_ = 0;
};

/// A fix that stores a WallHistory: the engine's callbacks for its data per particle.
class FixWithWallHistory : public Fix {
 public:
  void grow_arrays(int nmax) override { history.grow(nmax); }
  void copy_arrays(int i, int j, int) override { history.copy(i, j); }
  void set_arrays(int i) override { history.begin(i); }
  int pack_exchange(int i, double* buf) override { return history.pack(i, buf); }
  int unpack_exchange(int i, double* buf) override { return history.unpack(i, buf); }
  int pack_restart(int i, double* buf) override { return history.pack_restart(i, buf); }
  void unpack_restart(int i, int nth) override { history.unpack_restart(i, atom->extra[i], nth); }
  int maxsize_restart() override { return history.size_restart(); }
  int size_restart(int) override { return history.size_restart(); }
  double memory_usage() override { return history.bytes(); }

 protected:
  FixWithWallHistory(LAMMPS* lammps, int narg, char** arg)
      : Fix(lammps, narg, arg), history(lammps) {}

  WallHistory history;
};

}  // namespace LAMMPS_NS

#endif
