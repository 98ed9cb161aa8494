// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "hard_sphere/calendar.h"
#include "hard_sphere/neighbourhoods.h"
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
class Predictions {
 public:
  std::vector<Body> bodies;
  std::vector<Flight> flights;  ///< of the bodies
  PairRules pairs;
  std::vector<HardWall> walls;

  using Tags = hard_sphere::Tags;

  Neighbourhoods& neighbourhoods() { return neighbourhoods_; }
  const Neighbourhoods& neighbourhoods() const { return neighbourhoods_; }

  /// Predicts the events of a body.
  void predict(int i) { predict(i, i, 0); }

  /// Predicts the events of all bodies that may meet a wall that moves, whose motion is another one
  /// in each step.
  void predict_at_moving_walls() {
    if (std::none_of(walls.begin(), walls.end(), [](const HardWall& w) { return w.moves; })) return;
    for (int i = 0; i < count(); i++)
      if (std::any_of(neighbourhoods_.begin(i), neighbourhoods_.end(i),
                      [this](const Neighbour& n) { return n.is_wall() && walls[n.wall()].moves; }))
        predict(i);
  }

  /// Of a body and a partner, or -1 - number of a wall.
  Surfaces surfaces(int i, int partner) const {
    return partner < 0 ? walls[-1 - partner].surfaces(bodies[i])
                       : pairs.surfaces(bodies[i], bodies[partner]);
  }

  /// Distance of a body and a neighbour at a time, [length].
  double distance(int i, const Neighbour& n, double time) const {
    if (!n.is_wall()) return norm(relative_motion(i, n.body, n.image, time).first);
    const MovingWall& wall = walls[n.wall()].moving;
    return wall.wall.nearest(flights[i].at(time), wall.at(time), 0.0).distance;
  }

  /// Position and velocity of j as seen from i, the same numbers but for the sign as those of i as
  /// seen from j.
  std::pair<Vector3, Vector3> relative_motion(int i, int j, int image, double time) const {
    return relative_motion(flights[i], flights[j], image, time);
  }

 protected:
  ~Predictions() = default;

  int count() const { return static_cast<int>(bodies.size()); }

  /// Predicts the events of all bodies and begins a new calendar.
  void predict_all() {
    predicted_.resize(bodies.size());
    calendar_.reset(bodies.size());
    for (int i = 0; i < count(); i++) predict(i);
  }

  /// Gives bodies other numbers, and their flights and what they predict:
  /// EventSimulation::arrange().
  void arrange_predictions(const Renumbering& to) {
    std::vector<int> concerned;  // with another number or with partners that have another one
    for (int i = 0; i < count(); i++) {
      if (to.keeps(i) && predicted_[i].keep_partners(to)) continue;
      // Before numbers change, by which entries of the same time are in order.
      calendar_.set({never, i, -1, -1}, Before{*this}, [](int, std::size_t) {});
      if (to.now(i) >= 0) concerned.push_back(to.now(i));
    }
    to.apply(bodies);
    to.apply(flights);
    to.apply(predicted_);
    const bool room = calendar_.make_room(bodies.size());
    for (const int n : concerned)
      if (predicted_[n].renumber(to))
        enter(n);
      else
        predict(n);
    for (int n = 0; !room && n < count(); n++)
      if (to.old(n) >= 0) enter(n);
  }

  /// Predicts the events of a body but those with one partner.
  void predict(int i, int but, int but_image) {
    const Flight& a = flights[i];
    PredictedEvents& list = predicted_[i];
    list.begin(neighbourhoods_.leave_time(i, a));
    const double aa = dot(a.velocity, a.velocity);
    const auto before = [this, i](const PredictedEvent& x, const PredictedEvent& y) {
      return key(i, x) < key(i, y);
    };
    const int near = find_near(i, list.horizon());
    const Neighbour* const row = neighbourhoods_.begin(i);
    for (int k = 0; k < near; k++) {
      const Neighbour& n = row[near_[k]];
      if (n.is_wall()) {
        const Crossing next = next_crossing(walls[n.wall()].moving, a.place, a.velocity, a.since,
                                            surfaces(i, n.body), n.inside);
        if (next.wait < never) list.add({a.since + next.wait, n.body, 0, 0, next.surface}, before);
        continue;
      }
      if (n.body == but && n.image == but_image) continue;
      const Flight& b = flights[n.body];
      const double now = std::max(a.since, b.since);
      const auto [r, w] = relative_motion(i, n.body, n.image, now);
      const Crossing next = next_crossing(r, w, std::max(aa, dot(b.velocity, b.velocity)),
                                          surfaces(i, n.body), n.inside);
      if (next.wait < never)
        list.add({now + next.wait, n.body, b.version, n.image, next.surface}, before);
    }
    enter(i);
  }

  /// Enters what is next for a body in the calendar.
  void enter(int body) {
    const PredictedEvents& list = predicted_[body];
    Calendar::Entry entry;
    entry.time = list.next_time();
    entry.body = body;
    if (!list.empty()) {
      entry.partner = list.front().partner;
      entry.depth = key(body, list.front()).causal_depth;
    }
    calendar_.set(entry, Before{*this},
                  [this](int comes, std::size_t parts) { foresee(comes, parts); });
  }

