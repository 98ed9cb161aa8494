// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CLOSE_PAIRS_H
#define COHESION_CLOSE_PAIRS_H

#include <vector>

#include "atom.h"
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
  explicit ClosePairs(LAMMPS* lammps) : Pointers(lammps), allowed_(0.0), reach_(0.0), count_(0) {}

  /// Before a run: the engine's list has every pair with a gap up to `allowed` [length].
  void start(double allowed);
  double allowed() const { return allowed_; }

  /// Finds the pairs of `list` whose gap is below `reach` [length], which is at most allowed(),
  /// unless they are known. When the engine's list is new, pairs that are not close lose the mark
  /// `has_history` (by particle and place in its list of neighbours).
  void update(const class NeighList& list, double reach, int** has_history);

  /// Calls what(pair, has_history) for the pairs that have a history or a gap below `reach`, in the
  /// order of the list.
  template <class What>
  [[gnu::always_inline]] void for_each_near(int* const* has_history, const What& what) const {
    const double* const x = atom->x[0];
    const double* const radius = atom->radius;
    const ClosePair* const end = pairs_.data() + count_;
    for (const ClosePair* p = pairs_.data(); p != end; p++) {
      const int i = p->i, j = p->j;
      int& marked = has_history[i][p->place];
      if (!marked) {
        const double dx = x[3 * j] - x[3 * i], dy = x[3 * j + 1] - x[3 * i + 1],
                     dz = x[3 * j + 2] - x[3 * i + 2];
        const double near = radius[i] + radius[j] + reach_;
        if (dx * dx + dy * dy + dz * dz > 1.0002 * near * near) continue;
      }
      what(*p, marked);
    }
  }

 private:
  double come_closer() const;
  void find(const NeighList&, int** has_history);
  static void forget_others(int* has_history, int count, const ClosePair* near,
                            const ClosePair* end);

  double allowed_;
  double reach_;
  std::size_t count_;
  std::vector<ClosePair> pairs_;   // the first `count_` of these
  std::vector<double> radii_;      // per atom and ghost, when the pairs were found
  std::vector<double> positions_;  // the same; empty: not found yet
};

}  // namespace LAMMPS_NS

#endif
