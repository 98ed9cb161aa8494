// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "hard_sphere/homes.h"
#include "hard_sphere/images.h"
#include "hard_sphere/pair_rules.h"
#include "hard_sphere/rows.h"
#include "prefetch.h"

namespace cohesion::hard_sphere {

/// A body or wall that a body may meet before it leaves its home. Small, since there are many: the
/// distances at which something happens are rounded, to 1e-7 of them.
struct Neighbour {
  int body;  ///< or -1 - number of the wall
  float core;
  float edge;  ///< Surfaces, [length]
  int image : 29;
  bool has_well : 1;
  bool inside : 1;  ///< in the well
  bool former : 1;  ///< perhaps only by a home that one of them had

  Surfaces rounded_surfaces() const { return {core, edge}; }
  bool is_wall() const { return body < 0; }
  int wall() const { return -1 - body; }
};
static_assert(sizeof(Neighbour) == 16);

/// Which bodies and walls each body may meet. Each has a home, a sphere that it is in when it gets
/// it, and which flows with the box; those whose homes are so near that they could meet are
/// neighbours of each other. A body that leaves its home gets a new one there. Such lists, per
/// body: F. Smallenburg, Eur. Phys. J. E 45 (2022) 22.
class Neighbourhoods : public Homes {
 public:
  Neighbourhoods() = default;
  // It points to the bodies, rules and walls of the one whose it is.
  Neighbourhoods(const Neighbourhoods&) = delete;
  Neighbourhoods& operator=(const Neighbourhoods&) = delete;

  /// Makes homes and neighbours of all bodies. The box holds all bodies in directions that are not
  /// periodic. In a box that flows a home lasts for `lifetime` [time]. Bodies, rules and walls stay
  /// where they are from here on.
  void build(const PeriodicBox& box, const std::vector<Body>& bodies,
             const std::vector<Flight>& flights, const PairRules& pairs,
             const std::vector<HardWall>& walls, double now, double lifetime) {
    pairs_ = &pairs;
    walls_ = &walls;
    images_.reset(box);
    former_.clear();
    make_homes(box, bodies, flights, pairs.largest_ratio(), now, lifetime);
    const int count = static_cast<int>(bodies.size());
    last_found_.assign(count, -1);
    // Pairs once, so that both of a pair agree about it whatever distances round to.
    std::vector<int> of_body(count + 1, 0), rooms(count, 0);
    std::vector<Neighbour> all;
    for (int i = 0; i < count; i++) {
      find_neighbours(i, now);
      for (const Neighbour& n : found_) {
        if (n.body < i) continue;
        all.push_back(n);
        rooms[i]++;
        rooms[n.body]++;
      }
      of_body[i + 1] = static_cast<int>(all.size());
    }
    for (int& room : rooms) room = Rows<Neighbour>::room_for(room);
    rows_.reset(rooms);
    for (int i = 0; i < count; i++) {
      for (int n = of_body[i]; n < of_body[i + 1]; n++) add_pair(i, all[n]);
      add_walls(i, flights[i].at(now), now);
    }
  }

  /// Time 0 is at the time `now` from here on.
  void set_clock_back(double now) {
    forget_former_homes(now);
    images_.set_clock_back(now);
    set_clock_of_homes_back(now);
  }

  Neighbour* begin(int body) { return rows_.begin(body); }
  Neighbour* end(int body) { return rows_.end(body); }
  const Neighbour* begin(int body) const { return rows_.begin(body); }
  const Neighbour* end(int body) const { return rows_.end(body); }
  const Image& image(int number) const { return images_[number]; }
  /// A body, or a wall, whose image is 0; nullptr: it is no neighbour.
  Neighbour* find_neighbour(int body, int partner, int image) {
    for (Neighbour* n = begin(body); n != end(body); n++)
      if (n->body == partner && n->image == image) return n;
    return nullptr;
  }

