// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "hard_sphere/event_queue.h"
#include "hard_sphere/neighbour_lists.h"
#include "hard_sphere/predicted_events.h"
#include "prefetch.h"

namespace cohesion::hard_sphere {

/// Bodies in free flight and the predictions of their events.
///
/// Each body stores its next few events with its neighbours (predicted_events.h), and the event
/// queue orders the bodies by the first of them. A predicted event is stale if the partner has
/// changed its flight since; the version of the partner's flight shows that.
///
/// A prediction depends only on the flights of both bodies and on whether they are in their well.
/// It starts from the later of the last changes of both. So its value is the same, bit by bit, on
/// each process and at each time of prediction.
class EventPredictor {
 public:
  std::vector<HardSphere> bodies;
  std::vector<VersionedFlight> flights;  ///< by body
  PairRules pairs;
  std::vector<HardWall> walls;

  NeighbourLists& neighbour_lists() { return neighbour_lists_; }
  const NeighbourLists& neighbour_lists() const { return neighbour_lists_; }

  /// Predicts the events of a body.
  void predict(int i) { predict(i, i, 0); }

  /// Predicts the events of all bodies that may meet a moving wall, whose velocity can
  /// change in each step.
  void predict_at_moving_walls() {
    if (std::none_of(walls.begin(), walls.end(), [](const HardWall& w) { return w.moves; })) return;
    for (int i = 0; i < count(); i++)
      if (std::any_of(neighbour_lists_.begin(i), neighbour_lists_.end(i),
                      [this](const Neighbour& n) { return n.is_wall() && walls[n.wall()].moves; }))
        predict(i);
  }

  /// Surfaces of a body and a partner, or -1 - number of a wall.
  SurfaceDistances surfaces(int i, int partner) const {
    return partner < 0 ? walls[-1 - partner].surfaces(bodies[i])
                       : pairs.surfaces(bodies[i], bodies[partner]);
  }

  /// Distance between a body and a neighbour at a time, [length].
  double distance(int i, const Neighbour& n, double time) const {
    if (!n.is_wall()) return norm(relative_motion(i, n.body, n.image, time).first);
    const MovingWall& wall = walls[n.wall()].motion;
    return wall.wall.nearest(flights[i].at(time), wall.at(time), 0.0).distance;
  }

  /// Position and velocity of j relative to i. Swapping i and j reverses the sign and changes no
  /// bit.
  std::pair<Vector3, Vector3> relative_motion(int i, int j, int image, double time) const {
    return relative_motion(flights[i], flights[j], image, time);
  }

 protected:
  ~EventPredictor() = default;

  int count() const { return static_cast<int>(bodies.size()); }

  /// Predicts the events of all bodies and rebuilds the event queue.
  void predict_all() {
    predicted_.resize(bodies.size());
    event_queue_.reset(bodies.size());
    for (int i = 0; i < count(); i++) predict(i);
  }

  /// Renumbers bodies with their flights and predictions: EventSimulation::renumber().
  void renumber_predictions(const BodyRenumbering& renumbering) {
    std::vector<int> affected;  // bodies with a new number or with partners that have a new number
    for (int i = 0; i < count(); i++) {
      if (renumbering.is_unchanged(i) && predicted_[i].keeps_partners(renumbering)) continue;
      // Before the renumbering, which changes the keys that resolve ties in the queue.
      event_queue_.replace({never, i, -1, -1}, EarlierKey{*this}, [](int, std::size_t) {});
      if (renumbering.new_number(i) >= 0) affected.push_back(renumbering.new_number(i));
    }
    renumbering.reorder(bodies);
    renumbering.reorder(flights);
    renumbering.reorder(predicted_);
    const bool has_capacity = event_queue_.reserve(bodies.size());
    for (const int n : affected)
      if (predicted_[n].renumber(renumbering))
        schedule(n);
      else
        predict(n);
    for (int n = 0; !has_capacity && n < count(); n++)
      if (renumbering.old_number(n) >= 0) schedule(n);
  }

  /// Predicts the events of a body except those with one partner.
  void predict(int i, int excluded_partner, int excluded_image) {
    const VersionedFlight& a = flights[i];
    PredictedEvents& list = predicted_[i];
    list.reset(neighbour_lists_.exit_time(i, a));
    const double aa = dot(a.velocity, a.velocity);
    const auto before = [this, i](const PredictedEvent& x, const PredictedEvent& y) {
      return event_key(i, x) < event_key(i, y);
    };
    const int near = find_candidates(i, list.horizon());
    const Neighbour* const row = neighbour_lists_.begin(i);
    for (int k = 0; k < near; k++) {
      const Neighbour& n = row[candidates_[k]];
      if (n.is_wall()) {
        const Crossing next = next_crossing(walls[n.wall()].motion, a.position, a.velocity,
                                            a.start_time, surfaces(i, n.body), n.inside);
        if (next.wait < never)
          list.add({a.start_time + next.wait, n.body, 0, 0, next.surface}, before);
        continue;
      }
      if (n.body == excluded_partner && n.image == excluded_image) continue;
      const VersionedFlight& b = flights[n.body];
      const double now = std::max(a.start_time, b.start_time);
      const auto [r, w] = relative_motion(i, n.body, n.image, now);
      const Crossing next = next_crossing(r, w, std::max(aa, dot(b.velocity, b.velocity)),
                                          surfaces(i, n.body), n.inside);
      if (next.wait < never)
        list.add({now + next.wait, n.body, b.version, n.image, next.surface}, before);
    }
    schedule(i);
  }

