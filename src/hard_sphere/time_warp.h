// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include "hard_sphere/event_simulation.h"

namespace cohesion::hard_sphere {

/// What a body does after an event, for the processes that have it too.
struct RemoteUpdate {
  EventKey key;
  int partner;  ///< body of the sender, or wall
  FreeFlight flight;
  Course course;
};

inline bool same(const EventKey& a, const EventKey& b) { return !(a < b) && !(b < a); }
inline bool same(const RemoteUpdate& a, const RemoteUpdate& b) {
  return same(a.key, b.key) && same(a.flight, b.flight) && same(a.course, b.course);
}

/// An event-driven simulation whose bodies are divided among processes: an optimistic parallel one
/// with rollback, Time Warp, D. R. Jefferson, Virtual Time, ACM Trans. Program. Lang. Syst. 7
/// (1985) 404, in rounds.
///
/// Each process has its own bodies and those of others that these may meet, the remote ones. It
/// runs ahead through a window of the step with the updates of remote bodies that it knows of. In
/// each round the processes tell each other the updates of their own bodies. Where those of a
/// remote body are others than were assumed, what it did from the first difference on is undone,
/// what followed from that, and what others did who meet it on its new way; then the process runs
/// again through what is not done. All the rest stays. The first difference of all processes is
/// Jefferson's global virtual time: what is before it is never undone, and every round brings it
/// farther.
///
/// An event that is undone leaves bodies behind that are in the past of others. So a body that
/// changes its flight can meet one that has already gone on: on one of the flights that that one
/// had since then, which are kept for the window.
class TimeWarp : public EventSimulation {
 public:
  /// Whether this process has all bodies: nothing is kept then to be undone, and run() does all.
  bool alone = true;

  /// A window of the step begins, at the time `from`: what has been done is final.
  void begin_window(double from) {
    window_start_ = from;
    neighbourhoods_.forget_former_homes(from);
    first_change_ += static_cast<std::uint32_t>(changes_.size());
    changes_.clear();
    if (first_change_ > renumber_changes) {
      first_change_ = 1;
      for (Body& body : bodies) body.last_change = 0;
    }
    for (const int body : remote_changed_) {
      News& news = news_[body];
      news.assumed.clear();
      news.told.clear();
      news.applied = 0;
    }
    remote_changed_.clear();
    from_.resize(bodies.size(), nowhere);
    news_.resize(bodies.size());
    own_changed_.clear();
    pending_ = {};
    until_ = ahead_ = -never;
  }

  /// Runs to the time `until` with the updates that are assumed.
  void run_window(double until) {
    until_ = until;
    while (overrun_.first < 0) {
      while (!pending_.empty() && !is_pending(pending_.top())) pending_.pop();
      const Calendar::Entry next = calendar_.next();
      const bool update = !pending_.empty() && pending_.top().key.time <= until &&
                          !(key(next) < pending_.top().key);
      if (update)
        apply_update(pending_.top().body);
      else if (next.time <= until)
        advance(next.body);
      else
        return;
    }
  }

  /// The window is over: takes what was undone out of the events.
  void end_window() {
    if (!any_undone_) return;
    any_undone_ = false;
    events.erase(
        std::remove_if(events.begin(), events.end(), [](const Event& e) { return e.i < 0; }),
        events.end());
  }

  /// Own bodies that are shared whose updates in this window are others than at the last call.
  std::vector<int> take_changed_bodies() {
    std::sort(own_changed_.begin(), own_changed_.end());
    own_changed_.erase(std::unique(own_changed_.begin(), own_changed_.end()), own_changed_.end());
    return std::exchange(own_changed_, {});
  }

  /// Sets `all` to the updates of a body in this window, in order.
  void find_updates(int body, std::vector<RemoteUpdate>& all) const {
    all.clear();
    FreeFlight flight = flights[body];
    Course course = bodies[body].course;
    for (int n = last_change(body); n >= 0;) {
      const Change& change = changes_[n];
      const Past& past = change.of(body);
      all.push_back({change.key, change.past[0].body == body ? change.partner : change.past[0].body,
                     flight, course});
      flight = past.flight;
      course = past.course;
      n = past.previous;
    }
    std::reverse(all.begin(), all.end());
  }