  bool is_stale(const PredictedEvent& event) const {
    return event.partner >= 0 && flights[event.partner].version != event.version;
  }

  /// relative_motion() on other flights than those that they have now.
  std::pair<Vector3, Vector3> relative_motion(const FreeFlight& i, const FreeFlight& j, int image,
                                              double time) const {
    Vector3 r = j.at(time) - i.at(time), w = j.velocity - i.velocity;
    if (image != 0) {
      const Image& shift = neighbourhoods_.image(image);
      r += shift.at(time);
      w += shift.velocity;
    }
    return {r, w};
  }

  Tags tags(int i, int partner) const {
    const std::int64_t tag = bodies[i].tag;
    if (partner < 0) return {tag, partner};
    const std::int64_t other = bodies[partner].tag;
    return {std::min(tag, other), std::max(tag, other)};
  }

  EventKey key(int i, const PredictedEvent& event) const {
    const auto [tag_i, tag_j] = tags(i, event.partner);
    const int of_i = causal_depth_at(event.time, i);
    const int of_j = event.partner < 0 ? -1 : causal_depth_at(event.time, event.partner);
    return {event.time, 1 + std::max(of_i, of_j), tag_i, tag_j};
  }

  /// That of an entry of the calendar. What has to be predicted again goes first of all at its
  /// time, since it may hide what comes before others.
  EventKey key(const Calendar::Entry& entry) const {
    if (entry.depth < 0) return {entry.time, -1, 0, 0};
    const auto [tag_i, tag_j] = tags(entry.body, entry.partner);
    return {entry.time, entry.depth, tag_i, tag_j};
  }

  /// The depth of the chain of events of an instant that led to a flight; -1: none did.
  static int causal_depth_at(double time, const FreeFlight& flight, const Course& course) {
    return flight.since == time ? course.causal_depth : -1;
  }
  int causal_depth_at(double time, int body) const {
    return causal_depth_at(time, flights[body], bodies[body].course);
  }

  std::vector<PredictedEvents> predicted_;
  Calendar calendar_;
  Neighbourhoods neighbourhoods_;

 private:
  /// The order of entries of the calendar of the same time.
  struct Before {
    const Predictions& predictions;
    bool operator()(const Calendar::Entry& a, const Calendar::Entry& b) const {
      return predictions.key(a) < predictions.key(b);
    }
  };

  /// Asks for the memory that the turn of a body will read, a turn that is one of about the next
  /// `parts`. Who comes next is anywhere in the box, so that nearly all of it is in no cache. It
  /// hangs together in a chain: what is predicted names the partner, lists name the neighbours. A
  /// link is asked for when the one before has had time to come.
  void foresee(int i, std::size_t parts) const {
    switch (parts) {
      case 64:
        return foresee_body(i);
      case 16:
        neighbourhoods_.foresee_list(i);
        if (partner_of_next(i) >= 0) foresee_body(partner_of_next(i));
        return;
      case 8:
        foresee_neighbours(i);
        if (partner_of_next(i) >= 0) neighbourhoods_.foresee_list(partner_of_next(i));
        return;
      case 2:
        if (partner_of_next(i) >= 0) foresee_neighbours(partner_of_next(i));
        return;
      default:
        return;
    }
  }
  void foresee_body(int i) const {
    prefetch(predicted_[i]);
    prefetch(flights[i]);
    prefetch(bodies[i]);
    neighbourhoods_.foresee_body(i);
  }
  void foresee_neighbours(int i) const {
    for (const Neighbour* n = neighbourhoods_.begin(i); n != neighbourhoods_.end(i); n++)
      if (!n->is_wall()) prefetch(flights[n->body]);
  }
  /// The body of the next event; below 0: none.
  int partner_of_next(int i) const {
    return predicted_[i].empty() ? -1 : predicted_[i].front().partner;
  }

  /// Finds which neighbours of a body it may meet before `horizon`, without roots and without
  /// branches that depend on it; returns how many, their numbers are in near_.
  int find_near(int i, double horizon) {
    const Flight a = flights[i];
    const Neighbour* const row = neighbourhoods_.begin(i);
    const int size = static_cast<int>(neighbourhoods_.end(i) - row);
    if (size > static_cast<int>(near_.size())) near_.resize(2 * size);
    int near = 0;
    for (int k = 0; k < size; k++) {
      const Neighbour& n = row[k];
      near_[near] = k;
      if (n.is_wall()) {
        near++;
        continue;
      }
      const double now = std::max(a.since, flights[n.body].since);
      const auto [r, w] = relative_motion(i, n.body, n.image, now);
      near += may_meet_within(horizon - now, dot(r, w), dot(w, w), dot(r, r), n.rounded_surfaces(),
                              n.inside);
    }
    return near;
  }

  std::vector<int> near_;
};

}  // namespace cohesion::hard_sphere
