// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "hard_sphere/concave_wall.h"
#include "hard_sphere/event_rules.h"
#include "hard_sphere/predictions.h"

namespace cohesion::hard_sphere {

/// Event-driven simulation of bodies in free flight: B. J. Alder, T. E. Wainwright, J. Chem. Phys.
/// 31 (1959) 459. The events are executed in order of time.
///
/// Flights and predictions last until something changes them, however many steps of an engine that
/// takes. After an event only the events of its two bodies are predicted again.
///
/// Times count from start_clock().
class EventSimulation : public Predictions {
 public:
  virtual ~EventSimulation() = default;

  EventRules rules;
  std::vector<Event> events;  ///< of this step

  /// The time is 0 from here on, and the box as given. Before set_up().
  void start_clock(const PeriodicBox& box) {
    box_ = box;
    start_ = end_ = 0.0;
  }

  /// Finds the neighbours of all bodies and predicts all events, after bodies, flights, rules or
  /// walls have been set. `lifetime`: Neighbourhoods::build(). A pair is in its well if it is
  /// nearer than the edge; one at the edge, to round-off, if it is among `inside`, which is in
  /// order.
  void set_up(double lifetime, const std::vector<Tags>& inside) {
    overrun_ = {-1, -1};
    neighbourhoods_.build(box_, bodies, flights, pairs, walls, end_, lifetime);
    for (int i = 0; i < count(); i++) find_wells(i, inside);
    predict_all();
  }

  /// Arranges the bodies anew, between two steps: body n is the one that was old[n], with all that
  /// it has and predicts, or a new one where that is below 0. Those that are not there are gone.
  /// The matter and flights of new ones have to be set, and take_in() has to follow.
  void arrange(const std::vector<int>& old) {
    const Renumbering to(old, bodies.size());
    neighbourhoods_.arrange(to, end_);
    arrange_predictions(to);
  }

  /// Finds neighbours, wells and events of the bodies that arrange() has made, as set_up() does;
  /// false: that cannot be done, and set_up() has to follow.
  bool take_in(const std::vector<int>& added, const std::vector<Tags>& inside) {
    for (const int i : added)
      if (!neighbourhoods_.add(i, flights[i], end_)) return false;
    for (const int i : added) find_wells(i, inside);
    for (const int i : added) predict(i);
    return true;
  }

  /// Time 0 is at the end of the last step from here on: what is far from it has fewer digits. A
  /// flight goes on from where it is then.
  void set_clock_back() {
    const double now = end_;
    for (int i = 0; i < count(); i++) {
      Flight& flight = flights[i];
      if (flight.since != now) bodies[i].course.causal_depth = -1;
      flight.place = flight.at(now);
      flight.since = 0.0;
      flight.version++;
    }
    box_.edges = box_.at(now);
    for (HardWall& wall : walls) wall.moving.when -= now;
    neighbourhoods_.set_clock_back(now);
    start_ = end_ = 0.0;
    predict_all();
  }

  /// The pairs in their wells and at the edge, in order: what set_up() cannot see.
  std::vector<Tags> inside_at_edge() const {
    std::vector<int> all(bodies.size());
    std::iota(all.begin(), all.end(), 0);
    return inside_at_edge(all);
  }
  /// Those of some bodies.
  std::vector<Tags> inside_at_edge(const std::vector<int>& of) const {
    std::vector<Tags> found;
    for (const int i : of)
      for (const Neighbour* n = neighbourhoods_.begin(i); n != neighbourhoods_.end(i); n++)
        if (n->inside && over_edge(i, *n) >= -at_edge) found.push_back(tags(i, n->body));
    std::sort(found.begin(), found.end());
    return found;
  }

  /// The next step of the engine begins, of length `dt` [time].
  void begin_step(double dt) {
    start_ = end_;
    end_ += dt;
    step_++;
    events.clear();
  }
  double start() const { return start_; }
  double end() const { return end_; }
  const PeriodicBox& box() const { return box_; }

