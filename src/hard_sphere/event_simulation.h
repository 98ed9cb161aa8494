// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hard_sphere/bodies.h"
#include "hard_sphere/concave_wall.h"
#include "hard_sphere/event_rules.h"

namespace cohesion::hard_sphere {

/// Event-driven simulation of one step of free flight: B. J. Alder, T. E. Wainwright, J. Chem.
/// Phys. 31 (1959) 459. The events are executed in order of time.
///
/// The event queue, a heap, holds the next event of every candidate pair that has one in the step.
/// After an event only the candidates of its particles are predicted again; the predictions that
/// these replace stay in the queue and are known by their version.
///
/// A prediction depends on nothing but the candidate and the flights of its two bodies: it starts
/// from the later of their last events. So it is the same, bit by bit, wherever and whenever it is
/// made.
///
/// Other processes may simulate some of the bodies at the same time. The simulation is then an
/// optimistic parallel one with rollback, Time Warp in rounds: D. R. Jefferson, Virtual Time, ACM
/// Trans. Program. Lang. Syst. 7 (1985) 404. Each process runs ahead through a window of the step
/// with the updates that it has received, and saves each flight that it changes. In each round the
/// processes exchange their updates. Where those that come differ from those that a process has
/// assumed, it rolls back to the first difference and runs on with them; as the whole lists are
/// compared, there are no antimessages. The first difference of all processes is Jefferson's global
/// virtual time: no process will roll back behind it, since every event before it has been worked
/// out from what truly went before. So the order of events is that of one process, and every round
/// brings it at least one event farther.
class EventSimulation {
 private:
  struct PredictedEvent {
    double time;
    int candidate;
    unsigned version;
    int causal_depth;
  };

  /// A flight before an event or an update changed it: what a rollback restores.
  struct SavedFlight {
    double time;
    int body;
    Flight before;
  };

  /// The order of the queue.
  struct Later {
    const EventSimulation& simulation;
    bool operator()(const PredictedEvent& a, const PredictedEvent& b) const {
      return a.time != b.time ? a.time > b.time : simulation.key(b) < simulation.key(a);
    }
  };

 public:
  std::vector<Body> bodies;
  std::vector<CandidatePair> candidates;
  std::vector<Image> images{Image{}};
  std::vector<Law> laws;
  std::vector<MovingWall> walls;
  EventRules rules;

  std::vector<Event> events;           ///< of this step, in order
  std::vector<RemoteUpdate> outgoing;  ///< of this window, with rules.distributed
  /// Of this window, in order: those from other processes that this run assumes.
  std::vector<RemoteUpdate> received;

  /// Finds the candidates of each body, after bodies and candidates have been set.
  void index_candidates() {
    first_.assign(bodies.size() + 1, 0);
    for (const CandidatePair& b : candidates) {
      first_[b.i + 1]++;
      if (!b.with_wall()) first_[b.j + 1]++;
    }
    for (std::size_t i = 1; i < first_.size(); i++) first_[i] += first_[i - 1];
    of_body_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (int n = 0; n < static_cast<int>(candidates.size()); n++) {
      of_body_[next[candidates[n].i]++] = n;
      if (!candidates[n].with_wall()) of_body_[next[candidates[n].j]++] = n;
    }
  }

  /// The number of the candidate of two bodies; -1: none. After index_candidates().
  int find(int i, int j, int image) const {
    for (int n = first_[i]; n < first_[i + 1]; n++) {
      const CandidatePair& b = candidates[of_body_[n]];
      if (b.i == i && b.j == j && b.image == image) return of_body_[n];
    }
    return -1;
  }

  /// Empties the queue, before the bodies' flights of a step of length `dt` [time] are set.
  void begin_step(double dt) {
    dt_ = dt;
    queue_.clear();
    events.clear();
    overrun_ = -1;
    begin_window();
  }

  /// Adds the first event of candidate n, when it has one in this step, at the end of the queue,
  /// which is not in order then; returns whether it has one.
  bool predict(int n) {
    CandidatePair& candidate = candidates[n];
    candidate.version++;
    const double time = time_of_next(candidate);
    if (!(time <= dt_)) return false;
    queue_.push_back({time, n, candidate.version, causal_depth(candidate, time)});
    return true;
  }

