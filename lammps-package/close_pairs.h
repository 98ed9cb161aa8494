// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CLOSE_PAIRS_H
#define COHESION_CLOSE_PAIRS_H

#include <vector>

#include "pointers.h"

namespace LAMMPS_NS {

/// Two particles that may soon touch.
struct ClosePair {
  int i, j;
  int place;  ///< of j in i's list of neighbours
};

/// The pairs of the engine's list of neighbours that are near each other. Most pairs of that list
/// are a skin apart. Those whose gap is below `allowed` are enough until particles have moved or
/// grown so far that others could come as near as is asked for.
class ClosePairs : protected Pointers {
 public:
  explicit ClosePairs(LAMMPS* lammps)
      : Pointers(lammps), allowed_(0.0), count_(0), near_end_(nullptr) {}

  /// Before a run: the engine's list has every pair with a gap up to `allowed` [length].
  void start(double allowed);
  double allowed() const { return allowed_; }

  /// Finds the pairs of `list` whose gap is below `reach` [length], which is at most allowed(), in
  /// the order of the list. When the engine's list is new, pairs that are not close lose the mark
  /// `kept` (by particle and place in its list of neighbours) that they have a history.
  void update(const class NeighList& list, double reach, int** kept);

  const ClosePair* begin() const { return near_.data(); }
  const ClosePair* end() const { return near_end_; }

 private:
  double come_closer() const;
  void find(const NeighList&, int** kept);
  void sift(double reach);
  static void forget_others(int* kept, int count, const ClosePair* near, const ClosePair* end);

  double allowed_;
  std::size_t count_;
  std::vector<ClosePair> pairs_;  // the first `count_` of these
  std::vector<ClosePair> near_;   // those whose gap is below `reach` now
  const ClosePair* near_end_;
  std::vector<double> radii_;      // per atom and ghost, when the pairs were found
  std::vector<double> positions_;  // the same; empty: not found yet
};

}  // namespace LAMMPS_NS

#endif
