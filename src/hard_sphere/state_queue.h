// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "hard_sphere/bodies.h"

namespace cohesion::hard_sphere {

/// State of a body before a change, which a rollback restores.
struct SavedState {
  int body = -1;
  int previous = -1;  ///< the change of the body before this one; -1: none in this window
  FreeFlight flight;
  EventState event_state;
};

/// An executed event, or a processed message about a remote body.
struct StateChange {
  EventKey key;
  int event = -1;    ///< index into EventSimulation::events; -1: a message
  int partner = -1;  ///< partner of saved[0].body in the event
  SavedState saved[2];

  const SavedState& saved_of(int body) const { return saved[saved[0].body == body ? 0 : 1]; }
};

/// State queue of Time Warp (time_warp.h): the changes of one window in the order of execution. The
/// changes of each body form a linked list, of which HardSphere::last_change is the head.
///
/// Numbers of changes increase over all windows. So the heads of the previous windows are out of
/// range and need no reset.
class StateQueue {
 public:
  /// Discards all changes, so that they are final.
  void begin_window(std::vector<HardSphere>& bodies) {
    first_number_ += static_cast<std::uint32_t>(changes_.size());
    changes_.clear();
    if (first_number_ <= largest_first_number) return;
    first_number_ = 1;
    for (HardSphere& body : bodies) body.last_change = 0;
  }

  const StateChange& operator[](int n) const { return changes_[n]; }

  StateChange& add(const EventKey& key, int event, int partner) {
    StateChange& change = changes_.emplace_back();
    change.key = key;
    change.event = event;
    change.partner = partner;
    return change;
  }

  /// Saves the state of a body in the change that has been added last.
  void save(SavedState& saved, int number, const FreeFlight& flight, HardSphere& body) {
    saved = {number, last_change(body), flight, body.event_state};
    set_last_change(body, static_cast<int>(changes_.size()) - 1);
  }

  /// The last change of a body in this window; -1: none.
  int last_change(const HardSphere& body) const {
    const std::uint32_t n = body.last_change - first_number_;
    return n < changes_.size() ? static_cast<int>(n) : -1;
  }
  void set_last_change(HardSphere& body, int n) const {
    body.last_change = n < 0 ? 0 : first_number_ + static_cast<std::uint32_t>(n);
  }

 private:
  /// Half of the numbers that HardSphere::last_change can have: a window does not overflow them.
  static constexpr std::uint32_t largest_first_number = 1u << 31;

  std::vector<StateChange> changes_;
  std::uint32_t first_number_ = 1;  // of changes_[0]; 0 is the number of no change
};

}  // namespace cohesion::hard_sphere
