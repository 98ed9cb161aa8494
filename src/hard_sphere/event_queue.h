// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace cohesion::hard_sphere {

/// The next event of a body.
struct QueuedEvent {
  double time = std::numeric_limits<double>::infinity();  ///< [time]
  int body = -1;                                          ///< body that has the event
  // Resolve ties. They must not change while the event is in the queue.
  int partner = -1;
  int depth = -1;
};

/// Queue of the next events of all bodies: a tournament tree, in which each node holds the earlier
/// event of its two children. D. E. Knuth, The Art of Computer Programming 3, section 5.4.1.
class EventQueue {
 public:
  /// Empties the queue for `bodies` bodies.
  void reset(std::size_t bodies) {
    leaves_ = 1;
    while (leaves_ < bodies) leaves_ *= 2;
    nodes_.assign(2 * leaves_, QueuedEvent{});
  }

  /// Extends the queue to more bodies. Returns false if that required reset().
  bool reserve(std::size_t bodies) {
    if (bodies <= leaves_) return true;
    reset(bodies);
    return false;
  }

  const QueuedEvent& next() const { return nodes_[1]; }

  /// Replaces the next event of a body. before(a, b) decides whether event a precedes event b of
  /// the same time. on_new_leader(body, subtrees) is called for each body that becomes the first of
  /// one of `subtrees` equal subtrees, a power of 2. Such a body is among about the next `subtrees`
  /// ones of the queue.
  template <class Before, class OnNewLeader>
  void replace(const QueuedEvent& event, const Before& before, const OnNewLeader& on_new_leader) {
    std::size_t node = leaves_ + event.body;
    nodes_[node] = event;
    for (std::size_t subtrees = leaves_ / 2; node > 1; node /= 2, subtrees /= 2) {
      const QueuedEvent &a = nodes_[node], &b = nodes_[node ^ 1];
      const bool b_first =
          b.time < a.time || (b.time == a.time && b.body >= 0 && (a.body < 0 || before(b, a)));
      const QueuedEvent& first = b_first ? b : a;
      QueuedEvent& above = nodes_[node / 2];
      // The nodes above stay the same if the body was not and is not the winner here.
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
