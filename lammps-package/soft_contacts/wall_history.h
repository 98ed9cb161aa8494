// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_WALL_HISTORY_H
#define COHESION_WALL_HISTORY_H

#include "atom_numbers.h"

namespace LAMMPS_NS {

/// What each particle remembers of each of some walls: `per_wall` numbers, the first of which is
/// its in-range flag.
class WallHistory : public AtomNumbers {
 public:
  /// Flag of a particle that has not met the wall yet.
  static constexpr double NOT_KNOWN = -1.0;

  explicit WallHistory(LAMMPS* lammps) : AtomNumbers(lammps) {}

  void start(int walls, int per_wall) {
    walls_ = walls;
    per_wall_ = per_wall;
    resize(walls * per_wall);
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

}  // namespace LAMMPS_NS

#endif