  /// A body that others have given another flight since the beginning of the step. `moved`: it has
  /// been put elsewhere, and wells that it is in or not in are no events. predict() has to follow,
  /// after all bodies have their flights.
  void change_flight(int body, const FreeFlight& flight, const Course& course, bool moved) {
    set_flight(body, flight, course);
    const Vector3 place = flight.at(start_);
    if (moved || !neighbourhoods_.is_home(body, place, start_))
      neighbourhoods_.renew(body, flights[body], start_, start_, [] { return true; });
    if (!moved) return;
    for (Neighbour* n = neighbourhoods_.begin(body); n != neighbourhoods_.end(body); n++)
      if (n->has_well)
        neighbourhoods_.set_inside(body, *n,
                                   distance(body, *n, start_) < surfaces(body, n->body).edge);
  }

  /// Executes the events up to the time `until`.
  void run(double until) {
    while (calendar_.next().time <= until && overrun_.first < 0) advance(calendar_.next().body);
  }

  /// A body with more events in a step than the limit, and its partner in the last of them; -1:
  /// none. run() stops there.
  const std::pair<int, int>& overrun() const { return overrun_; }

  /// How the events of a body in this step are counted.
  Course& course_of(int body) {
    Course& course = bodies[body].course;
    if (course.step != step_) {
      course.step = step_;
      course.collisions = course.events = 0;
      course.last_collision = -never;
    }
    return course;
  }

  /// Calls f(i, neighbour) for each body i of this process and neighbour, pairs of two of them
  /// once.
  template <class F>
  void for_each_pair(const F& f) const {
    for (int i = 0; i < count(); i++) {
      if (bodies[i].remote) continue;
      for (const Neighbour* n = neighbourhoods_.begin(i); n != neighbourhoods_.end(i); n++)
        if (n->body < i || bodies[n->body].remote) f(i, *n);
    }
  }

  double bytes() const {
    return neighbourhoods_.bytes() + calendar_.bytes() +
           static_cast<double>((sizeof(Body) + sizeof(Flight) + sizeof(PredictedEvents)) *
                               bodies.size());
  }

 protected:
  /// Called before an event changes the flights of its bodies, and after that, before their next
  /// events are predicted.
  virtual void before_event(const Event& /*event*/) {}
  virtual void after_event(const Event& /*event*/) {}
  /// Called when a body has come to a new home on its flight, before its next events are predicted.
  virtual void after_renewal(int /*body*/, double /*now*/) {}
  /// From when on bodies must be found where they were.
  virtual double found_since(double now) const { return now; }
  /// Whether the home of a body is one since then.
  virtual bool has_been_home(int /*body*/) const { return true; }

  /// Sets whether a body and its neighbours are in their wells, as set_up() does.
  void find_wells(int i, const std::vector<Tags>& inside) {
    for (Neighbour* n = neighbourhoods_.begin(i); n != neighbourhoods_.end(i); n++) {
      if (!n->has_well) continue;
      const double over = over_edge(i, *n);
      const bool is_inside =
          over < -at_edge ||
          (over <= at_edge && std::binary_search(inside.begin(), inside.end(), tags(i, n->body)));
      neighbourhoods_.set_inside(i, *n, is_inside);
    }
  }

  /// Does what comes first for a body, when its turn has come: an event, or what it has to predict
  /// again.
  void advance(int i) {
    PredictedEvents& list = predicted_[i];
    if (list.empty()) {
      const double now = list.horizon();
      if (now >= neighbourhoods_.leave_time(i, flights[i])) {
        renew_home(i, now);
        after_renewal(i, now);
      }
      predict(i);
    } else if (is_stale(list.front())) {
      list.pop();
      enter(i);
    } else {
      execute(i, list.front());
    }
  }

  void set_flight(int body, const FreeFlight& flight, const Course& course) {
    static_cast<FreeFlight&>(flights[body]) = flight;
    flights[body].version++;
    bodies[body].course = course;
  }

