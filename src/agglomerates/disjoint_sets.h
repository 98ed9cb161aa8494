// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numeric>
#include <utility>
#include <vector>

namespace cohesion::agglomerates {

/// Sets of connected particles: union-find with path halving, joined by size, so that n joins take
/// a time hardly above n. Source: R. E. Tarjan, J. ACM 22 (1975) 215.
class DisjointSets {
 public:
  /// Sets the number of particles, each of which is a set of its own.
  void reset(int number) {
    parent.resize(number);
    std::iota(parent.begin(), parent.end(), 0);
    members.assign(number, 1);
  }

  /// The particle that represents the set of i; the same for all of a set until sets are joined.
  int root(int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }

  void join(int i, int j) {
    int a = root(i), b = root(j);
    if (a == b) return;
    if (members[a] < members[b]) std::swap(a, b);
    parent[b] = a;
    members[a] += members[b];
  }

  /// Number of particles in the set of i.
  int size(int i) { return members[root(i)]; }

 private:
  std::vector<int> parent, members;
};

}  // namespace cohesion::agglomerates
