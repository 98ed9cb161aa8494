// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_ATOM_NUMBERS_H
#define COHESION_ATOM_NUMBERS_H

#include <algorithm>

#include "atom.h"
#include "memory.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Numbers that each particle takes along when it changes its place or its process, and into
/// restart files: what a fix asks of its per-atom arrays. Without room until grow().
class AtomNumbers : protected Pointers {
 public:
  explicit AtomNumbers(LAMMPS* lammps, int size = 0) : Pointers(lammps), size_(size) {}
  ~AtomNumbers() override { free(); }
  AtomNumbers(const AtomNumbers&) = delete;
  AtomNumbers& operator=(const AtomNumbers&) = delete;

  /// Of a particle.
  int size() const { return size_; }
  double* of(int i) const { return values_[i]; }
  /// Alike on all processes, also on one without particles.
  bool has_room() const { return has_room_; }

  void grow(int nmax) {
    memory->grow(values_, std::max(nmax, 1), size_, "cohesion:atom_numbers");
    has_room_ = true;
  }
  void free() {
    memory->destroy(values_);
    has_room_ = false;
  }
  void copy(int from, int to) const { std::copy_n(of(from), size_, of(to)); }
  void clear(int i) const { std::fill_n(of(i), size_, 0.0); }

  /// How many numbers were written, or read.
  int pack(int i, double* buf) const {
    std::copy_n(of(i), size_, buf);
    return size_;
  }
  int unpack(int i, const double* buf) const {
    std::copy_n(buf, size_, of(i));
    return size_;
  }
  /// With their number in front, as in a restart file.
  int size_restart() const { return 1 + size_; }
  int pack_restart(int i, double* buf) const {
    buf[0] = size_restart();
    return 1 + pack(i, buf + 1);
  }
  /// The nth of the records in `records`.
  void unpack_restart(int i, const double* records, int nth) const {
    int m = 0;
    for (int n = 0; n < nth; n++) m += static_cast<int>(records[m]);
    unpack(i, records + m + 1);
  }

  double bytes() const {
    return has_room_ ? static_cast<double>(sizeof(double)) * size_ * atom->nmax : 0.0;
  }

 protected:
  void resize(int size) { size_ = size; }

 private:
  double** values_ = nullptr;
  bool has_room_ = false;
  int size_;
};

}  // namespace LAMMPS_NS

#endif