  double dt() const { return dt_; }

  /// Distance of the partners of candidate n when the step began, [length].
  double distance_at_start(int n) const {
    const CandidatePair& candidate = candidates[n];
    if (candidate.with_wall()) {
      const MovingWall& wall = walls[candidate.wall()];
      return wall.wall.nearest(bodies[candidate.i].flight.at(dt_), wall.at(dt_), 0.0).distance;
    }
    return norm(relative_motion(candidate, dt_).first);
  }

  /// Whether the partners of candidate n, a pair without events so far, come nearer to a surface
  /// than the fraction `tolerance` [1] of its distance: for flights that are known to round-off
  /// only.
  bool may_meet(int n, double tolerance) const {
    const CandidatePair& candidate = candidates[n];
    const auto [r, w] = relative_motion(candidate, 0.0);
    const double ww = dot(w, w), b = dot(r, w);
    const double back = ww * dt_ > b && b > 0.0 ? b / ww : b > 0.0 ? dt_ : 0.0;
    const double least = norm(r - back * w);
    if (!candidate.inside)
      return least < (1.0 + tolerance) * (candidate.surfaces.has_well() ? candidate.surfaces.edge
                                                                        : candidate.surfaces.core);
    return least < (1.0 + tolerance) * candidate.surfaces.core ||
           std::max(norm(r), norm(r - dt_ * w)) > (1.0 - tolerance) * candidate.surfaces.edge;
  }

  /// Brings the queue into order after predictions in any order.
  void order_queue() { std::make_heap(queue_.begin(), queue_.end(), Later{*this}); }

  void begin_window() {
    saved_flights_.clear();
    outgoing.clear();
    received.clear();
    processed_ = 0;
    window_start_ = events.size();
  }

  /// Executes the events and applies the received updates up to the time `until`.
  void run(double until) {
    while (overrun_ < 0) {
      while (!queue_.empty() &&
             queue_.front().version != candidates[queue_.front().candidate].version)
        pop();
      const bool own = !queue_.empty() && queue_.front().time <= until;
      if (processed_ < received.size() &&
          !(own && key(queue_.front()) < received[processed_].key)) {
        apply_update(received[processed_++]);
      } else if (own) {
        const PredictedEvent next = queue_.front();
        pop();
        execute(next.candidate, key(next));
      } else {
        return;
      }
    }
  }

  /// Runs the window again from the time `from` on, with the updates of `incoming` from there on.
  void rollback_and_run(double from, const std::vector<RemoteUpdate>& incoming, double until) {
    rollback(from);
    received.resize(processed_);
    for (const RemoteUpdate& u : incoming)
      if (u.key.time >= from) received.push_back(u);
    run(until);
  }

  /// The time, from `from` on, of the first update in which `incoming` differs from what this run
  /// has assumed; never: none.
  double first_difference(double from, const std::vector<RemoteUpdate>& incoming) const {
    auto known = received.begin() + first_update(received, from);
    for (const RemoteUpdate& u : incoming) {
      if (u.key.time < from) continue;
      if (known == received.end()) return u.key.time;
      if (!(u == *known)) return std::min(u.key.time, known->key.time);
      ++known;
    }
    return known == received.end() ? never : known->key.time;
  }

  /// A candidate of a body with more events than the limit; -1: none. run() stops there.
  int overrun() const { return overrun_; }

 private:
  EventKey key(const PredictedEvent& p) const {
    const CandidatePair& candidate = candidates[p.candidate];
    return {p.time, p.causal_depth, bodies[candidate.i].tag,
            candidate.with_wall() ? candidate.j : bodies[candidate.j].tag};
  }

  int causal_depth(const CandidatePair& candidate, double time) const {
    const int of_i = bodies[candidate.i].flight.causal_depth_at(time);
    return 1 + (candidate.with_wall()
                    ? of_i
                    : std::max(of_i, bodies[candidate.j].flight.causal_depth_at(time)));
  }