  /// The list, empty and to be filled in order, of what the owner of a remote body says that it
  /// does in this window, apart from events with bodies of this process.
  std::vector<RemoteUpdate>& tell(int body) {
    remote_changed_.push_back(body);
    news_[body].told.clear();
    return news_[body].told;
  }

  /// The time and the depth of the first difference between what was told and what is assumed.
  struct Difference {
    double time = never;
    int depth = 0;
    bool operator<(const Difference& b) const {
      return time != b.time ? time < b.time : depth < b.depth;
    }
  };
  Difference first_difference() {
    std::sort(remote_changed_.begin(), remote_changed_.end());
    remote_changed_.erase(std::unique(remote_changed_.begin(), remote_changed_.end()),
                          remote_changed_.end());
    Difference first;
    for (const int body : remote_changed_) {
      const News& news = news_[body];
      const std::size_t n = news.agreed();
      for (const std::vector<RemoteUpdate>* list : {&news.assumed, &news.told})
        if (n < list->size()) {
          const EventKey& key = (*list)[n].key;
          first = std::min(first, Difference{key.time, key.causal_depth});
        }
    }
    return first;
  }

  /// Assumes what was told, and undoes what does not agree with it. `first`: the first difference
  /// of all processes. Of its instant nothing that follows from it is taken yet: two processes
  /// could hand each other a chain of events of one instant without end, each the cause of the
  /// other's next.
  void assume_what_was_told(const Difference& first) {
    ahead_ = until_;
    for (const int body : remote_changed_) {
      std::vector<RemoteUpdate>& assumed = news_[body].assumed;
      const std::vector<RemoteUpdate>& told = news_[body].told;
      const std::size_t n = news_[body].agreed();
      if (n == assumed.size() && n == told.size()) continue;
      EventKey key = n < assumed.size() ? assumed[n].key : told[n].key;
      if (n < told.size() && told[n].key < key) key = told[n].key;
      undo_from(body, key);
      assumed.resize(n);
      for (std::size_t k = n; k < told.size(); k++) {
        if (told[k].key.time == first.time && told[k].key.causal_depth > first.depth) break;
        assumed.push_back(told[k]);
      }
      await_next_update(body);
    }
    settle();
  }

 protected:
  /// Who is a neighbour from here on can have gone on, too.
  void after_renewal(int body, double now) override {
    if (alone) return;
    look_ahead(body, {now, -1, 0, 0});
    settle();
  }

  double found_since(double now) const override { return alone ? now : window_start_; }

  bool has_been_home(int body) const override {
    if (alone) return true;
    const FreeFlight* flight = &flights[body];
    for (int n = last_change(body);; n = changes_[n].of(body).previous) {
      const double begin = std::max(flight->since, window_start_);
      if (!neighbourhoods_.is_home(body, flight->at(begin), begin)) return false;
      if (n < 0) return true;
      flight = &changes_[n].of(body).flight;
    }
  }

  void before_event(const Event& event) override {
    if (alone) return;
    Change& change = changes_.emplace_back();
    change.key = event.key;
    change.event = static_cast<int>(events.size()) - 1;
    change.partner = event.j;
    note(change.past[0], event.i);
    if (!event.with_wall()) note(change.past[1], event.j);
  }

  void after_event(const Event& event) override {
    if (alone) return;
    const int i = event.i, j = event.j;
    const EventKey key = event.key;
    if (key.time > ahead_) return;
    // Who flies on as before has its home where it has come to, but can meet who is put back.
    stay_at_home(i, key.time);
    if (j >= 0) stay_at_home(j, key.time);
    look_ahead(i, key);
    if (j >= 0) look_ahead(j, key);
    settle();
  }