  /// Asks for the memory of a body's home and of where its list is.
  void foresee_body(int body) const {
    prefetch(home(body));
    rows_.foresee(body);
  }
  /// Asks for the memory of a list.
  void foresee_list(int body) const { prefetch(begin(body), end(body)); }

  /// Notes for both of a pair, or for a body at a wall, whether it is in its well.
  void set_inside(int i, Neighbour& n, bool inside) {
    n.inside = inside;
    if (!n.is_wall()) reverse_of(i, n)->inside = inside;
  }

  /// Gives bodies other numbers. For new ones add() has to follow.
  void arrange(const Renumbering& to, double now) {
    forget_former_homes(now);
    for (const int i : to.gone()) {
      while (begin(i) != end(i))
        if (begin(i)->is_wall())
          rows_.remove(i, begin(i));
        else
          remove_pair(i, begin(i));
      take_out(i, home(i));
    }
    std::vector<int> concerned;  // who have neighbours with another number
    for (const int n : to.changed())
      if (to.old(n) >= 0)
        for (const Neighbour* k = begin(to.old(n)); k != end(to.old(n)); k++)
          if (!k->is_wall()) concerned.push_back(k->body);
    std::sort(concerned.begin(), concerned.end());
    concerned.erase(std::unique(concerned.begin(), concerned.end()), concerned.end());
    for (const int i : concerned)
      for (Neighbour* n = begin(i); n != end(i); n++)
        if (!n->is_wall()) n->body = to.now(n->body);
    rows_.arrange(to);
    arrange_homes(to);
    last_found_.resize(to.count(), -1);
  }

  /// Gives a new body a home and neighbours; false: it is of another size than any body before, and
  /// all has to be made anew.
  bool add(int i, const Flight& flight, double now) {
    if (!find_size(i)) return false;
    move_home(i, flight, now, now);
    find_neighbours(i, now);
    for (const Neighbour& n : found_) add_pair(i, n);
    add_walls(i, flight.at(now), now);
    return true;
  }

  /// Makes a new home where a body is now, and its list of neighbours: those that it may meet, or
  /// could have met in this home from the time `since` on, unless that would use up much of what
  /// the home lasts. Unless has_been_home() all this time, which is asked when the home is there,
  /// others find it by its former home, too, and it keeps its former neighbours, until
  /// forget_former_homes().
  template <class HasBeenHome>
  void renew(int i, const Flight& flight, double now, double since,
             const HasBeenHome& has_been_home) {
    const Home before = home(i);
    if (flow() && now - since > 0.5 * flow().lifetime()) since = now;
    move_home(i, flight, now, since);
    const bool keep_former = !has_been_home();
    if (keep_former)
      former_.push_back({i, before});
    else
      take_out(i, before);
    find_neighbours(i, since);
    known_.assign(found_.size(), false);
    for (int n = 0; n < static_cast<int>(found_.size()); n++) last_found_[found_[n].body] = n;

    walls_before_.clear();
    for (Neighbour* n = begin(i); n != end(i);) {
      if (n->is_wall()) {
        walls_before_.push_back(*n);
        rows_.remove(i, n);
      } else if (mark_known(*n)) {
        n++;
      } else if (keep_former) {
        n->former = true;
        n++;
      } else {
        remove_pair(i, n);
      }
    }
    for (std::size_t n = 0; n < found_.size(); n++) {
      last_found_[found_[n].body] = -1;
      if (!known_[n]) add_pair(i, found_[n]);
    }
    add_walls(i, flight.at(now), now);
    for (Neighbour* n = begin(i); n != end(i); n++)
      for (const Neighbour& wall : walls_before_)
        if (n->body == wall.body) n->inside = wall.inside;
  }

  void forget_former_homes(double now) {
    for (const Former& former : former_) take_out(former.body, former.home);
    for (const Former& former : former_) {
      const int i = former.body;
      for (Neighbour* n = begin(i); n != end(i);)
        if (n->former && !may_meet(i, *n, now)) {
          remove_pair(i, n);
        } else {
          n->former = false;
          n++;
        }
    }
    former_.clear();
  }

