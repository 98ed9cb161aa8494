// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_WALL_HISTORY_H
#define COHESION_WALL_HISTORY_H

#include <algorithm>

#include "memory.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// What each particle remembers of each of some walls: `per_wall` numbers, the first of which is
/// its in-range flag.
class WallHistory : protected Pointers {
 public:
  /// Flag of a particle that has not met the wall yet.
  static constexpr double NOT_KNOWN = -1.0;

  explicit WallHistory(LAMMPS* lammps) : Pointers(lammps) {}
  ~WallHistory() override { memory->destroy(values_); }
  WallHistory(const WallHistory&) = delete;
  WallHistory& operator=(const WallHistory&) = delete;

  void start(int walls, int per_wall) {
    walls_ = walls;
    per_wall_ = per_wall;
  }
  /// Numbers of a particle.
  int size() const { return per_wall_ * walls_; }
  double* of(int i, int wall) { return values_[i] + wall * per_wall_; }

  void grow(int nmax) { memory->grow(values_, nmax, size(), "wall/gran:history"); }
  void copy(int from, int to) { std::copy_n(values_[from], size(), values_[to]); }
  void begin(int i) {
    std::fill_n(values_[i], size(), 0.0);
    for (int wall = 0; wall < walls_; wall++) *of(i, wall) = NOT_KNOWN;
  }

  int pack(int i, double* buf) const {
    std::copy_n(values_[i], size(), buf);
    return size();
  }
  int unpack(int i, const double* buf) {
    std::copy_n(buf, size(), values_[i]);
    return size();
  }
  /// With their number in front, as in a restart file.
  int size_restart() const { return 1 + size(); }
  int pack_restart(int i, double* buf) const {
    buf[0] = size_restart();
    return 1 + pack(i, buf + 1);
  }
  /// The nth of the records in `records`.
  void unpack_restart(int i, const double* records, int nth) {
    int m = 0;
    for (int n = 0; n < nth; n++) m += static_cast<int>(records[m]);
    unpack(i, records + m + 1);
  }

  double bytes(int nmax) const { return static_cast<double>(sizeof(double)) * size() * nmax; }

 private:
  int walls_ = 0;
  int per_wall_ = 0;
  double** values_ = nullptr;  // per atom
};

}  // namespace LAMMPS_NS

#endif