 private:
  /// Behind all places in the order.
  static constexpr EventKey nowhere{never, 0, 0, 0};
  /// Changes are counted anew from here on: half of the numbers that a body can have, so that none
  /// comes round.
  static constexpr std::uint32_t renumber_changes = 1u << 31;

  struct Past {  // of a body before a change
    int body = -1;
    int previous = -1;  // change
    FreeFlight flight;
    Course course;
  };
  /// An event, or an update of a remote body.
  struct Change {
    EventKey key;
    int event = -1;    // index into events; -1: an update
    int partner = -1;  // of past[0].body
    Past past[2];

    const Past& of(int body) const { return past[past[0].body == body ? 0 : 1]; }
  };
  /// Of a remote body in this window.
  struct News {
    std::vector<RemoteUpdate> assumed, told;
    std::size_t applied = 0;  // how many of those assumed

    /// How many are assumed as they were told.
    std::size_t agreed() const {
      std::size_t n = 0;
      while (n < assumed.size() && n < told.size() && same(assumed[n], told[n])) n++;
      return n;
    }
  };
  struct Pending {
    EventKey key;
    int body;
    std::size_t number;  // in News::assumed
    bool operator<(const Pending& b) const { return b.key < key; }
  };

  /// The last change of a body in this window; -1: none.
  int last_change(int body) const {
    const std::uint32_t n = bodies[body].last_change - first_change_;
    return n < changes_.size() ? static_cast<int>(n) : -1;
  }
  void set_last_change(int body, int n) {
    bodies[body].last_change = n < 0 ? 0 : first_change_ + static_cast<std::uint32_t>(n);
  }

  /// Of the last of changes_, before it happens.
  void note(Past& past, int body) {
    past = {body, last_change(body), flights[body], bodies[body].course};
    set_last_change(body, static_cast<int>(changes_.size()) - 1);
    note_changed(body);
  }

  void note_changed(int body) {
    if (!bodies[body].remote && bodies[body].shared) own_changed_.push_back(body);
  }

  bool is_pending(const Pending& p) const {
    const News& news = news_[p.body];
    return p.number == news.applied && p.number < news.assumed.size() &&
           same(p.key, news.assumed[p.number].key);
  }

  /// The next update of a remote body that is assumed and not applied yet, if any, gets its turn.
  void await_next_update(int body) {
    const News& news = news_[body];
    if (news.applied < news.assumed.size())
      pending_.push({news.assumed[news.applied].key, body, news.applied});
  }

  void apply_update(int body) {
    News& news = news_[body];
    const RemoteUpdate& update = news.assumed[news.applied];
    Change& change = changes_.emplace_back();
    change.key = update.key;
    note(change.past[0], body);
    set_flight(body, update.flight, update.course);
    news.applied++;
    pending_.pop();
    await_next_update(body);
    stay_at_home(body, update.key.time);
    look_ahead(body, update.key);
    settle();
    predict(body);
  }

  void stay_at_home(int body, double time) {
    if (!neighbourhoods_.is_home(body, flights[body].at(time), time)) renew_home(body, time);
  }

  /// Undoes what a body did from a place in the order on.
  void undo_from(int body, const EventKey& key) {
    int first = -1;
    for (int n = last_change(body); n >= 0 && !(changes_[n].key < key);
         n = changes_[n].of(body).previous)
      first = n;
    if (first >= 0) undo(first);
  }

  /// Undoes a change, after all that followed from it.
  void undo(int n) {
    std::vector<int> stack{n};
    while (!stack.empty()) {
      const int top = stack.back();
      const Change& change = changes_[top];
      bool last = true;
      for (const Past& past : change.past)
        if (past.body >= 0 && last_change(past.body) != top) {
          stack.push_back(last_change(past.body));
          last = false;
          break;
        }
      if (!last) continue;
      stack.pop_back();
      undo_last(change);
    }
  }

