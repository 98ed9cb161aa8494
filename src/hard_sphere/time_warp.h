// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "hard_sphere/event_simulation.h"
#include "hard_sphere/message_log.h"
#include "hard_sphere/state_queue.h"

namespace cohesion::hard_sphere {

/// Optimistic parallel event-driven simulation with rollback: Time Warp, D. R. Jefferson, Virtual
/// Time, ACM Trans. Program. Lang. Syst. 7 (1985) 404, in synchronous rounds.
///
/// Each process owns a part of the bodies and has remote copies of those bodies of other processes
/// that its own may meet. It executes a window of the step optimistically, with the messages about
/// remote bodies that it has accepted so far. At the end of each round the processes exchange
/// messages about their own bodies. If the messages about a remote body differ from the accepted
/// ones, the process rolls back: a new message is a straggler, a missing one has been cancelled.
/// The rollback undoes the changes of this body from the first difference on, all changes that
/// depend on them, and those of bodies that meet the body on its new flight. All other events
/// remain executed. The earliest difference of all processes is the global virtual time (GVT): no
/// event before it is rolled back any more, and each round advances it.
///
/// A rollback sets bodies back to a time before the last events of others. A body whose flight
/// changes can therefore meet another body on a flight that the other has already ended. The state
/// queue stores these flights for the window.
class TimeWarp : public EventSimulation {
 public:
  /// Whether this process owns all bodies. Then no state is saved, and run() executes all events.
  bool single_process = true;

  /// Begins a window of the step at the time `from`. All events before it are final.
  void begin_window(double from) {
    window_start_ = from;
    neighbour_lists_.drop_former_neighbourhoods(from);
    states_.begin_window(bodies);
    messages_.begin_window(bodies.size());
    rollback_keys_.resize(bodies.size(), end_of_time);
    changed_own_bodies_.clear();
    window_end_ = executed_until_ = -never;
  }

  /// Executes events and processes accepted messages up to the time `until`.
  void run_window(double until) {
    window_end_ = until;
    while (overrun_.first < 0) {
      const PendingMessage* const message = messages_.next();
      const QueuedEvent next = event_queue_.next();
      if (message && message->key.time <= until && !(event_key(next) < message->key))
        process_message(message->body);
      else if (next.time <= until)
        process_next(next.body);
      else
        return;
    }
  }

  /// Ends the window: removes the events that have been rolled back from `events`.
  void end_window() {
    if (!any_event_rolled_back_) return;
    any_event_rolled_back_ = false;
    events.erase(
        std::remove_if(events.begin(), events.end(), [](const Event& e) { return e.i < 0; }),
        events.end());
  }

  /// Returns the shared own bodies whose messages of this window have changed since the last call.
  std::vector<int> take_changed_bodies() {
    std::sort(changed_own_bodies_.begin(), changed_own_bodies_.end());
    changed_own_bodies_.erase(std::unique(changed_own_bodies_.begin(), changed_own_bodies_.end()),
                              changed_own_bodies_.end());
    return std::exchange(changed_own_bodies_, {});
  }

  /// Sets `messages` to those about a body in this window, in the order of events.
  void collect_messages(int body, std::vector<EventMessage>& messages) const {
    messages.clear();
    FreeFlight flight = flights[body];
    EventState event_state = bodies[body].event_state;
    for (int n = last_change(body); n >= 0;) {
      const StateChange& change = states_[n];
      const SavedState& saved = change.saved_of(body);
      const int partner = change.saved[0].body == body ? change.partner : change.saved[0].body;
      messages.push_back({change.key, partner, flight, event_state});
      flight = saved.flight;
      event_state = saved.event_state;
      n = saved.previous;
    }
    std::reverse(messages.begin(), messages.end());
  }

  /// MessageLog::begin_receiving().
  std::vector<EventMessage>& begin_receiving(int body) { return messages_.begin_receiving(body); }

  /// The virtual time to which this process has to roll back. The minimum over all processes is the
  /// global virtual time; when its time is `never`, the window is complete.
  VirtualTime rollback_time() { return messages_.first_difference(); }

