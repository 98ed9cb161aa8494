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

/// Bodies in free flight, what will happen between them, and what of that comes first.
///
/// Each body knows its next few events with its neighbours (predicted_events.h); the calendar knows
/// whose comes first. What a body has predicted with another that has changed its flight since then
/// is stale: it is known by the version of the flight that it is true for.
///
/// A prediction depends on nothing but the flights of its two bodies and whether they are in their
/// well: it starts from the later of their last changes. So it is the same, bit by bit, wherever
/// and whenever it is made.
class EventPredictor {
 public:
  std::vector<HardSphere> bodies;
  std::vector<VersionedFlight> flights;  ///< of the bodies
  PairRules pairs;
  std::vector<HardWall> walls;

  using TagPair = hard_sphere::TagPair;

  NeighbourLists& neighbour_lists() { return neighbour_lists_; }
  const NeighbourLists& neighbour_lists() const { return neighbour_lists_; }

  /// Predicts the events of a body.
  void predict(int i) { predict(i, i, 0); }

  /// Predicts the events of all bodies that may meet a wall that moves, whose motion is another one
  /// in each step.
  void predict_at_moving_walls() {
    if (std::none_of(walls.begin(), walls.end(), [](const HardWall& w) { return w.moves; })) return;
    for (int i = 0; i < count(); i++)
      if (std::any_of(neighbour_lists_.begin(i), neighbour_lists_.end(i),
                      [this](const Neighbour& n) { return n.is_wall() && walls[n.wall()].moves; }))
        predict(i);
  }

  /// Of a body and a partner, or -1 - number of a wall.
  SurfaceDistances surfaces(int i, int partner) const {
    return partner < 0 ? walls[-1 - partner].surfaces(bodies[i])
                       : pairs.surfaces(bodies[i], bodies[partner]);
  }

  /// Distance of a body and a neighbour at a time, [length].
  double distance(int i, const Neighbour& n, double time) const {
    if (!n.is_wall()) return norm(relative_motion(i, n.body, n.image, time).first);
    const MovingWall& wall = walls[n.wall()].motion;
    return wall.wall.nearest(flights[i].at(time), wall.at(time), 0.0).distance;
  }

  /// Position and velocity of j as seen from i, the same numbers but for the sign as those of i as
  /// seen from j.
  std::pair<Vector3, Vector3> relative_motion(int i, int j, int image, double time) const {
    return relative_motion(flights[i], flights[j], image, time);
  }

 protected:
  ~EventPredictor() = default;

  int count() const { return static_cast<int>(bodies.size()); }

  /// Predicts the events of all bodies and begins a new calendar.
  void predict_all() {
    predicted_.resize(bodies.size());
    event_queue_.reset(bodies.size());
    for (int i = 0; i < count(); i++) predict(i);
  }

  /// Gives bodies other numbers, and their flights and what they predict:
  /// EventSimulation::arrange().
  void renumber_predictions(const BodyRenumbering& renumbering) {
    std::vector<int> affected;  // with another number or with partners that have another one
    for (int i = 0; i < count(); i++) {
      if (renumbering.is_unchanged(i) && predicted_[i].keeps_partners(renumbering)) continue;
      // Before numbers change, by which entries of the same time are in order.
      event_queue_.set({never, i, -1, -1}, EarlierKey{*this}, [](int, std::size_t) {});
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

  /// Predicts the events of a body but those with one partner.
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

  /// Enters what is next for a body in the calendar.
  void schedule(int body) {
    const PredictedEvents& list = predicted_[body];
    QueuedEvent event;
    event.time = list.next_time();
    event.body = body;
    if (!list.empty()) {
      event.partner = list.front().partner;
      event.depth = event_key(body, list.front()).causal_depth;
    }
    event_queue_.set(event, EarlierKey{*this},
                     [this](int comes, std::size_t subtrees) { prefetch_turn(comes, subtrees); });
  }

  bool is_stale(const PredictedEvent& event) const {
    return event.partner >= 0 && flights[event.partner].version != event.version;
  }

  /// relative_motion() on other flights than those that they have now.
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
    const int of_i = causal_depth_at(event.time, i);
    const int of_j = event.partner < 0 ? -1 : causal_depth_at(event.time, event.partner);
    return {event.time, 1 + std::max(of_i, of_j), tag_i, tag_j};
  }

  /// That of an entry of the calendar. What has to be predicted again goes first of all at its
  /// time, since it may hide what comes before others.
  EventKey event_key(const QueuedEvent& event) const {
    if (event.depth < 0) return {event.time, -1, 0, 0};
    const auto [tag_i, tag_j] = tag_pair(event.body, event.partner);
    return {event.time, event.depth, tag_i, tag_j};
  }

  /// The depth of the chain of events of an instant that led to a flight; -1: none did.
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
  /// The order of entries of the calendar of the same time.
  struct EarlierKey {
    const EventPredictor& predictions;
    bool operator()(const QueuedEvent& a, const QueuedEvent& b) const {
      return predictions.event_key(a) < predictions.event_key(b);
    }
  };

  /// Asks for the memory that the turn of a body will read, a turn that is one of about the next
  /// `parts`. Who comes next is anywhere in the box, so that nearly all of it is in no cache. It
  /// hangs together in a chain: what is predicted names the partner, lists name the neighbours. A
  /// link is asked for when the one before has had time to come.
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
  /// The body of the next event; below 0: none.
  int next_partner(int i) const {
    return predicted_[i].empty() ? -1 : predicted_[i].front().partner;
  }

  /// Finds which neighbours of a body it may meet before `horizon`, without roots and without
  /// branches that depend on it; returns how many, their numbers are in near_.
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
