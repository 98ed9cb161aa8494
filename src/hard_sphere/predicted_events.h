// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "hard_sphere/body_renumbering.h"
#include "hard_sphere/crossing.h"

namespace cohesion::hard_sphere {

/// Event of a body with a partner, valid unless one of both changes its flight before.
struct PredictedEvent {
  double time;            ///< [time]
  int partner;            ///< body, or -1 - number of the wall
  std::uint32_t version;  ///< of the flight of the partner at the prediction
  int image;              ///< of the partner
  Surface surface;
};

/// The next events of a body in order of time: all before the horizon. At the horizon they have to
/// be predicted again. Event lists: M. N. Bannerman et al., J. Comput. Chem. 32 (2011) 3329.
/// Keeping several events avoids most of the predictions after a change of the partner.
class alignas(64) PredictedEvents {
 public:
  void reset(double horizon) {
    horizon_ = horizon;
    count_ = 0;
  }

  double horizon() const { return horizon_; }
  bool empty() const { return count_ == 0; }
  const PredictedEvent& front() const { return events_[0]; }
  double next_time() const { return count_ > 0 ? events_[0].time : horizon_; }

  /// Whether all partners keep their numbers.
  bool keeps_partners(const BodyRenumbering& renumbering) const {
    for (int n = 0; n < count_; n++)
      if (events_[n].partner >= 0 && !renumbering.is_unchanged(events_[n].partner)) return false;
    return true;
  }

  /// Renumbers partners. Returns false if one has been removed.
  bool renumber(const BodyRenumbering& renumbering) {
    for (int n = 0; n < count_; n++) {
      int& partner = events_[n].partner;
      if (partner < 0) continue;
      partner = renumbering.new_number(partner);
      if (partner < 0) return false;
    }
    return true;
  }

  void pop() {
    count_--;
    for (int n = 0; n < count_; n++) events_[n] = events_[n + 1];
  }

  /// Adds an event. before(a, b): whether event a precedes event b of the same time.
  template <class Before>
  void add(const PredictedEvent& event, const Before& before) {
    if (event.time > horizon_) return;
    int slot = count_;
    while (slot > 0 && (event.time < events_[slot - 1].time ||
                        (event.time == events_[slot - 1].time && before(event, events_[slot - 1]))))
      slot--;
    if (count_ == capacity) {
      // The earliest event beyond the capacity becomes the horizon.
      horizon_ = slot == capacity ? event.time : events_[capacity - 1].time;
      if (slot == capacity) return;
      count_--;
    } else if (event.time == horizon_) {
      return;
    }
    for (int n = count_; n > slot; n--) events_[n] = events_[n - 1];
    events_[slot] = event;
    count_++;
  }

 private:
  static constexpr int capacity = 4;

  double horizon_ = never;
  int count_ = 0;
  PredictedEvent events_[capacity];
};

}  // namespace cohesion::hard_sphere