  void pop() {
    std::pop_heap(queue_.begin(), queue_.end(), Later{*this});
    queue_.pop_back();
  }

  double time_of_next(CandidatePair& candidate) const {
    const Flight& a = bodies[candidate.i].flight;
    Crossing crossing;
    double now = a.last_event;
    if (candidate.with_wall()) {
      crossing = next_crossing(walls[candidate.wall()], a.at(dt_ - now), a.velocity, dt_ - now,
                               candidate.surfaces, candidate.inside);
    } else {
      const Flight& b = bodies[candidate.j].flight;
      now = std::max(now, b.last_event);
      const auto [r, w] = relative_motion(candidate, dt_ - now);
      const double vv = std::max(dot(a.velocity, a.velocity), dot(b.velocity, b.velocity));
      crossing = next_crossing(r, w, vv, candidate.surfaces, candidate.inside);
    }
    candidate.next_surface = crossing.surface;
    return now + crossing.wait;
  }

  void predict_all(int body, int but = -1) {
    for (int n = first_[body]; n < first_[body + 1]; n++)
      if (of_body_[n] != but && predict(of_body_[n]))
        std::push_heap(queue_.begin(), queue_.end(), Later{*this});
  }

  static std::ptrdiff_t first_update(const std::vector<RemoteUpdate>& all, double from) {
    return std::find_if(all.begin(), all.end(),
                        [from](const RemoteUpdate& u) { return u.key.time >= from; }) -
           all.begin();
  }

  /// Undoes what this window has executed and applied from a time on.
  void rollback(double from) {
    overrun_ = -1;
    for (; events.size() > window_start_ && events.back().key.time >= from; events.pop_back())
      candidates[events.back().candidate].inside = events.back().was_inside;
    while (!outgoing.empty() && outgoing.back().key.time >= from) outgoing.pop_back();
    processed_ = std::min(processed_, static_cast<std::size_t>(first_update(received, from)));
    std::vector<int> touched;
    for (; !saved_flights_.empty() && saved_flights_.back().time >= from;
         saved_flights_.pop_back()) {
      bodies[saved_flights_.back().body].flight = saved_flights_.back().before;
      touched.push_back(saved_flights_.back().body);
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const int body : touched) predict_all(body);
  }

  void save_flight(int body, double time) {
    if (rules.distributed) saved_flights_.push_back({time, body, bodies[body].flight});
  }

  void apply_update(const RemoteUpdate& incoming) {
    save_flight(incoming.body, incoming.key.time);
    bodies[incoming.body].flight = incoming.flight;
    predict_all(incoming.body);
  }

  /// Position and velocity of j as seen from i. Prediction and event use the same numbers: they
  /// must not differ about which way a pair goes.
  std::pair<Vector3, Vector3> relative_motion(const CandidatePair& candidate, double left) const {
    const Flight &a = bodies[candidate.i].flight, &b = bodies[candidate.j].flight;
    const Image& image = images[candidate.image];
    const Vector3 w = b.velocity + image.velocity - a.velocity;
    return {b.end - a.end + image.displacement - left * w, w};
  }

  /// Where j is as seen from i, and its state.
  std::pair<Vector3, Partner> partner_of_i(const CandidatePair& candidate, double left) const {
    if (candidate.with_wall()) {
      const MovingWall& wall = walls[candidate.wall()];
      const auto point =
          wall.wall.nearest(bodies[candidate.i].flight.at(left), wall.at(left), wall.rim_speed);
      return {point.separation, {point.velocity, {}, 0.0, 0.0, 0.0}};
    }
    Partner partner = bodies[candidate.j].partner();
    partner.velocity += images[candidate.image].velocity;
    return {relative_motion(candidate, left).first, partner};
  }

