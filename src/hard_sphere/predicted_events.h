// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "hard_sphere/crossing.h"
#include "hard_sphere/renumbering.h"

namespace cohesion::hard_sphere {

/// What will happen between a body and a partner unless one of them changes its flight before.
struct PredictedEvent {
  double time;            ///< [time]
  int partner;            ///< body, or -1 - number of the wall
  std::uint32_t version;  ///< of the partner's flight that this is true for
  int image;              ///< of the partner
  Surface surface;
};

/// The next events of a body, in order of time: all that come before the horizon. At the horizon
/// they have to be predicted anew. Event lists of M. N. Bannerman et al., J.
/// Comput. Chem. 32 (2011) 3329: to keep more than the first saves most of the predictions that a
/// change of the partner would ask for.
class alignas(64) PredictedEvents {
 public:
  void begin(double horizon) {
    horizon_ = horizon;
    count_ = 0;
  }

  double horizon() const { return horizon_; }
  bool empty() const { return count_ == 0; }
  const PredictedEvent& front() const { return events_[0]; }
  double next_time() const { return count_ > 0 ? events_[0].time : horizon_; }

  /// Whether all partners keep their numbers.
  bool keep_partners(const Renumbering& to) const {
    for (int n = 0; n < count_; n++)
      if (events_[n].partner >= 0 && !to.keeps(events_[n].partner)) return false;
    return true;
  }

  /// Gives partners other numbers; false: one is gone.
  bool renumber(const Renumbering& to) {
    for (int n = 0; n < count_; n++) {
      int& partner = events_[n].partner;
      if (partner < 0) continue;
      partner = to.now(partner);
      if (partner < 0) return false;
    }
    return true;
  }

  void pop() {
    count_--;
    for (int n = 0; n < count_; n++) events_[n] = events_[n + 1];
  }

  /// Adds an event. `before(a, b)`: whether event a comes before event b of the same time.
  template <class Before>
  void add(const PredictedEvent& event, const Before& before) {
    if (event.time > horizon_) return;
    int at = count_;
    while (at > 0 && (event.time < events_[at - 1].time ||
                      (event.time == events_[at - 1].time && before(event, events_[at - 1]))))
      at--;
    if (count_ == room) {
      // What finds no room is the horizon.
      horizon_ = at == room ? event.time : events_[room - 1].time;
      if (at == room) return;
      count_--;
    } else if (event.time == horizon_) {
      return;
    }
    for (int n = count_; n > at; n--) events_[n] = events_[n - 1];
    events_[at] = event;
    count_++;
  }

 private:
  static constexpr int room = 4;

  double horizon_ = never;
  int count_ = 0;
  PredictedEvent events_[room];
};

}  // namespace cohesion::hard_sphere
