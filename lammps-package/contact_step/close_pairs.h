// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CLOSE_PAIRS_H
#define COHESION_CLOSE_PAIRS_H

#include <algorithm>
#include <cstddef>
#include <vector>

#include "atom.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// What is remembered of the pairs of the engine's list, by particle and place in its list of
/// neighbours; it stays where it is until the list is made anew.
struct RememberedPairs {
  int* const* has_history;
  double* const* history;
  int each;  ///< numbers of history
};

/// Two particles that may soon touch, and what is remembered of them.
struct ClosePair {
  int i, j;
  int* has_history;
  double* history;
};

/// The pairs of the engine's list of neighbours that are near each other. Most pairs of that list
/// are a skin apart. Those whose gap is below `allowed` are enough until particles have moved or
/// grown so far that others could come as near as is asked for.
class ClosePairs : protected Pointers {
 public:
  explicit ClosePairs(LAMMPS* lammps) : Pointers(lammps) {}

  /// Before a run: the engine's list has every pair with a gap up to `allowed` [length].
  void start(double allowed);
  double allowed() const { return allowed_; }
  /// Within a run: the engine's list has every pair with a gap up to `allowed` [length], from now
  /// on.
  void allow(double allowed) {
    if (allowed != allowed_) start(allowed);
  }

  /// Finds the pairs of `list` whose gap is below `reach` [length], which is at most allowed(),
  /// unless they are known. When the engine's list is new, pairs that are not close lose the mark
  /// `has_history`. `travelled` [length]: at most what a particle has moved by since the last call;
  /// `radii`: another number where radii have changed since then.
  void update(const class NeighList& list, double reach, double travelled, long radii,
              const RememberedPairs& known);

  /// Calls what(ClosePair) for the pairs that have a history or a gap below `reach`, in the order
  /// of the list; some at a time, whose memory, where it lies far apart, is fetched meanwhile.
  template <class What>
  [[gnu::always_inline]] void for_each_near(const What& what) const {
    const ClosePair* some[AT_A_TIME];
    const ClosePair* const end = pairs_.data() + count_;
    for (const ClosePair* p = pairs_.data(); p != end;) {
      const ClosePair* const stop = p + std::min<std::ptrdiff_t>(end - p, AT_A_TIME);
      const ClosePair** const last = find_near(p, stop, some);
      for (const ClosePair** near = some; near != last; near++) what(**near);
      p = stop;
    }
  }

 private:
  static constexpr int AT_A_TIME = 64, STEPS_OF_A_COUNT = 50;

  const ClosePair** find_near(const ClosePair* first, const ClosePair* stop,
                              const ClosePair** near) const;
  bool is_near(const ClosePair&, const double* x, const double* radius) const;
  bool may_have_come(double reach, bool radii_as_found) const;
  double come_closer() const;
  void find(const NeighList&, const RememberedPairs&, bool new_list);
  void count_remembered();
  static void forget_others(int* has_history, int count, const ClosePair* near,
                            const ClosePair* end);

  double allowed_ = 0.0;
  double reach_ = 0.0;
  double travelled_ = 0.0;  // at most, by a particle, since the pairs were found
  std::size_t count_ = 0;
  int each_ = 0;                   // numbers of history
  bool most_remembered_ = false;   // of the pairs, when they were counted
  int since_counted_ = 0;          // steps
  std::vector<ClosePair> pairs_;   // the first `count_` of these
  std::vector<double> radii_;      // per atom and ghost, when the pairs were found
  long radii_version_ = 0;         // of those
  std::vector<double> positions_;  // the same; empty: not found yet
};

}  // namespace LAMMPS_NS

#endif
