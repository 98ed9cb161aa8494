// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <queue>
#include <vector>

#include "hard_sphere/bodies.h"

namespace cohesion::hard_sphere {

/// Message of Time Warp (time_warp.h) about an event: the state of a body after it. The process
/// that owns the body sends it to the processes that have a remote copy of the body.
struct EventMessage {
  EventKey key;            ///< virtual time of the event
  int partner;             ///< body in the numbering of the sender, or wall
  FreeFlight flight;       ///< after the event
  EventState event_state;  ///< after the event
};

inline bool same(const EventKey& a, const EventKey& b) { return !(a < b) && !(b < a); }
inline bool same(const EventMessage& a, const EventMessage& b) {
  return same(a.key, b.key) && same(a.flight, b.flight) && same(a.event_state, b.event_state);
}

/// Virtual time up to which all processes agree: time, then causal depth.
struct VirtualTime {
  double time = never;  ///< [time]
  int causal_depth = 0;

  bool operator<(const VirtualTime& b) const {
    return time != b.time ? time < b.time : causal_depth < b.causal_depth;
  }
};

/// Position of an unprocessed message in the order of events.
struct PendingMessage {
  EventKey key;
  int body;
  std::size_t number;  ///< in the input queue of the body

  /// std::priority_queue returns the largest element, which has to be the earliest one.
  bool operator<(const PendingMessage& b) const { return b.key < key; }
};

/// The messages of one window about the remote bodies of this process.
///
/// Each body has an input queue, from which the process executes its events, and the messages that
/// its owner has sent last. The owner sends all messages of a body again when one of them has
/// changed. So a message of the input queue that is absent among the received ones has been
/// cancelled, which an anti-message does in Jefferson's formulation.
class MessageLog {
 public:
  /// Discards all messages. `bodies`: number of bodies, own and remote.
  void begin_window(std::size_t bodies) {
    for (const int body : bodies_with_messages_) queues_[body].clear();
    bodies_with_messages_.clear();
    queues_.resize(bodies);
    pending_ = {};
  }

  /// Empties the received messages of a remote body and returns them. The caller fills them in the
  /// order of events, without those of events with a body of this process, which executes these
  /// events itself.
  std::vector<EventMessage>& begin_receiving(int body) {
    bodies_with_messages_.push_back(body);
    queues_[body].received.clear();
    return queues_[body].received;
  }

  /// The earliest virtual time at which input queues and received messages differ.
  VirtualTime first_difference() {
    std::sort(bodies_with_messages_.begin(), bodies_with_messages_.end());
    bodies_with_messages_.erase(
        std::unique(bodies_with_messages_.begin(), bodies_with_messages_.end()),
        bodies_with_messages_.end());
    VirtualTime first;
    for (const int body : bodies_with_messages_) {
      const BodyQueues& queues = queues_[body];
      const std::size_t n = queues.matching();
      for (const std::vector<EventMessage>* list : {&queues.input, &queues.received})
        if (n < list->size()) {
          const EventKey& key = (*list)[n].key;
          first = std::min(first, VirtualTime{key.time, key.causal_depth});
        }
    }
    return first;
  }

  /// Makes input queues equal to the received messages. Calls roll_back(body, key) before, with the
  /// key of the first difference of a body.
  ///
  /// Messages of the instant of `gvt` with a larger causal depth wait for the next round. Otherwise
  /// two processes could exchange a chain of events of one instant without end, each event being
  /// the cause of the next one on the other process.
  template <class RollBack>
  void accept_received(const VirtualTime& gvt, const RollBack& roll_back) {
    for (const int body : bodies_with_messages_) {
      std::vector<EventMessage>& input = queues_[body].input;
      const std::vector<EventMessage>& received = queues_[body].received;
      const std::size_t n = queues_[body].matching();
      if (n == input.size() && n == received.size()) continue;
      EventKey key = n < input.size() ? input[n].key : received[n].key;
      if (n < received.size() && received[n].key < key) key = received[n].key;
      roll_back(body, key);
      input.resize(n);
      for (std::size_t k = n; k < received.size(); k++) {
        if (received[k].key.time == gvt.time && received[k].key.causal_depth > gvt.causal_depth)
          break;
        input.push_back(received[k]);
      }
      enqueue_next(body);
    }
  }

  /// The earliest unprocessed message; nullptr if there is none.
  const PendingMessage* next() {
    while (!pending_.empty() && !is_valid(pending_.top())) pending_.pop();
    return pending_.empty() ? nullptr : &pending_.top();
  }

  /// The first unprocessed message of a body.
  const EventMessage& first_unprocessed(int body) const {
    return queues_[body].input[queues_[body].processed];
  }
  /// Marks next(), which belongs to this body, as processed.
  void mark_processed(int body) {
    queues_[body].processed++;
    pending_.pop();
    enqueue_next(body);
  }
  /// After a rollback of the last processed message of a body.
  void mark_unprocessed(int body) {
    queues_[body].processed--;
    enqueue_next(body);
  }

 private:
  struct BodyQueues {
    std::vector<EventMessage> input, received;
    std::size_t processed = 0;  // messages of the input queue

    /// Keeps the memory for the next window.
    void clear() {
      input.clear();
      received.clear();
      processed = 0;
    }

    /// How many messages at the beginning of both lists are the same.
    std::size_t matching() const {
      std::size_t n = 0;
      while (n < input.size() && n < received.size() && same(input[n], received[n])) n++;
      return n;
    }
  };

  /// A rollback leaves elements in the priority queue that are not valid any more.
  bool is_valid(const PendingMessage& message) const {
    const BodyQueues& queues = queues_[message.body];
    return message.number == queues.processed && message.number < queues.input.size() &&
           same(message.key, queues.input[message.number].key);
  }

  void enqueue_next(int body) {
    const BodyQueues& queues = queues_[body];
    if (queues.processed < queues.input.size())
      pending_.push({queues.input[queues.processed].key, body, queues.processed});
  }

  std::vector<BodyQueues> queues_;  // by body
  std::vector<int> bodies_with_messages_;
  std::priority_queue<PendingMessage> pending_;
};

}  // namespace cohesion::hard_sphere
