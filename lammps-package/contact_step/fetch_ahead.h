// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_FETCH_AHEAD_H
#define COHESION_FETCH_AHEAD_H

namespace LAMMPS_NS {

/// Asks for numbers that will soon be read, at most 16 of them: a loop over contacts goes from one
/// place in memory to another, and would wait at each.
inline void fetch_ahead(const double* numbers, int count) {
  __builtin_prefetch(numbers, 1);
  __builtin_prefetch(numbers + count - 1, 1);
}

}  // namespace LAMMPS_NS

#endif