  void execute(int n, const EventKey& when) {
    CandidatePair& candidate = candidates[n];
    const double left = dt_ - when.time;
    const auto [separation, partner] = partner_of_i(candidate, left);
    const double distance = norm(separation);
    const Vector3 k{separation.x / distance, separation.y / distance, separation.z / distance};
    Law law = laws[candidate.law];
    const bool is_collision = candidate.next_surface == Surface::core;
    const bool elastic = is_collision && (made_elastic(candidate.i, when.time) ||
                                          made_elastic(candidate.j, when.time));
    if (elastic) law.restitution = 1.0, law.friction = 0.0;
    Impact now = impact(candidate.next_surface, k, law, bodies[candidate.i].partner(), partner,
                        rest_speed(candidate));
    if (elastic && candidate.with_wall()) keep_off_concave_wall(candidate, k, now);

    events.push_back({when, n, elastic, candidate.inside, distance, separation,
                      bodies[candidate.i].flight.at(left), now});
    candidate.inside = now.inside;
    apply_impulse(candidate.i, candidate.j, -1.0, now, when, is_collision);
    if (!candidate.with_wall())
      apply_impulse(candidate.j, candidate.i, 1.0, now, when, is_collision);
    predict_all(candidate.i);
    if (!candidate.with_wall()) predict_all(candidate.j, n);
    if (most_events(candidate) > rules.limit) overrun_ = n;
  }

  /// Turns an elastic collision of the rule against collapse so that it leaves a cylinder for
  /// time_off_wall().
  void keep_off_concave_wall(const CandidatePair& candidate, const Vector3& k, Impact& now) const {
    const Wall& wall = walls[candidate.wall()].wall;
    if (wall.shape != Wall::z_cylinder) return;
    const Body& body = bodies[candidate.i];
    const Vector3& before = body.flight.velocity;
    const Vector3 after =
        leaving_concave_wall(before - body.inverse_mass * now.on_j, k,
                             wall.position - candidate.surfaces.core, time_off_wall());
    now.on_j = (1.0 / body.inverse_mass) * (before - after);
    now.normal = dot(k, now.on_j);
  }

  /// How long an elastic collision keeps a particle off a concave wall, [time].
  double time_off_wall() const {
    return std::max(rules.contact_time, rules.collapse > 0 ? dt_ / rules.collapse : 0.0);
  }

  bool made_elastic(int body, double time) const {
    return body >= 0 && rules.make_elastic(bodies[body].flight, time);
  }

  /// The least speed with which a collision parts its partners, by the rule of rest, [length/time].
  double rest_speed(const CandidatePair& candidate) const {
    if (laws[candidate.law].takes_nothing()) return 0.0;
    const double of_i = rules.rest_speed(bodies[candidate.i].flight);
    return candidate.with_wall() ? of_i
                                 : std::max(of_i, rules.rest_speed(bodies[candidate.j].flight));
  }

  int most_events(const CandidatePair& candidate) const {
    const int of_i = bodies[candidate.i].flight.events;
    return candidate.with_wall() ? of_i : std::max(of_i, bodies[candidate.j].flight.events);
  }

  void apply_impulse(int body, int partner, double side, const Impact& now, const EventKey& when,
                     bool is_collision) {
    save_flight(body, when.time);
    Body& b = bodies[body];
    const Vector3 change = (side * b.inverse_mass) * now.on_j;
    b.flight.velocity += change;
    b.flight.end += (dt_ - when.time) * change;
    b.flight.spin -= (b.radius * b.inverse_inertia) * now.twist;
    b.flight.last_event = when.time;
    b.flight.causal_depth = when.causal_depth;
    b.flight.collisions += is_collision;
    if (is_collision) b.flight.last_collision = when.time;
    b.flight.events++;
    if (rules.distributed) outgoing.push_back({when, body, partner, b.flight});
  }

  double dt_ = 0.0;
  std::vector<int> first_,
      of_body_;  // candidates of body i: of_body_[first_[i]] ... [first_[i + 1] - 1]
  std::vector<PredictedEvent> queue_;
  std::vector<SavedFlight> saved_flights_;  // of this window, with rules.distributed
  std::size_t processed_ = 0;               // received updates that have been applied
  std::size_t window_start_ = 0;            // of the window, in `events`
  int overrun_ = -1;
};

}  // namespace cohesion::hard_sphere