  void renew_home(int body, double now) {
    neighbourhoods_.renew(body, flights[body], now, found_since(now),
                          [this, body] { return has_been_home(body); });
  }

  std::pair<int, int> overrun_{-1, -1};

 private:
  // A pair nearer to the edge of its well than this fraction of it is at the edge, to round-off.
  static constexpr double at_edge = 1e-10;

  /// How far a neighbour is outside of the edge of its well now, as a fraction of that, [1].
  double over_edge(int i, const Neighbour& n) const {
    return distance(i, n, end_) / surfaces(i, n.body).edge - 1.0;
  }

  static Partner partner_of(const Body& body, const Flight& flight) {
    return {flight.velocity, body.course.spin, body.inverse_mass, body.inverse_inertia,
            body.radius};
  }

  /// What a body has to do with when it meets a neighbour.
  struct Meeting {
    Vector3 separation;  // from the body to it, [length]
    Partner partner;     // the neighbour
    Law law;
  };
  Meeting meeting(int i, const Neighbour& n, double time) const {
    if (n.is_wall()) {
      const HardWall& wall = walls[n.wall()];
      const auto point = wall.moving.wall.nearest(flights[i].at(time), wall.moving.at(time),
                                                  wall.moving.rim_speed);
      return {point.separation, {point.velocity, {}, 0.0, 0.0, 0.0}, wall.law(bodies[i])};
    }
    Partner partner = partner_of(bodies[n.body], flights[n.body]);
    partner.velocity += neighbourhoods_.image(n.image).velocity;
    return {relative_motion(i, n.body, n.image, time).first, partner,
            pairs.law(bodies[i], bodies[n.body])};
  }

  void execute(int of_body, const PredictedEvent predicted) {
    const EventKey when = key(of_body, predicted);
    const double time = predicted.time;
    int i = of_body, j = predicted.partner, image = predicted.image;
    if (j >= 0 && bodies[j].tag < bodies[i].tag) {
      std::swap(i, j);
      image = neighbourhoods_.image(image).reverse;
    }
    Neighbour& pair = *neighbourhoods_.find_neighbour(i, j, image);
    const Course& course_i = course_of(i);
    const Course* const course_j = j < 0 ? nullptr : &course_of(j);

    auto [separation, partner, law] = meeting(i, pair, time);
    const double distance = norm(separation);
    const Vector3 k{separation.x / distance, separation.y / distance, separation.z / distance};
    const bool is_collision = predicted.surface == Surface::core;
    const LeastSpeeds least = law.takes_nothing() ? LeastSpeeds{} : least_speeds(i, j, law.depth);
    const bool elastic = is_collision && (rules.make_elastic(course_i, time) ||
                                          (course_j && rules.make_elastic(*course_j, time)));
    if (elastic) law.restitution = 1.0, law.friction = 0.0;
    Impact now =
        impact(predicted.surface, k, law, partner_of(bodies[i], flights[i]), partner, least);
    if (elastic && j < 0) keep_off_concave_wall(i, pair, k, now);
    if (now.kind == Kind::capture && j >= 0)
      keep_within_edge(i, j, partner, k, distance, least, now);

    events.push_back(
        {when, i, j, image, elastic, pair.inside, distance, separation, flights[i].at(time), now});
    before_event(events.back());
    neighbourhoods_.set_inside(i, pair, now.inside);
    apply_impulse(i, -1.0, now, when, is_collision);
    if (j >= 0) apply_impulse(j, 1.0, now, when, is_collision);
    after_event(events.back());
    predict(i);
    if (j >= 0) predict(j, i, neighbourhoods_.image(image).reverse);
    if (std::max(course_i.events, course_j ? course_j->events : 0) > rules.limit) overrun_ = {i, j};
  }

