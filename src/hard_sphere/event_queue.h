// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace cohesion::hard_sphere {

/// The next event of a body.
struct QueuedEvent {
  double time = std::numeric_limits<double>::infinity();  ///< [time]
  int body = -1;                                          ///< whose turn it is
  // The place among those of the same time; must not change while the entry is there.
  int partner = -1;
  int depth = -1;
};

/// Which of many bodies is next: a tournament, in which each node holds the earlier of the two
/// below it. D. E. Knuth, The Art of Computer Programming 3, section 5.4.1.
class EventQueue {
 public:
  /// Starts with `bodies` bodies, none of which has anything before it.
  void reset(std::size_t bodies) {
    leaves_ = 1;
    while (leaves_ < bodies) leaves_ *= 2;
    nodes_.assign(2 * leaves_, QueuedEvent{});
  }

  /// Makes room for more bodies; false: there was not enough, and reset() has been called.
  bool reserve(std::size_t bodies) {
    if (bodies <= leaves_) return true;
    reset(bodies);
    return false;
  }

  const QueuedEvent& next() const { return nodes_[1]; }

  /// Sets what is next for a body. `before(a, b)` says whether entry a comes before entry b of the
  /// same time. `rises(body, parts)` is called for each body that comes first in one of so many
  /// parts of all, a power of 2, and did not so far, or had nothing before it: its turn is one of
  /// about the next `parts`.
  template <class Before, class Rises>
  void set(const QueuedEvent& event, const Before& before, const Rises& on_new_leader) {
    std::size_t node = leaves_ + event.body;
    nodes_[node] = event;
    for (std::size_t subtrees = leaves_ / 2; node > 1; node /= 2, subtrees /= 2) {
      const QueuedEvent &a = nodes_[node], &b = nodes_[node ^ 1];
      const bool b_first =
          b.time < a.time || (b.time == a.time && b.body >= 0 && (a.body < 0 || before(b, a)));
      const QueuedEvent& first = b_first ? b : a;
      QueuedEvent& above = nodes_[node / 2];
      // Nothing changes farther up where the body had not come first and does not now.
      const bool same = above.body == first.body;
      if (same && first.body != event.body) return;
      if (first.time < never && !(same && above.time < never)) on_new_leader(first.body, subtrees);
      above = first;
    }
  }

  double bytes() const { return static_cast<double>(nodes_.capacity() * sizeof(QueuedEvent)); }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  std::size_t leaves_ = 1;
  std::vector<QueuedEvent> nodes_ = std::vector<QueuedEvent>(2);
};

}  // namespace cohesion::hard_sphere