  /// Undoes a change that is the last one of its bodies.
  void undo_last(const Change& change) {
    overrun_ = {-1, -1};
    for (const Past& past : change.past) {
      if (past.body < 0) continue;
      set_flight(past.body, past.flight, past.course);
      set_last_change(past.body, past.previous);
      note_changed(past.body);
      from_[past.body] = std::min(from_[past.body], change.key);
      touched_.push_back(past.body);
    }
    for (const Past& past : change.past)
      if (past.body >= 0) stay_at_home(past.body, change.key.time);
    if (change.event < 0) {
      const int body = change.past[0].body;
      news_[body].applied--;
      await_next_update(body);
      return;
    }
    Event& event = events[change.event];
    // Former neighbours stay in the lists until the window is over.
    Neighbour& pair = *neighbourhoods_.find_neighbour(event.i, event.j, event.image);
    neighbourhoods_.set_inside(event.i, pair, event.was_inside);
    event.i = -1;
    any_undone_ = true;
  }

  /// Looks for those who meet a body on its flight from a place in the order on, but have gone on
  /// since then, and undoes what they did after that.
  void look_ahead(int body, const EventKey& from) {
    if (from.time > ahead_) return;
    meets_.clear();
    for (const Neighbour* n = neighbourhoods_.begin(body); n != neighbourhoods_.end(body); n++) {
      if (n->is_wall() || flights[n->body].since < from.time) continue;
      const int first = first_meeting(body, *n, from);
      if (first >= 0) meets_.push_back(first);
    }
    for (const int change : meets_)
      if (is_done(change)) undo(change);
  }

  bool is_done(int n) const {
    const Past& past = changes_[n].past[0];
    for (int k = last_change(past.body); k >= n; k = changes_[k].of(past.body).previous)
      if (k == n) return true;
    return false;
  }

  /// The first change of a neighbour, from a place in the order on, before which it meets a body;
  /// -1: none.
  int first_meeting(int body, const Neighbour& neighbour, const EventKey& from) const {
    const FreeFlight& a = flights[body];
    const Tags both = tags(body, neighbour.body);
    int first = -1;
    for (int n = last_change(neighbour.body); n >= 0 && from < changes_[n].key;) {
      const Past& past = changes_[n].of(neighbour.body);
      const FreeFlight& b = past.flight;
      const double begin = std::max({from.time, a.since, b.since});
      const auto [r, w] = relative_motion(a, b, neighbour.image, begin);
      const double vv = std::max(dot(a.velocity, a.velocity), dot(b.velocity, b.velocity));
      const Crossing next =
          next_crossing(r, w, vv, surfaces(body, neighbour.body), neighbour.inside);
      const double time = begin + next.wait;
      const int of_a = causal_depth_at(time, body), of_b = causal_depth_at(time, b, past.course);
      const EventKey key{time, 1 + std::max(of_a, of_b), both.i, both.j};
      if (key < changes_[n].key) first = n;
      n = past.previous;
    }
    return first;
  }

  /// Predicts the events of all that were put back, after having looked for those who meet them.
  void settle() {
    for (std::size_t n = 0; n < touched_.size(); n++) {
      const int body = touched_[n];
      const EventKey from = std::exchange(from_[body], nowhere);
      if (from < nowhere) look_ahead(body, from);
    }
    for (const int body : touched_) predict(body);
    touched_.clear();
  }

  double window_start_ = 0.0;
  std::vector<Change> changes_;  // of this window
  // Changes are numbered through all windows: what is below the first one of this window is over.
  std::uint32_t first_change_ = 1;  // number of changes_[0]
  std::vector<int> own_changed_, remote_changed_;
  std::vector<News> news_;  // by body
  std::priority_queue<Pending> pending_;
  double until_ = -never;  // the end of the window, once it has been run
  double ahead_ =
      -never;  // until when bodies can have gone on of which others are put back, [time]
  std::vector<int> touched_;    // put back, and not looked after yet
  std::vector<EventKey> from_;  // from where on a body is put back
  std::vector<int> meets_;
  bool any_undone_ = false;
};

}  // namespace cohesion::hard_sphere
