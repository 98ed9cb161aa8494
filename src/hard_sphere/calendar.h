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
    double time = std::numeric_limits<double>::infinity();  ///< [time]
    int body = -1;                                          ///< whose turn it is
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
  /// same time.
  template <class Before>
  void set(const Entry& entry, const Before& before) {
    std::size_t node = leaves_ + entry.body;
    nodes_[node] = entry;
    for (; node > 1; node /= 2) {
      const Entry &a = nodes_[node], &b = nodes_[node ^ 1];
      const bool b_first =
          b.time < a.time || (b.time == a.time && b.body >= 0 && (a.body < 0 || before(b, a)));
      const Entry& first = b_first ? b : a;
      Entry& above = nodes_[node / 2];
      // Nothing changes farther up where the body had not come first and does not now.
      if (above.body == first.body && first.body != entry.body) return;
      above = first;
    }
  }

  double bytes() const { return static_cast<double>(nodes_.capacity() * sizeof(Entry)); }

 private:
  std::size_t leaves_ = 1;
  std::vector<Entry> nodes_ = std::vector<Entry>(2);
};

}  // namespace cohesion::hard_sphere