  double bytes() const { return rows_.bytes() + bytes_of_homes(); }

 private:
  struct Former {  // home
    int body;
    Home home;
  };

  void add_pair(int i, Neighbour n) {
    rows_.add(i, n);
    const int j = n.body;
    n.body = i;
    n.image = images_[n.image].reverse;
    rows_.add(j, n);
  }

  /// Another neighbour of i takes the place of n.
  void remove_pair(int i, Neighbour* n) {
    rows_.remove(n->body, reverse_of(i, *n));
    rows_.remove(i, n);
  }

  /// The same pair in the list of the other body.
  Neighbour* reverse_of(int i, const Neighbour& n) {
    return find_neighbour(n.body, i, images_[n.image].reverse);
  }

  /// Marks the one of found_ that is this neighbour; whether there is one. A body can be there with
  /// several images.
  bool mark_known(Neighbour& n) {
    for (int number = last_found_[n.body]; number >= 0; number--)
      if (found_[number].body == n.body && found_[number].image == n.image) {
        known_[number] = true;
        n.former = n.former || found_[number].former;
        return true;
      }
    return false;
  }

  /// Sets found_ to the bodies that body i may meet.
  void find_neighbours(int i, double now) {
    found_.clear();
    find(i, now, [this, i, now](int j, const Folds& boxes, double square) {
      const Body &a = body(i), &b = body(j);
      if (!pairs_->meet(a, b)) return;
      const Surfaces surfaces = pairs_->surfaces(a, b);
      const double reach = std::max(surfaces.core, surfaces.edge) + home(i).radius + home(j).radius;
      if (square >= reach * reach) return;
      const int image = images_.number_of(boxes);
      if (!former_.empty())  // found by more than one home
        for (const Neighbour& n : found_)
          if (n.body == j && n.image == image) return;
      found_.push_back(neighbour(j, surfaces, image));
      found_.back().former = !former_.empty() && !may_meet(i, found_.back(), now);
    });
  }

  /// Whether a body could meet a neighbour while both are in their homes.
  bool may_meet(int i, const Neighbour& n, double now) const {
    constexpr double rounding = 1.0 + 1e-6;  // of the surfaces in lists
    return can_be_within(rounding * std::max(n.core, n.edge), i, n.body,
                         images_[n.image].displacement, now);
  }

  static Neighbour neighbour(int body, const Surfaces& surfaces, int image) {
    return {body,
            static_cast<float>(surfaces.core),
            static_cast<float>(surfaces.edge),
            image,
            surfaces.has_well(),
            false,
            false};
  }

  void add_walls(int i, const Vector3& place, double now) {
    const Body& of = body(i);
    const Home& home = this->home(i);
    for (int w = 0; w < static_cast<int>(walls_->size()); w++) {
      const HardWall& wall = (*walls_)[w];
      if (!wall.meets(of)) continue;
      const auto distance = [&](const Vector3& from) {
        return wall.moving.wall.nearest(from, wall.moving.at(now), 0.0).distance;
      };
      // A wall is not felt from behind.
      if (distance(place) <= 0.0) continue;
      const Surfaces surfaces = wall.surfaces(of);
      const double reach = std::max(surfaces.core, surfaces.edge) + home.radius;
      if (!wall.moves && distance(home.at(now)) >= reach &&
          (!flow() || distance(home.at(now + flow().lifetime())) >= reach))
        continue;
      rows_.add(i, neighbour(-1 - w, surfaces, 0));
    }
  }

  const PairRules* pairs_ = nullptr;
  const std::vector<HardWall>* walls_ = nullptr;
  Images images_;
  Rows<Neighbour> rows_;
  std::vector<Former> former_;
  std::vector<Neighbour> found_, walls_before_;
  std::vector<char> known_;      // of found_: was a neighbour before
  std::vector<int> last_found_;  // by body: the last of found_ that is it; -1: none
};

}  // namespace cohesion::hard_sphere
