// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_BOUND_PAIRS_H
#define COHESION_BOUND_PAIRS_H

#include <array>
#include <string>
#include <vector>

namespace LAMMPS_NS {

/// The interface, besides Pair, of a pair style whose pairs are bound or not.
class BoundPairs {
 public:
  /// Appends the pairs that are bound after the forces of the step: the index of an owned particle
  /// and that of its partner, which is owned or a ghost. A pair of two ranks is given by both.
  virtual void append_bound(std::vector<std::array<int, 2>>& pairs) const = 0;
  /// Appends those of them that would not part if nothing else met them.
  virtual void append_held(std::vector<std::array<int, 2>>& pairs) const { append_bound(pairs); }

 protected:
  ~BoundPairs() = default;
};

/// A fix that reads them. By this a pair style in which nothing acts knows that it must keep its
/// list of neighbours all the same; it asks the fixes and no computes.
class BoundPairsReader {
 protected:
  ~BoundPairsReader() = default;
};

/// Returns those of the pair style in use; stops where no pair style says which pairs are bound,
/// with `where` in front of the message. Valid until a pair style is defined anew.
std::vector<const BoundPairs*> bound_pairs(class LAMMPS*, const std::string& where);

}  // namespace LAMMPS_NS

#endif