  /// Rolls back where received messages differ from the accepted ones, and accepts them.
  void roll_back_and_accept(const VirtualTime& gvt) {
    executed_until_ = window_end_;
    messages_.accept_received(gvt,
                              [this](int body, const EventKey& key) { roll_back_body(body, key); });
    predict_after_rollback();
  }

 protected:
  /// New neighbours can be ahead in time, too.
  void after_renewal(int body, double now) override {
    if (single_process) return;
    roll_back_bodies_met(body, {now, -1, 0, 0});
    predict_after_rollback();
  }

  double search_start(double now) const override { return single_process ? now : window_start_; }

  bool stayed_in_neighbourhood(int body) const override {
    if (single_process) return true;
    const FreeFlight* flight = &flights[body];
    for (int n = last_change(body);; n = states_[n].saved_of(body).previous) {
      const double begin = std::max(flight->start_time, window_start_);
      if (!neighbour_lists_.neighbourhood_contains(body, flight->at(begin), begin)) return false;
      if (n < 0) return true;
      flight = &states_[n].saved_of(body).flight;
    }
  }

  void before_event(const Event& event) override {
    if (single_process) return;
    StateChange& change = states_.add(event.key, static_cast<int>(events.size()) - 1, event.j);
    save_state(change.saved[0], event.i);
    if (!event.with_wall()) save_state(change.saved[1], event.j);
  }

  void after_event(const Event& event) override {
    if (single_process) return;
    const int i = event.i, j = event.j;
    const EventKey key = event.key;
    if (key.time > executed_until_) return;
    // A body without a rollback has its neighbourhood at its latest position, but bodies that have
    // been rolled back can meet it here.
    renew_if_outside(i, key.time);
    if (j >= 0) renew_if_outside(j, key.time);
    roll_back_bodies_met(i, key);
    if (j >= 0) roll_back_bodies_met(j, key);
    predict_after_rollback();
  }

 private:
  /// After all events.
  static constexpr EventKey end_of_time{never, 0, 0, 0};

  int last_change(int body) const { return states_.last_change(bodies[body]); }

  void save_state(SavedState& saved, int body) {
    states_.save(saved, body, flights[body], bodies[body]);
    mark_changed(body);
  }

  void mark_changed(int body) {
    if (!bodies[body].remote && bodies[body].shared) changed_own_bodies_.push_back(body);
  }

  /// Sets a remote body to the state of its next message.
  void process_message(int body) {
    const EventMessage& message = messages_.first_unprocessed(body);
    save_state(states_.add(message.key, -1, -1).saved[0], body);
    set_flight(body, message.flight, message.event_state);
    messages_.mark_processed(body);
    renew_if_outside(body, message.key.time);
    roll_back_bodies_met(body, message.key);
    predict_after_rollback();
    predict(body);
  }

  void renew_if_outside(int body, double time) {
    if (!neighbour_lists_.neighbourhood_contains(body, flights[body].at(time), time))
      renew_neighbours(body, time);
  }

  /// Undoes the changes of a body from `key` on.
  void roll_back_body(int body, const EventKey& key) {
    int first = -1;
    for (int n = last_change(body); n >= 0 && !(states_[n].key < key);
         n = states_[n].saved_of(body).previous)
      first = n;
    if (first >= 0) roll_back(first);
  }

  /// Undoes a change, after all changes that depend on it.
  void roll_back(int n) {
    std::vector<int> stack{n};
    while (!stack.empty()) {
      const int top = stack.back();
      const StateChange& change = states_[top];
      bool is_last = true;
      for (const SavedState& saved : change.saved)
        if (saved.body >= 0 && last_change(saved.body) != top) {
          stack.push_back(last_change(saved.body));
          is_last = false;
          break;
        }
      if (!is_last) continue;
      stack.pop_back();
      restore_states(change);
    }
  }

