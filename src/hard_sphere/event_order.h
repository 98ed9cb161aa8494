// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hard_sphere/bodies.h"
#include "hard_sphere/concave_wall.h"

namespace cohesion::hard_sphere {

/// Rules of one run.
struct OrderRules {
  int collapse = 100;    ///< collisions of a particle in a step before the rest are elastic; 0: off
  int limit = 100000;    ///< events of a particle in a step before the step is given up
  bool reports = false;  ///< keep `news`, for a body that is also followed elsewhere
};

/// The events of one step of straight flight, carried out in order of time.
///
/// A heap holds the next event of every link that has one in the step. After an event only the
/// links of its particles are predicted again; predictions they replace stay in the heap and are
/// known by their version.
///
/// A prediction depends on nothing but the link and the flights of its two bodies: it starts from
/// the later of their last events. So it is the same, bit by bit, wherever and whenever it is made.
///
/// Part of the bodies may be followed elsewhere (by another process) at the same time. What happens
/// to them there comes as `foreign` news, and the step is carried out in stretches:
/// begin_stretch(), run(), and, as long as the news that this run was based on turn out to be
/// others, take_back() and run() again. When all agree, every event has been worked out from what
/// truly went before it: the order is that of one process.
class EventOrder {
 private:
  struct Predicted {
    double time;
    int link;
    unsigned version;
  };

  /// The order of the heap.
  struct Later {
    const EventOrder& order;
    bool operator()(const Predicted& a, const Predicted& b) const {
      return a.time != b.time ? a.time > b.time : order.key(b) < order.key(a);
    }
  };

 public:
  std::vector<Body> bodies;
  std::vector<Link> links;
  std::vector<Image> images{Image{}};
  std::vector<Law> laws;
  std::vector<MovingWall> walls;
  OrderRules rules;

  std::vector<Event> events;  ///< of this step, in order
  std::vector<News> news;     ///< of this stretch, with rules.reports
  std::vector<News> foreign;  ///< of this stretch, in order: input

  /// After bodies and links have been set: which links each body has.
  void connect() {
    first_.assign(bodies.size() + 1, 0);
    for (const Link& b : links) {
      first_[b.i + 1]++;
      if (!b.of_wall()) first_[b.j + 1]++;
    }
    for (std::size_t i = 1; i < first_.size(); i++) first_[i] += first_[i - 1];
    of_body_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (int n = 0; n < static_cast<int>(links.size()); n++) {
      of_body_[next[links[n].i]++] = n;
      if (!links[n].of_wall()) of_body_[next[links[n].j]++] = n;
    }
  }

  /// The link of two bodies; -1: none. After connect().
  int find(int i, int j, int image) const {
    for (int n = first_[i]; n < first_[i + 1]; n++) {
      const Link& b = links[of_body_[n]];
      if (b.i == i && b.j == j && b.image == image) return of_body_[n];
    }
    return -1;
  }

  /// Before the bodies' flights of a step of length `dt` are set.
  void begin_step(double dt) {
    dt_ = dt;
    heap_.clear();
    events.clear();
    overrun_ = -1;
    begin_stretch();
  }

  /// The first event of link n, when it has one in this step, goes into the order.
  bool predict(int n) {
    Link& link = links[n];
    link.version++;
    const double time = time_of_next(link);
    if (!(time <= dt_)) return false;
    heap_.push_back({time, n, link.version});
    return true;
  }

  double dt() const { return dt_; }

  /// Distance of the partners of link n when the step began, [length].
  double distance_at_start(int n) const {
    const Link& link = links[n];
    if (link.of_wall()) {
      const MovingWall& wall = walls[link.wall()];
      return wall.wall.nearest(bodies[link.i].flight.at(dt_), wall.at(dt_), 0.0).distance;
    }
    return norm(other_side(link, dt_).first);
  }