  /// Enters the next event of a body in the queue.
  void schedule(int body) {
    const PredictedEvents& list = predicted_[body];
    QueuedEvent event;
    event.time = list.next_time();
    event.body = body;
    if (!list.empty()) {
      event.partner = list.front().partner;
      event.depth = event_key(body, list.front()).causal_depth;
    }
    event_queue_.replace(event, EarlierKey{*this}, [this](int leader, std::size_t subtrees) {
      prefetch_turn(leader, subtrees);
    });
  }

  bool is_stale(const PredictedEvent& event) const {
    return event.partner >= 0 && flights[event.partner].version != event.version;
  }

  /// Relative position and velocity of two arbitrary flights.
  std::pair<Vector3, Vector3> relative_motion(const FreeFlight& i, const FreeFlight& j, int image,
                                              double time) const {
    Vector3 r = j.at(time) - i.at(time), w = j.velocity - i.velocity;
    if (image != 0) {
      const PeriodicImage& shift = neighbour_lists_.image(image);
      r += shift.displacement_at(time);
      w += shift.velocity;
    }
    return {r, w};
  }

  TagPair tag_pair(int i, int partner) const {
    const std::int64_t tag = bodies[i].tag;
    if (partner < 0) return {tag, partner};
    const std::int64_t other = bodies[partner].tag;
    return {std::min(tag, other), std::max(tag, other)};
  }

  EventKey event_key(int i, const PredictedEvent& event) const {
    const auto [tag_i, tag_j] = tag_pair(i, event.partner);
    const int depth_i = causal_depth_at(event.time, i);
    const int depth_j = event.partner < 0 ? -1 : causal_depth_at(event.time, event.partner);
    return {event.time, 1 + std::max(depth_i, depth_j), tag_i, tag_j};
  }

  /// Key of a queued event. Bodies without a valid prediction precede all others of the same time,
  /// since their next event may be earlier than those of the others.
  EventKey event_key(const QueuedEvent& event) const {
    if (event.depth < 0) return {event.time, -1, 0, 0};
    const auto [tag_i, tag_j] = tag_pair(event.body, event.partner);
    return {event.time, event.depth, tag_i, tag_j};
  }

  /// EventKey::causal_depth of the event that led to a flight if that was at this instant; -1
  /// otherwise.
  static int causal_depth_at(double time, const FreeFlight& flight, const EventState& event_state) {
    return flight.start_time == time ? event_state.causal_depth : -1;
  }
  int causal_depth_at(double time, int body) const {
    return causal_depth_at(time, flights[body], bodies[body].event_state);
  }

  std::vector<PredictedEvents> predicted_;
  EventQueue event_queue_;
  NeighbourLists neighbour_lists_;

 private:
  /// Order of queued events of the same time.
  struct EarlierKey {
    const EventPredictor& predictions;
    bool operator()(const QueuedEvent& a, const QueuedEvent& b) const {
      return predictions.event_key(a) < predictions.event_key(b);
    }
  };

  /// Prefetches the memory for the next event of a body that is among about the next `subtrees`
  /// ones of the queue. Successive events are far apart in the box, so that their data are in no
  /// cache. The data form a chain: the predictions contain the partner, the lists contain the
  /// neighbours. Each link is prefetched when the previous one has had time to arrive.
  void prefetch_turn(int i, std::size_t subtrees) const {
    switch (subtrees) {
      case 64:
        return prefetch_body(i);
      case 16:
        neighbour_lists_.prefetch_list(i);
        if (next_partner(i) >= 0) prefetch_body(next_partner(i));
        return;
      case 8:
        prefetch_neighbours(i);
        if (next_partner(i) >= 0) neighbour_lists_.prefetch_list(next_partner(i));
        return;
      case 2:
        if (next_partner(i) >= 0) prefetch_neighbours(next_partner(i));
        return;
      default:
        return;
    }
  }
  void prefetch_body(int i) const {
    prefetch(predicted_[i]);
    prefetch(flights[i]);
    prefetch(bodies[i]);
    neighbour_lists_.prefetch_body(i);
  }
  void prefetch_neighbours(int i) const {
    for (const Neighbour* n = neighbour_lists_.begin(i); n != neighbour_lists_.end(i); n++)
      if (!n->is_wall()) prefetch(flights[n->body]);
  }
  /// The partner in the next event of a body; negative: none, or a wall.
  int next_partner(int i) const {
    return predicted_[i].empty() ? -1 : predicted_[i].front().partner;
  }

  /// Sets candidates_ to the indices of the neighbours that a body may meet before `horizon`, and
  /// returns their number. The loop has no square roots and no branches that depend on the result.
  int find_candidates(int i, double horizon) {
    const VersionedFlight a = flights[i];
    const Neighbour* const row = neighbour_lists_.begin(i);
    const int size = static_cast<int>(neighbour_lists_.end(i) - row);
    if (size > static_cast<int>(candidates_.size())) candidates_.resize(2 * size);
    int near = 0;
    for (int k = 0; k < size; k++) {
      const Neighbour& n = row[k];
      candidates_[near] = k;
      if (n.is_wall()) {
        near++;
        continue;
      }
      const double now = std::max(a.start_time, flights[n.body].start_time);
      const auto [r, w] = relative_motion(i, n.body, n.image, now);
      near += may_cross_within(horizon - now, dot(r, w), dot(w, w), dot(r, r), n.rounded_surfaces(),
                               n.inside);
    }
    return near;
  }

  std::vector<int> candidates_;
};

}  // namespace cohesion::hard_sphere
