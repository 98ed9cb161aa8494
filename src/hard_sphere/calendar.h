// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace cohesion::hard_sphere {

/// Which of many bodies is next: a tournament, in which each node holds the earlier of the two
/// below it. D. E. Knuth, The Art of Computer Programming 3, section 5.4.1.
class Calendar {
 public:
  struct Entry {
    double time = never;  ///< [time]
    int body = -1;        ///< whose turn it is
    // The place among those of the same time; must not change while the entry is there.
    int partner = -1;
    int depth = -1;
  };

  /// Starts with `bodies` bodies, none of which has anything before it.
  void reset(std::size_t bodies) {
    leaves_ = 1;
    while (leaves_ < bodies) leaves_ *= 2;
    nodes_.assign(2 * leaves_, Entry{});
  }

  /// Makes room for more bodies; false: there was not enough, and reset() has been called.
  bool make_room(std::size_t bodies) {
    if (bodies <= leaves_) return true;
    reset(bodies);
    return false;
  }

  const Entry& next() const { return nodes_[1]; }

  /// Sets what is next for a body. `before(a, b)` says whether entry a comes before entry b of the
  /// same time. `rises(body, parts)` is called for each body that comes first in one of so many
  /// parts of all, a power of 2, and did not so far, or had nothing before it: its turn is one of
  /// about the next `parts`.
  template <class Before, class Rises>
  void set(const Entry& entry, const Before& before, const Rises& rises) {
    std::size_t node = leaves_ + entry.body;
    nodes_[node] = entry;
    for (std::size_t parts = leaves_ / 2; node > 1; node /= 2, parts /= 2) {
      const Entry &a = nodes_[node], &b = nodes_[node ^ 1];
      const bool b_first =
          b.time < a.time || (b.time == a.time && b.body >= 0 && (a.body < 0 || before(b, a)));
      const Entry& first = b_first ? b : a;
      Entry& above = nodes_[node / 2];
      // Nothing changes farther up where the body had not come first and does not now.
      const bool same = above.body == first.body;
      if (same && first.body != entry.body) return;
      if (first.time < never && !(same && above.time < never)) rises(first.body, parts);
      above = first;
    }
  }

  double bytes() const { return static_cast<double>(nodes_.capacity() * sizeof(Entry)); }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  std::size_t leaves_ = 1;
  std::vector<Entry> nodes_ = std::vector<Entry>(2);
};

}  // namespace cohesion::hard_sphere