  /// Whether the partners of link n, a pair without events so far, come nearer to a surface than
  /// its share `nearly` of the distance: for flights that are known to round-off only.
  bool may_meet(int n, double nearly) const {
    const Link& link = links[n];
    const auto [r, partner] = other_side(link, 0.0);
    const Vector3 w = partner.velocity - bodies[link.i].flight.velocity;
    const double ww = dot(w, w), b = dot(r, w);
    const double back = ww * dt_ > b && b > 0.0 ? b / ww : b > 0.0 ? dt_ : 0.0;
    const double least = norm(r - back * w);
    if (!link.inside)
      return least < (1.0 + nearly) * (link.at.well() ? link.at.edge : link.at.core);
    return least < (1.0 + nearly) * link.at.core ||
           std::max(norm(r), norm(r - dt_ * w)) > (1.0 - nearly) * link.at.edge;
  }

  /// After predictions in any order.
  void sort() { std::make_heap(heap_.begin(), heap_.end(), Later{*this}); }

  void begin_stretch() {
    stretch_++;
    put_aside_.clear();
    news.clear();
    foreign.clear();
    start_ = events.size();
  }

  /// The stretch is as it was when it began.
  void take_back() {
    overrun_ = -1;
    for (std::size_t n = events.size(); n-- > start_;)
      links[events[n].link].inside = events[n].was_inside;
    events.resize(start_);
    news.clear();
    stretch_++;
    for (auto& [body, flight] : put_aside_) bodies[body].flight = flight;
    for (auto& [body, flight] : put_aside_) predict_all(body);
    put_aside_.clear();
  }

  /// All events up to `until`.
  void run(double until) {
    std::size_t told = 0;
    while (overrun_ < 0) {
      while (!heap_.empty() && heap_.front().version != links[heap_.front().link].version) pop();
      const bool own = !heap_.empty() && heap_.front().time <= until;
      if (told < foreign.size() && !(own && key(heap_.front()) < foreign[told].key)) {
        accept(foreign[told++]);
      } else if (own) {
        const Predicted next = heap_.front();
        pop();
        carry_out(next.link, next.time);
      } else {
        return;
      }
    }
  }

  /// A link with more events than the limit; -1: none. run() stops there.
  int overrun() const { return overrun_; }

 private:
  EventKey key(const Predicted& p) const { return key(p.time, links[p.link]); }
  EventKey key(double time, const Link& b) const {
    return {time, bodies[b.i].tag, b.of_wall() ? b.j : bodies[b.j].tag};
  }

  void pop() {
    std::pop_heap(heap_.begin(), heap_.end(), Later{*this});
    heap_.pop_back();
  }

  double time_of_next(Link& link) const {
    const Flight& a = bodies[link.i].flight;
    Crossing crossing;
    double now = a.since;
    if (link.of_wall()) {
      crossing = next_crossing(walls[link.wall()], a.at(dt_ - now), a.velocity, dt_ - now, link.at,
                               link.inside);
    } else {
      const Flight& b = bodies[link.j].flight;
      const Image& image = images[link.image];
      now = std::max(now, b.since);
      const Vector3 w = b.velocity - a.velocity + image.velocity;
      const Vector3 end = b.end - a.end + image.displacement;
      crossing = next_crossing(end - (dt_ - now) * w, w, link.at, link.inside);
    }
    link.next = crossing.surface;
    return now + crossing.wait;
  }

  void predict_all(int body, int but = -1) {
    for (int n = first_[body]; n < first_[body + 1]; n++)
      if (of_body_[n] != but && predict(of_body_[n]))
        std::push_heap(heap_.begin(), heap_.end(), Later{*this});
  }

  /// Flights before they change, once in a stretch.
  void put_aside(int body) {
    if (!rules.reports || bodies[body].saved == stretch_) return;
    bodies[body].saved = stretch_;
    put_aside_.push_back({body, bodies[body].flight});
  }

  void accept(const News& told) {
    put_aside(told.body);
    bodies[told.body].flight = told.flight;
    predict_all(told.body);
  }

