// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CLOSE_PAIRS_H
#define COHESION_CLOSE_PAIRS_H

#include <algorithm>
#include <cstddef>
#include <vector>

#include "atom.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Two particles that may soon touch, with their contact history, whose addresses are valid until
/// the list is rebuilt.
struct ClosePair {
  int i, j;
  int* has_history;
  double* history;
};

/// The close pairs of the engine's neighbour list. Most pairs of that list are a skin apart. Those
/// with a gap below `allowed` suffice until particles have moved or grown so far that another pair
/// could be within the requested reach.
class ClosePairs : protected Pointers {
 public:
  explicit ClosePairs(LAMMPS* lammps) : Pointers(lammps) {}

  /// To be called before a run. `allowed` [length]: the engine's list contains all pairs with a gap
  /// up to this.
  void start(double allowed);
  double allowed() const { return allowed_; }
  /// Numbers per history, at the last search.
  int each() const { return each_; }
  /// The same within a run, where that gap has changed.
  void allow(double allowed) {
    if (allowed != allowed_) start(allowed);
  }

  /// Searches `list` again if a pair outside the close pairs may have a gap below `reach` [length],
  /// which is at most allowed(). After a rebuild of the engine's list, pairs that are not close
  /// lose their history. `travelled` [length]: upper bound of the displacement of a particle since
  /// the last call; `radii`: differs from the last call's number if radii have changed; `known`:
  /// the histories of the pairs of the list, of `each` numbers.
  void update(const class NeighList& list, double reach, double travelled, long radii,
              const class FixNeighHistory& known, int each);

  /// Calls what(ClosePair) for the pairs with a history or a gap below `reach`, in the order of the
  /// list. Pairs are selected in blocks, so that their data can be prefetched.
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
  void find(const NeighList&, const FixNeighHistory&, bool new_list);
  void count_remembered();
  static void forget_others(int* has_history, int count, const ClosePair* near,
                            const ClosePair* end);

  double allowed_ = 0.0;
  double reach_ = 0.0;
  double travelled_ = 0.0;  // upper bound per particle, since the last search
  std::size_t count_ = 0;
  int each_ = 0;                   // numbers per history
  bool most_remembered_ = false;   // whether most pairs had a history at the last count
  int since_counted_ = 0;          // steps since then
  std::vector<ClosePair> pairs_;   // the first `count_` of these
  std::vector<double> radii_;      // per atom and ghost, at the last search
  long radii_version_ = 0;         // of these radii
  std::vector<double> positions_;  // likewise; empty before the first search
};

}  // namespace LAMMPS_NS

#endif
