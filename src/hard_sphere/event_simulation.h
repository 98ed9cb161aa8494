// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hard_sphere/bodies.h"
#include "hard_sphere/concave_wall.h"

namespace cohesion::hard_sphere {

/// Rules of one run.
struct EventRules {
  int collapse = 100;  ///< collisions of a particle in a step before the rest are elastic; 0: off
  double contact_time = 0.0;  ///< collisions sooner after a particle's last one are elastic, [time]
  int limit = 100000;         ///< events of a particle in a step before the step is given up
  bool reports = false;       ///< keep `news`, for a body that is also followed elsewhere
};

/// The events of one step of straight flight, carried out in order of time.
///
/// A heap holds the next event of every candidate pair that has one in the step. After an event
/// only the candidates of its particles are predicted again; predictions they replace stay in the
/// heap and are known by their version.
///
/// A prediction depends on nothing but the candidate and the flights of its two bodies: it starts
/// from the later of their last events. So it is the same, bit by bit, wherever and whenever it is
/// made.
///
/// Part of the bodies may be followed elsewhere (by another process) at the same time. What happens
/// to them there comes as `foreign` news. Whoever follows a part runs a stretch of the step with
/// the news it has, tells its own, and where those that it gets differ from what it assumed, it
/// takes back what came from there on and runs on with them. What lies before the first difference
/// of all parts is final: every event there has been worked out from what truly went before it. So
/// the order is that of one process, and every exchange brings it at least one event farther.
class EventSimulation {
 private:
  struct Predicted {
    double time;
    int candidate;
    unsigned version;
    int depth;
  };

  /// A flight before an event changed it.
  struct Undo {
    double time;
    int body;
    Flight before;
  };