  /// Where j is as seen from i, and what it is.
  std::pair<Vector3, Partner> other_side(const Link& link, double left) const {
    const Vector3 centre = bodies[link.i].flight.at(left);
    if (link.of_wall()) {
      const MovingWall& wall = walls[link.wall()];
      const auto point = wall.wall.nearest(centre, wall.at(left), wall.rim_speed);
      return {point.separation, {point.velocity, {}, 0.0, 0.0, 0.0}};
    }
    const Body& b = bodies[link.j];
    const Image& image = images[link.image];
    Partner partner = b.partner();
    partner.velocity += image.velocity;
    return {b.flight.at(left) + image.displacement - left * image.velocity - centre, partner};
  }

  void carry_out(int n, double time) {
    Link& link = links[n];
    const double left = dt_ - time;
    const auto [separation, partner] = other_side(link, left);
    const double distance = norm(separation);
    const Vector3 k{separation.x / distance, separation.y / distance, separation.z / distance};
    Law law = laws[link.law];
    const bool hit = link.next == Surface::core;
    const bool elastic = hit && rules.collapse > 0 && exhausted(link);
    if (elastic) law.restitution = 1.0, law.friction = 0.0;
    Impact now = impact(link.next, k, law, bodies[link.i].partner(), partner);
    if (elastic && link.of_wall()) keep_off(link, k, now);

    const EventKey when = key(time, link);
    events.push_back(
        {when, n, elastic, link.inside, distance, separation, bodies[link.i].flight.at(left), now});
    link.inside = now.inside;
    act(link.i, link.j, -1.0, now, when, hit);
    if (!link.of_wall()) act(link.j, link.i, 1.0, now, when, hit);
    predict_all(link.i);
    if (!link.of_wall()) predict_all(link.j, n);
    if (busiest(link) > rules.limit) overrun_ = n;
  }

  /// An elastic collision of the rule against collapse leaves a cylinder for a share of the step.
  void keep_off(const Link& link, const Vector3& k, Impact& now) const {
    const Wall& wall = walls[link.wall()].wall;
    if (wall.shape != Wall::z_cylinder) return;
    const Body& body = bodies[link.i];
    const Vector3& before = body.flight.velocity;
    const Vector3 after = leaving_concave_wall(before - body.inverse_mass * now.on_j, k,
                                               wall.position - link.at.core, dt_ / rules.collapse);
    now.on_j = (1.0 / body.inverse_mass) * (before - after);
    now.normal = dot(k, now.on_j);
  }

  bool exhausted(const Link& link) const {
    return bodies[link.i].flight.collisions >= rules.collapse ||
           (!link.of_wall() && bodies[link.j].flight.collisions >= rules.collapse);
  }

  int busiest(const Link& link) const {
    const int of_i = bodies[link.i].flight.events;
    return link.of_wall() ? of_i : std::max(of_i, bodies[link.j].flight.events);
  }

  void act(int body, int partner, double side, const Impact& now, const EventKey& when, bool hit) {
    put_aside(body);
    Body& b = bodies[body];
    const Vector3 change = (side * b.inverse_mass) * now.on_j;
    b.flight.velocity += change;
    b.flight.end += (dt_ - when.time) * change;
    b.flight.spin -= (b.radius * b.inverse_inertia) * now.twist;
    b.flight.since = when.time;
    b.flight.collisions += hit;
    b.flight.events++;
    if (rules.reports) news.push_back({when, body, partner, b.flight});
  }

  double dt_ = 0.0;
  std::vector<int> first_,
      of_body_;  // links of body i: of_body_[first_[i]] ... [first_[i + 1] - 1]
  std::vector<Predicted> heap_;
  std::vector<std::pair<int, Flight> > put_aside_;
  std::size_t start_ = 0;  // of the stretch, in `events`
  unsigned stretch_ = 0;
  int overrun_ = -1;
};

}  // namespace cohesion::hard_sphere
