// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_BOX_SIDES_H
#define COHESION_BOX_SIDES_H

#include <array>
#include <cmath>

#include "domain.h"

namespace LAMMPS_NS {

/// The sides of the box that scripts can change between runs; those that the engine wraps around
/// the particles move by themselves.
class BoxSides {
 public:
  void store(const Domain* d) {
    sides_ = of(d);
    known_ = true;
  }
  /// Whether they have changed since store(); not before the first.
  bool changed(const Domain* d) const { return known_ && of(d) != sides_; }
  /// Whether the image of a particle at x, outside of the box where it is one through its sides, is
  /// elsewhere than store() had it.
  bool moves_image(const Domain* d, const double* x) const {
    if (!changed(d)) return false;
    const auto now = of(d);
    for (int k = 0; k < 3; k++) {
      if (now[9 + k] != sides_[9 + k]) return true;
      if (x[k] >= d->boxlo[k] && x[k] < d->boxhi[k]) continue;
      const double length = now[3 + k] - now[k], before = sides_[3 + k] - sides_[k];
      if (now[6 + k] != sides_[6 + k]) return true;
      if (now[6 + k] != 0.0 && std::abs(length - before) > 1e-13 * length) return true;
    }
    return false;
  }

 private:
  static std::array<double, 12> of(const Domain* d) {
    std::array<double, 12> sides{};
    for (int k = 0; k < 3; k++) {
      constexpr int first_wrapped = 2;
      if (d->boundary[k][0] < first_wrapped) sides[k] = d->boxlo[k];
      if (d->boundary[k][1] < first_wrapped) sides[3 + k] = d->boxhi[k];
      sides[6 + k] = d->periodicity[k];
    }
    sides[9] = d->xy;
    sides[10] = d->xz;
    sides[11] = d->yz;
    return sides;
  }

  std::array<double, 12> sides_{};
  bool known_ = false;
};

}  // namespace LAMMPS_NS

#endif
