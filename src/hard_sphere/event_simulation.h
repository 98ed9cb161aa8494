// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "hard_sphere/concave_wall.h"
#include "hard_sphere/event_predictor.h"
#include "hard_sphere/event_rules.h"

namespace cohesion::hard_sphere {

/// Event-driven simulation of bodies in free flight: B. J. Alder, T. E. Wainwright, J. Chem. Phys.
/// 31 (1959) 459. Events are executed in the order of their keys.
///
/// Flights and predictions remain valid over several steps of the engine, until an event or the
/// engine changes them. After an event only the events of its two bodies are predicted again.
///
/// Times are relative to the last reset_time() or shift_time_origin().
class EventSimulation : public EventPredictor {
 public:
  virtual ~EventSimulation() = default;

  EventRules rules;
  std::vector<Event> events;  ///< executed in this step

  /// Sets the time to 0, and the box. To be called before set_up().
  void reset_time(const PeriodicBox& box) {
    box_ = box;
    start_ = end_ = 0.0;
  }

  /// Finds the neighbours of all bodies and predicts all events. Bodies, flights, rules and walls
  /// have to be set before. `lifetime`: NeighbourLists::build(). A pair is in its well if it is
  /// closer than the edge. A pair at the edge, to round-off, is in its well if the sorted list
  /// `inside` contains it.
  void set_up(double lifetime, const std::vector<TagPair>& inside) {
    overrun_ = {-1, -1};
    neighbour_lists_.build(box_, bodies, flights, pairs, walls, end_, lifetime);
    for (int i = 0; i < count(); i++) set_well_flags(i, inside);
    predict_all();
  }

  /// Renumbers the bodies between two steps, with their flights and predictions. Body n had the
  /// number old[n] before; a negative entry is a new body; bodies that are absent are removed. The
  /// caller sets the properties and flights of new bodies and then calls add_bodies().
  void renumber(const std::vector<int>& old) {
    const BodyRenumbering renumbering(old, bodies.size());
    neighbour_lists_.renumber(renumbering, end_);
    renumber_predictions(renumbering);
  }

  /// Finds neighbours, wells and events of the new bodies of renumber(), as set_up() does. Returns
  /// false if that is impossible; the caller then calls set_up().
  bool add_bodies(const std::vector<int>& added, const std::vector<TagPair>& inside) {
    for (const int i : added)
      if (!neighbour_lists_.add(i, flights[i], end_)) return false;
    for (const int i : added) set_well_flags(i, inside);
    for (const int i : added) predict(i);
    return true;
  }

  /// Shifts the time origin to the end of the last step, since times far from it lose digits.
  /// Flights start there.
  void shift_time_origin() {
    const double now = end_;
    for (int i = 0; i < count(); i++) {
      VersionedFlight& flight = flights[i];
      if (flight.start_time != now) bodies[i].event_state.causal_depth = -1;
      flight.position = flight.at(now);
      flight.start_time = 0.0;
      flight.version++;
    }
    box_.edges = box_.edges_at(now);
    for (HardWall& wall : walls) wall.motion.when -= now;
    neighbour_lists_.shift_time_origin(now);
    start_ = end_ = 0.0;
    predict_all();
  }