  /// Undoes a change that is the last one of its bodies.
  void restore_states(const StateChange& change) {
    overrun_ = {-1, -1};
    for (const SavedState& saved : change.saved) {
      if (saved.body < 0) continue;
      set_flight(saved.body, saved.flight, saved.event_state);
      states_.set_last_change(bodies[saved.body], saved.previous);
      mark_changed(saved.body);
      rollback_keys_[saved.body] = std::min(rollback_keys_[saved.body], change.key);
      rolled_back_bodies_.push_back(saved.body);
    }
    for (const SavedState& saved : change.saved)
      if (saved.body >= 0) renew_if_outside(saved.body, change.key.time);
    if (change.event < 0) {
      messages_.mark_unprocessed(change.saved[0].body);
      return;
    }
    Event& event = events[change.event];
    // The lists keep former neighbours until the end of the window.
    Neighbour& pair = *neighbour_lists_.find_neighbour(event.i, event.j, event.image);
    neighbour_lists_.set_inside(event.i, pair, event.was_inside);
    event.i = -1;
    any_event_rolled_back_ = true;
  }

  /// Rolls back the neighbours that a body meets on its flight after `from`, but that have had
  /// later events already. They are rolled back to the encounter.
  void roll_back_bodies_met(int body, const EventKey& from) {
    if (from.time > executed_until_) return;
    changes_after_encounters_.clear();
    for (const Neighbour* n = neighbour_lists_.begin(body); n != neighbour_lists_.end(body); n++) {
      if (n->is_wall() || flights[n->body].start_time < from.time) continue;
      const int first = first_change_after_encounter(body, *n, from);
      if (first >= 0) changes_after_encounters_.push_back(first);
    }
    for (const int change : changes_after_encounters_)
      if (is_in_effect(change)) roll_back(change);
  }

  /// Whether a change has not been rolled back.
  bool is_in_effect(int n) const {
    const int body = states_[n].saved[0].body;
    for (int k = last_change(body); k >= n; k = states_[k].saved_of(body).previous)
      if (k == n) return true;
    return false;
  }

  /// The first change of a neighbour after `from` that lies behind an encounter of both bodies, on
  /// the flight that the neighbour had before the change; -1: none.
  int first_change_after_encounter(int body, const Neighbour& neighbour,
                                   const EventKey& from) const {
    const FreeFlight& a = flights[body];
    const TagPair tags = tag_pair(body, neighbour.body);
    int first = -1;
    for (int n = last_change(neighbour.body); n >= 0 && from < states_[n].key;) {
      const SavedState& saved = states_[n].saved_of(neighbour.body);
      const FreeFlight& b = saved.flight;
      const double begin = std::max({from.time, a.start_time, b.start_time});
      const auto [r, w] = relative_motion(a, b, neighbour.image, begin);
      const double vv = std::max(dot(a.velocity, a.velocity), dot(b.velocity, b.velocity));
      const Crossing next =
          next_crossing(r, w, vv, surfaces(body, neighbour.body), neighbour.inside);
      const double time = begin + next.wait;
      const int depth_a = causal_depth_at(time, body);
      const int depth_b = causal_depth_at(time, b, saved.event_state);
      const EventKey key{time, 1 + std::max(depth_a, depth_b), tags.i, tags.j};
      if (key < states_[n].key) first = n;
      n = saved.previous;
    }
    return first;
  }

  /// Rolls back the bodies that meet those that have been rolled back, and predicts the events of
  /// all of them.
  void predict_after_rollback() {
    for (std::size_t n = 0; n < rolled_back_bodies_.size(); n++) {
      const int body = rolled_back_bodies_[n];
      const EventKey from = std::exchange(rollback_keys_[body], end_of_time);
      if (from < end_of_time) roll_back_bodies_met(body, from);
    }
    for (const int body : rolled_back_bodies_) predict(body);
    rolled_back_bodies_.clear();
  }

  double window_start_ = 0.0;       // [time]
  double window_end_ = -never;      // [time]; -never before the first round
  double executed_until_ = -never;  // time that events of earlier rounds have reached, [time]
  StateQueue states_;
  MessageLog messages_;
  std::vector<int> changed_own_bodies_;
  std::vector<int> rolled_back_bodies_;  // without predictions
  std::vector<EventKey> rollback_keys_;  // by body: where its rollback began
  std::vector<int> changes_after_encounters_;
  bool any_event_rolled_back_ = false;
};

}  // namespace cohesion::hard_sphere