  /// The order of the queue.
  struct Later {
    const EventSimulation& simulation;
    bool operator()(const Predicted& a, const Predicted& b) const {
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

  std::vector<Event> events;  ///< of this step, in order
  std::vector<News> news;     ///< of this stretch, with rules.reports
  std::vector<News> foreign;  ///< of this stretch, in order

  /// After bodies and candidates have been set: which candidates each body has.
  void connect() {
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

  /// The candidate of two bodies; -1: none. After connect().
  int find(int i, int j, int image) const {
    for (int n = first_[i]; n < first_[i + 1]; n++) {
      const CandidatePair& b = candidates[of_body_[n]];
      if (b.i == i && b.j == j && b.image == image) return of_body_[n];
    }
    return -1;
  }

  /// Before the bodies' flights of a step of length `dt` are set.
  void begin_step(double dt) {
    dt_ = dt;
    queue_.clear();
    events.clear();
    overrun_ = -1;
    begin_stretch();
  }

  /// The first event of candidate n, when it has one in this step, goes into the queue.
  bool predict(int n) {
    CandidatePair& candidate = candidates[n];
    candidate.version++;
    const double time = time_of_next(candidate);
    if (!(time <= dt_)) return false;
    queue_.push_back({time, n, candidate.version, depth(candidate, time)});
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
    return norm(relative(candidate, dt_).first);
  }

  /// Whether the partners of candidate n, a pair without events so far, come nearer to a surface
  /// than its share `nearly` of the distance: for flights that are known to round-off only.
  bool may_meet(int n, double nearly) const {
    const CandidatePair& candidate = candidates[n];
    const auto [r, w] = relative(candidate, 0.0);
    const double ww = dot(w, w), b = dot(r, w);
    const double back = ww * dt_ > b && b > 0.0 ? b / ww : b > 0.0 ? dt_ : 0.0;
    const double least = norm(r - back * w);
    if (!candidate.inside)
      return least < (1.0 + nearly) * (candidate.at.well() ? candidate.at.edge : candidate.at.core);
    return least < (1.0 + nearly) * candidate.at.core ||
           std::max(norm(r), norm(r - dt_ * w)) > (1.0 - nearly) * candidate.at.edge;
  }

  /// After predictions in any order.
  void sort() { std::make_heap(queue_.begin(), queue_.end(), Later{*this}); }

  void begin_stretch() {
    undo_.clear();
    news.clear();
    foreign.clear();
    told_ = 0;
    start_ = events.size();
  }

  /// All events up to `until`.
  void run(double until) {
    while (overrun_ < 0) {
      while (!queue_.empty() &&
             queue_.front().version != candidates[queue_.front().candidate].version)
        pop();
      const bool own = !queue_.empty() && queue_.front().time <= until;
      if (told_ < foreign.size() && !(own && key(queue_.front()) < foreign[told_].key)) {
        accept(foreign[told_++]);
      } else if (own) {
        const Predicted next = queue_.front();
        pop();
        carry_out(next.candidate, key(next));
      } else {
        return;
      }
    }
  }

  /// The stretch again from a time on, with the news from there on.
  void run_again(double from, const std::vector<News>& told, double until) {
    take_back(from);
    foreign.resize(told_);
    for (const News& n : told)
      if (n.key.time >= from) foreign.push_back(n);
    run(until);
  }

  /// The time of the first news from `from` on in which `told` is not what this run took for true.
  double first_difference(double from, const std::vector<News>& told) const {
    auto known = foreign.begin() + first_news(foreign, from);
    for (const News& n : told) {
      if (n.key.time < from) continue;
      if (known == foreign.end()) return n.key.time;
      if (!(n == *known)) return std::min(n.key.time, known->key.time);
      ++known;
    }
    return known == foreign.end() ? never : known->key.time;
  }

  /// A candidate with more events than the limit; -1: none. run() stops there.
  int overrun() const { return overrun_; }

 private:
  EventKey key(const Predicted& p) const {
    const CandidatePair& candidate = candidates[p.candidate];
    return {p.time, p.depth, bodies[candidate.i].tag,
            candidate.with_wall() ? candidate.j : bodies[candidate.j].tag};
  }

  int depth(const CandidatePair& candidate, double time) const {
    const int of_i = bodies[candidate.i].flight.depth_at(time);
    return 1 + (candidate.with_wall() ? of_i
                                      : std::max(of_i, bodies[candidate.j].flight.depth_at(time)));
  }

  void pop() {
    std::pop_heap(queue_.begin(), queue_.end(), Later{*this});
    queue_.pop_back();
  }

  double time_of_next(CandidatePair& candidate) const {
    const Flight& a = bodies[candidate.i].flight;
    Crossing crossing;
    double now = a.since;
    if (candidate.with_wall()) {
      crossing = next_crossing(walls[candidate.wall()], a.at(dt_ - now), a.velocity, dt_ - now,
                               candidate.at, candidate.inside);
    } else {
      const Flight& b = bodies[candidate.j].flight;
      now = std::max(now, b.since);
      const auto [r, w] = relative(candidate, dt_ - now);
      const double vv = std::max(dot(a.velocity, a.velocity), dot(b.velocity, b.velocity));
      crossing = next_crossing(r, w, vv, candidate.at, candidate.inside);
    }
    candidate.next = crossing.surface;
    return now + crossing.wait;
  }

  void predict_all(int body, int but = -1) {
    for (int n = first_[body]; n < first_[body + 1]; n++)
      if (of_body_[n] != but && predict(of_body_[n]))
        std::push_heap(queue_.begin(), queue_.end(), Later{*this});
  }

  static std::ptrdiff_t first_news(const std::vector<News>& all, double from) {
    return std::find_if(all.begin(), all.end(),
                        [from](const News& n) { return n.key.time >= from; }) -
           all.begin();
  }

  /// What happened from a time on in this stretch has not happened.
  void take_back(double from) {
    overrun_ = -1;
    for (; events.size() > start_ && events.back().key.time >= from; events.pop_back())
      candidates[events.back().candidate].inside = events.back().was_inside;
    while (!news.empty() && news.back().key.time >= from) news.pop_back();
    told_ = std::min(told_, static_cast<std::size_t>(first_news(foreign, from)));
    std::vector<int> touched;
    for (; !undo_.empty() && undo_.back().time >= from; undo_.pop_back()) {
      bodies[undo_.back().body].flight = undo_.back().before;
      touched.push_back(undo_.back().body);
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const int body : touched) predict_all(body);
  }

  void remember(int body, double time) {
    if (rules.reports) undo_.push_back({time, body, bodies[body].flight});
  }

  void accept(const News& told) {
    remember(told.body, told.key.time);
    bodies[told.body].flight = told.flight;
    predict_all(told.body);
  }

  /// Position and velocity of j as seen from i. Prediction and event take the same numbers: they
  /// must not differ about which way a pair goes.
  std::pair<Vector3, Vector3> relative(const CandidatePair& candidate, double left) const {
    const Flight &a = bodies[candidate.i].flight, &b = bodies[candidate.j].flight;
    const Image& image = images[candidate.image];
    const Vector3 w = b.velocity + image.velocity - a.velocity;
    return {b.end - a.end + image.displacement - left * w, w};
  }

  /// Where j is as seen from i, and what it is.
  std::pair<Vector3, Partner> other_side(const CandidatePair& candidate, double left) const {
    if (candidate.with_wall()) {
      const MovingWall& wall = walls[candidate.wall()];
      const auto point =
          wall.wall.nearest(bodies[candidate.i].flight.at(left), wall.at(left), wall.rim_speed);
      return {point.separation, {point.velocity, {}, 0.0, 0.0, 0.0}};
    }
    Partner partner = bodies[candidate.j].partner();
    partner.velocity += images[candidate.image].velocity;
    return {relative(candidate, left).first, partner};
  }

  void carry_out(int n, const EventKey& when) {
    CandidatePair& candidate = candidates[n];
    const double left = dt_ - when.time;
    const auto [separation, partner] = other_side(candidate, left);
    const double distance = norm(separation);
    const Vector3 k{separation.x / distance, separation.y / distance, separation.z / distance};
    Law law = laws[candidate.law];
    const bool hit = candidate.next == Surface::core;
    const bool elastic =
        hit && (collapses(candidate.i, when.time) || collapses(candidate.j, when.time));
    if (elastic) law.restitution = 1.0, law.friction = 0.0;
    Impact now = impact(candidate.next, k, law, bodies[candidate.i].partner(), partner);
    if (elastic && candidate.with_wall()) keep_off(candidate, k, now);

    events.push_back({when, n, elastic, candidate.inside, distance, separation,
                      bodies[candidate.i].flight.at(left), now});
    candidate.inside = now.inside;
    act(candidate.i, candidate.j, -1.0, now, when, hit);
    if (!candidate.with_wall()) act(candidate.j, candidate.i, 1.0, now, when, hit);
    predict_all(candidate.i);
    if (!candidate.with_wall()) predict_all(candidate.j, n);
    if (busiest(candidate) > rules.limit) overrun_ = n;
  }

  /// An elastic collision of the rule against collapse leaves a cylinder for a share of the step.
  void keep_off(const CandidatePair& candidate, const Vector3& k, Impact& now) const {
    const Wall& wall = walls[candidate.wall()].wall;
    if (wall.shape != Wall::z_cylinder) return;
    const Body& body = bodies[candidate.i];
    const Vector3& before = body.flight.velocity;
    const Vector3 after = leaving_concave_wall(before - body.inverse_mass * now.on_j, k,
                                               wall.position - candidate.at.core, off_wall());
    now.on_j = (1.0 / body.inverse_mass) * (before - after);
    now.normal = dot(k, now.on_j);
  }

  /// How long an elastic collision keeps a particle off a concave wall.
  double off_wall() const {
    return std::max(rules.contact_time, rules.collapse > 0 ? dt_ / rules.collapse : 0.0);
  }

  /// Whether the rules against collapse act on a collision of this body.
  bool collapses(int body, double time) const {
    if (body < 0) return false;
    const Flight& flight = bodies[body].flight;
    return (rules.collapse > 0 && flight.collisions >= rules.collapse) ||
           time - flight.hit < rules.contact_time;
  }

  int busiest(const CandidatePair& candidate) const {
    const int of_i = bodies[candidate.i].flight.events;
    return candidate.with_wall() ? of_i : std::max(of_i, bodies[candidate.j].flight.events);
  }

  void act(int body, int partner, double side, const Impact& now, const EventKey& when, bool hit) {
    remember(body, when.time);
    Body& b = bodies[body];
    const Vector3 change = (side * b.inverse_mass) * now.on_j;
    b.flight.velocity += change;
    b.flight.end += (dt_ - when.time) * change;
    b.flight.spin -= (b.radius * b.inverse_inertia) * now.twist;
    b.flight.since = when.time;
    b.flight.depth = when.depth;
    b.flight.collisions += hit;
    if (hit) b.flight.hit = when.time;
    b.flight.events++;
    if (rules.reports) news.push_back({when, body, partner, b.flight});
  }

  double dt_ = 0.0;
  std::vector<int> first_,
      of_body_;  // candidates of body i: of_body_[first_[i]] ... [first_[i + 1] - 1]
  std::vector<Predicted> queue_;
  std::vector<Undo> undo_;  // of this stretch, with rules.reports
  std::size_t told_ = 0;    // news that have been taken in
  std::size_t start_ = 0;   // of the stretch, in `events`
  int overrun_ = -1;
};

}  // namespace cohesion::hard_sphere