  /// The bound pairs at the edges of their wells, sorted: their distances alone do not show whether
  /// they are bound.
  std::vector<TagPair> bound_pairs_at_edge() const {
    std::vector<int> all(bodies.size());
    std::iota(all.begin(), all.end(), 0);
    return bound_pairs_at_edge(all);
  }
  /// The same for the pairs of selected bodies.
  std::vector<TagPair> bound_pairs_at_edge(const std::vector<int>& selected) const {
    std::vector<TagPair> found;
    for (const int i : selected)
      for (const Neighbour* n = neighbour_lists_.begin(i); n != neighbour_lists_.end(i); n++)
        if (n->inside && excess_over_edge(i, *n) >= -edge_round_off)
          found.push_back(tag_pair(i, n->body));
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Begins a step of the engine of length `dt` [time].
  void begin_step(double dt) {
    start_ = end_;
    end_ += dt;
    step_++;
    events.clear();
  }
  double start() const { return start_; }
  double end() const { return end_; }
  const PeriodicBox& box() const { return box_; }

  /// Sets a flight that the engine has changed at the beginning of the step. `relocated`: the
  /// engine has relocated the body, which enters and leaves wells without events. The caller then
  /// calls predict(), after all bodies have their flights.
  void change_flight(int body, const FreeFlight& flight, const EventState& event_state,
                     bool relocated) {
    set_flight(body, flight, event_state);
    const Vector3 position = flight.at(start_);
    if (relocated || !neighbour_lists_.neighbourhood_contains(body, position, start_))
      neighbour_lists_.renew(body, flights[body], start_, start_, [] { return true; });
    if (!relocated) return;
    for (Neighbour* n = neighbour_lists_.begin(body); n != neighbour_lists_.end(body); n++)
      if (n->has_well)
        neighbour_lists_.set_inside(body, *n,
                                    distance(body, *n, start_) < surfaces(body, n->body).edge);
  }

  /// Executes the events up to the time `until`.
  void run(double until) {
    while (event_queue_.next().time <= until && overrun_.first < 0)
      process_next(event_queue_.next().body);
  }

  /// A body with more events in a step than the limit, and the partner of the last event; -1: none.
  /// run() stops there.
  const std::pair<int, int>& overrun() const { return overrun_; }

  /// The state of a body, with its counters reset if they belong to a previous step.
  EventState& state_in_step(int body) {
    EventState& event_state = bodies[body].event_state;
    if (event_state.step != step_) {
      event_state.step = step_;
      event_state.collisions = event_state.events = 0;
      event_state.last_collision = -never;
    }
    return event_state;
  }

  /// Calls f(i, neighbour) for each own body i and each neighbour, once for pairs of own bodies.
  template <class F>
  void for_each_pair(const F& f) const {
    for (int i = 0; i < count(); i++) {
      if (bodies[i].remote) continue;
      for (const Neighbour* n = neighbour_lists_.begin(i); n != neighbour_lists_.end(i); n++)
        if (n->body < i || bodies[n->body].remote) f(i, *n);
    }
  }

  double bytes() const {
    return neighbour_lists_.bytes() + event_queue_.bytes() +
           static_cast<double>(
               (sizeof(HardSphere) + sizeof(VersionedFlight) + sizeof(PredictedEvents)) *
               bodies.size());
  }

 protected:
  /// Hooks of an event: before it changes the flights of its bodies, and before the next events of
  /// these are predicted.
  virtual void before_event(const Event& /*event*/) {}
  virtual void after_event(const Event& /*event*/) {}
  /// Hook: a body has a new bounding neighbourhood on its flight; its next events have not been
  /// predicted.
  virtual void after_renewal(int /*body*/, double /*now*/) {}
  /// The time from which on searches must find bodies at their previous positions.
  virtual double search_start(double now) const { return now; }
  /// Whether the new neighbourhood of a body contains its flight since search_start().
  virtual bool stayed_in_neighbourhood(int /*body*/) const { return true; }

  /// Sets the flags of a body and its neighbours for their wells, as set_up() does.
  void set_well_flags(int i, const std::vector<TagPair>& inside) {
    for (Neighbour* n = neighbour_lists_.begin(i); n != neighbour_lists_.end(i); n++) {
      if (!n->has_well) continue;
      const double over = excess_over_edge(i, *n);
      const bool is_inside =
          over < -edge_round_off ||
          (over <= edge_round_off &&
           std::binary_search(inside.begin(), inside.end(), tag_pair(i, n->body)));
      neighbour_lists_.set_inside(i, *n, is_inside);
    }
  }

  /// Processes the first item of a body: executes its event, drops a stale one, or predicts again.
  void process_next(int i) {
    PredictedEvents& list = predicted_[i];
    if (list.empty()) {
      const double now = list.horizon();
      if (now >= neighbour_lists_.exit_time(i, flights[i])) {
        renew_neighbours(i, now);
        after_renewal(i, now);
      }
      predict(i);
    } else if (is_stale(list.front())) {
      list.pop();
      schedule(i);
    } else {
      execute(i, list.front());
    }
  }

  void set_flight(int body, const FreeFlight& flight, const EventState& event_state) {
    static_cast<FreeFlight&>(flights[body]) = flight;
    flights[body].version++;
    bodies[body].event_state = event_state;
  }

  void renew_neighbours(int body, double now) {
    neighbour_lists_.renew(body, flights[body], now, search_start(now),
                           [this, body] { return stayed_in_neighbourhood(body); });
  }

  std::pair<int, int> overrun_{-1, -1};

 private:
  // Relative distance from the edge below which round-off decides on which side of it a pair is.
  static constexpr double edge_round_off = 1e-10;

  /// Relative distance of a neighbour beyond the edge of its well, [1].
  double excess_over_edge(int i, const Neighbour& n) const {
    return distance(i, n, end_) / surfaces(i, n.body).edge - 1.0;
  }

  static CollisionPartner collision_partner(const HardSphere& body, const VersionedFlight& flight) {
    return {flight.velocity, body.event_state.spin, body.inverse_mass, body.inverse_inertia,
            body.radius};
  }

  /// Arguments of compute_impact() for a body and a neighbour.
  struct ImpactInput {
    Vector3 separation;        // from the body to the neighbour, [length]
    CollisionPartner partner;  // the neighbour
    ImpactLaw law;
  };
  ImpactInput impact_input(int i, const Neighbour& n, double time) const {
    if (n.is_wall()) {
      const HardWall& wall = walls[n.wall()];
      const auto point = wall.motion.wall.nearest(flights[i].at(time), wall.motion.at(time),
                                                  wall.motion.rim_speed);
      return {point.separation, {point.velocity, {}, 0.0, 0.0, 0.0}, wall.law(bodies[i])};
    }
    CollisionPartner partner = collision_partner(bodies[n.body], flights[n.body]);
    partner.velocity += neighbour_lists_.image(n.image).velocity;
    return {relative_motion(i, n.body, n.image, time).first, partner,
            pairs.law(bodies[i], bodies[n.body])};
  }

  void execute(int body, const PredictedEvent predicted) {
    const EventKey when = event_key(body, predicted);
    const double time = predicted.time;
    int i = body, j = predicted.partner, image = predicted.image;
    if (j >= 0 && bodies[j].tag < bodies[i].tag) {
      std::swap(i, j);
      image = neighbour_lists_.image(image).opposite;
    }
    Neighbour& pair = *neighbour_lists_.find_neighbour(i, j, image);
    const EventState& state_i = state_in_step(i);
    const EventState* const state_j = j < 0 ? nullptr : &state_in_step(j);

    auto [separation, partner, law] = impact_input(i, pair, time);
    const double distance = norm(separation);
    const Vector3 k{separation.x / distance, separation.y / distance, separation.z / distance};
    const bool is_collision = predicted.surface == Surface::core;
    const MinimumSeparationSpeeds least =
        law.conserves_energy() ? MinimumSeparationSpeeds{} : minimum_speeds(i, j, law.depth);
    const bool elastic = is_collision && (rules.is_made_elastic(state_i, time) ||
                                          (state_j && rules.is_made_elastic(*state_j, time)));
    if (elastic) law.restitution = 1.0, law.friction = 0.0;
    ImpactOutcome outcome = compute_impact(
        predicted.surface, k, law, collision_partner(bodies[i], flights[i]), partner, least);
    if (elastic && j < 0) reflect_off_concave_wall(i, pair, k, outcome);
    if (outcome.kind == EventKind::capture && j >= 0)
      return_within_edge(i, j, partner, k, distance, least, outcome);

    events.push_back({when, i, j, image, elastic, pair.inside, distance, separation,
                      flights[i].at(time), outcome});
    before_event(events.back());
    neighbour_lists_.set_inside(i, pair, outcome.inside);
    apply_impulse(i, -1.0, outcome, when, is_collision);
    if (j >= 0) apply_impulse(j, 1.0, outcome, when, is_collision);
    after_event(events.back());
    predict(i);
    if (j >= 0) predict(j, i, neighbour_lists_.image(image).opposite);
    if (std::max(state_i.events, state_j ? state_j->events : 0) > rules.event_limit)
      overrun_ = {i, j};
  }

  /// Rotates the velocity after an elastic collision of the rule against collapse so that the body
  /// leaves a cylinder for minimum_time_off_wall().
  void reflect_off_concave_wall(int i, const Neighbour& pair, const Vector3& k,
                                ImpactOutcome& outcome) const {
    const Wall& wall = walls[pair.wall()].motion.wall;
    if (wall.shape != Wall::z_cylinder) return;
    const HardSphere& body = bodies[i];
    const Vector3& before = flights[i].velocity;
    const Vector3 after = velocity_off_concave_wall(before - body.inverse_mass * outcome.impulse, k,
                                                    wall.position - surfaces(i, pair.body).core,
                                                    minimum_time_off_wall());
    outcome.impulse = (1.0 / body.inverse_mass) * (before - after);
    outcome.normal_impulse = dot(k, outcome.impulse);
  }

  /// Rotates the relative velocity after a capture so that the pair returns within the edge, and by
  /// the rule of rest.
  void return_within_edge(int i, int j, const CollisionPartner& partner, const Vector3& k,
                          double distance, const MinimumSeparationSpeeds& least,
                          ImpactOutcome& outcome) const {
    const double b = bodies[i].inverse_mass + partner.inverse_mass;
    const Vector3 before = partner.velocity - flights[i].velocity,
                  after = before + b * outcome.impulse;
    const SurfaceDistances at = surfaces(i, j);
    const Vector3 returning = velocity_within_edge(
        after, k, distance, at.edge,
        std::min(least.energy_limited, rules.inward_speed_at_edge(norm(after), at)));
    if (same(returning, after)) return;
    outcome.impulse = (1.0 / b) * (returning - before);
    outcome.normal_impulse = dot(k, outcome.impulse);
  }

  /// Least time between an elastic collision with a concave wall and the next one, [time].
  double minimum_time_off_wall() const {
    return std::max(rules.contact_time,
                    rules.collapse_limit > 0 ? (end_ - start_) / rules.collapse_limit : 0.0);
  }

  /// The least speeds of separation by the rule of rest. `depth`: of the well of the pair,
  /// [energy].
  MinimumSeparationSpeeds minimum_speeds(int i, int j, double depth) const {
    MinimumSeparationSpeeds least;
    least.energy_adding =
        rules.energy_adding_speed(bodies[i].speed_increment, bodies[i].event_state);
    double inverse_mass = bodies[i].inverse_mass;
    int collisions = bodies[i].event_state.collisions;
    if (j >= 0) {
      least.energy_adding =
          std::max(least.energy_adding,
                   rules.energy_adding_speed(bodies[j].speed_increment, bodies[j].event_state));
      inverse_mass += bodies[j].inverse_mass;
      collisions = std::max(collisions, bodies[j].event_state.collisions);
    }
    if (depth == 0.0) depth = least_well_depth(bodies[i], j < 0 ? bodies[i] : bodies[j]);
    least.energy_limited = rules.energy_limited_speed(depth, inverse_mass, collisions);
    return least;
  }

  /// The least depth of the wells that two bodies have with any others, [energy]; 0: none. Such
  /// wells can press two bodies together that have no well with each other.
  double least_well_depth(const HardSphere& a, const HardSphere& b) const {
    double depth = std::min(pairs.least_well_depth(a), pairs.least_well_depth(b));
    for (const HardWall& wall : walls)
      for (const HardSphere* body : {&a, &b}) {
        const double wall_depth = wall.acts_on(*body) ? wall.law(*body).depth : 0.0;
        if (wall_depth > 0.0) depth = std::min(depth, wall_depth);
      }
    return depth < never ? depth : 0.0;
  }

  void apply_impulse(int body, double side, const ImpactOutcome& outcome, const EventKey& when,
                     bool is_collision) {
    HardSphere& b = bodies[body];
    VersionedFlight& flight = flights[body];
    flight.position = flight.at(when.time);
    flight.velocity += (side * b.inverse_mass) * outcome.impulse;
    flight.start_time = when.time;
    flight.version++;
    EventState& event_state = b.event_state;
    event_state.spin -= (b.radius * b.inverse_inertia) * outcome.spin_impulse;
    event_state.causal_depth = when.causal_depth;
    event_state.collisions += is_collision;
    if (is_collision) event_state.last_collision = when.time;
    event_state.events++;
  }

  PeriodicBox box_;
  double start_ = 0.0, end_ = 0.0;  // of the step
  int step_ = 0;
};

}  // namespace cohesion::hard_sphere