  /// Turns an elastic collision of the rule against collapse so that it leaves a cylinder for
  /// time_off_wall().
  void keep_off_concave_wall(int i, const Neighbour& pair, const Vector3& k, Impact& now) const {
    const Wall& wall = walls[pair.wall()].moving.wall;
    if (wall.shape != Wall::z_cylinder) return;
    const Body& body = bodies[i];
    const Vector3& before = flights[i].velocity;
    const Vector3 after =
        leaving_concave_wall(before - body.inverse_mass * now.on_j, k,
                             wall.position - surfaces(i, pair.body).core, time_off_wall());
    now.on_j = (1.0 / body.inverse_mass) * (before - after);
    now.normal = dot(k, now.on_j);
  }

  /// Turns a capture so that it brings the pair back within the edge, and by the rule of rest.
  void keep_within_edge(int i, int j, const Partner& partner, const Vector3& k, double distance,
                        const LeastSpeeds& least, Impact& now) const {
    const double b = bodies[i].inverse_mass + partner.inverse_mass;
    const Vector3 before = partner.velocity - flights[i].velocity, after = before + b * now.on_j;
    const Surfaces at = surfaces(i, j);
    const Vector3 turned = leaving_edge(after, k, distance, at.edge,
                                        std::min(least.kept, rules.speed_at_edge(norm(after), at)));
    if (same(turned, after)) return;
    now.on_j = (1.0 / b) * (turned - before);
    now.normal = dot(k, now.on_j);
  }

  /// How long an elastic collision keeps a particle off a concave wall, [time].
  double time_off_wall() const {
    return std::max(rules.contact_time,
                    rules.collapse > 0 ? (end_ - start_) / rules.collapse : 0.0);
  }

  /// The least speeds with which a collision parts its partners, by the rule of rest. `depth`: of
  /// the well between them, [energy].
  LeastSpeeds least_speeds(int i, int j, double depth) const {
    LeastSpeeds least;
    least.given = rules.speed_of_kick(bodies[i].kick, bodies[i].course);
    double inverse_mass = bodies[i].inverse_mass;
    int collisions = bodies[i].course.collisions;
    if (j >= 0) {
      least.given = std::max(least.given, rules.speed_of_kick(bodies[j].kick, bodies[j].course));
      inverse_mass += bodies[j].inverse_mass;
      collisions = std::max(collisions, bodies[j].course.collisions);
    }
    if (depth == 0.0) depth = shallowest_well(bodies[i], j < 0 ? bodies[i] : bodies[j]);
    least.kept = rules.speed_in_well(depth, inverse_mass, collisions);
    return least;
  }

  /// The least depth of the wells of two bodies with any others, [energy]; 0: they have none. By
  /// these wells bodies that have none with each other can be pressed together.
  double shallowest_well(const Body& a, const Body& b) const {
    double depth = std::min(pairs.shallowest_well(a), pairs.shallowest_well(b));
    for (const HardWall& wall : walls)
      for (const Body* body : {&a, &b}) {
        const double of_wall = wall.acts_on(*body) ? wall.law(*body).depth : 0.0;
        if (of_wall > 0.0) depth = std::min(depth, of_wall);
      }
    return depth < never ? depth : 0.0;
  }

  void apply_impulse(int body, double side, const Impact& now, const EventKey& when,
                     bool is_collision) {
    Body& b = bodies[body];
    Flight& flight = flights[body];
    flight.place = flight.at(when.time);
    flight.velocity += (side * b.inverse_mass) * now.on_j;
    flight.since = when.time;
    flight.version++;
    Course& course = b.course;
    course.spin -= (b.radius * b.inverse_inertia) * now.twist;
    course.causal_depth = when.causal_depth;
    course.collisions += is_collision;
    if (is_collision) course.last_collision = when.time;
    course.events++;
  }

  PeriodicBox box_;
  double start_ = 0.0, end_ = 0.0;  // of the step
  int step_ = 0;
};

}  // namespace cohesion::hard_sphere
