// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "hard_sphere/bounding_neighbourhoods.h"
#include "hard_sphere/packed_lists.h"
#include "hard_sphere/pair_rules.h"
#include "hard_sphere/periodic_images.h"
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

  SurfaceDistances rounded_surfaces() const { return {core, edge}; }
  bool is_wall() const { return body < 0; }
  int wall() const { return -1 - body; }
};
static_assert(sizeof(Neighbour) == 16);

/// Which bodies and walls each body may meet. Each has a home, a sphere that it is in when it gets
/// it, and which flows with the box; those whose homes are so near that they could meet are
/// neighbours of each other. A body that leaves its home gets a new one there. Such lists, per
/// body: F. Smallenburg, Eur. Phys. J. E 45 (2022) 22.
class NeighbourLists : public BoundingNeighbourhoods {
 public:
  NeighbourLists() = default;
  // It points to the bodies, rules and walls of the one whose it is.
  NeighbourLists(const NeighbourLists&) = delete;
  NeighbourLists& operator=(const NeighbourLists&) = delete;

  /// Makes homes and neighbours of all bodies. The box holds all bodies in directions that are not
  /// periodic. In a box that flows a home lasts for `lifetime` [time]. Bodies, rules and walls stay
  /// where they are from here on.
  void build(const PeriodicBox& box, const std::vector<HardSphere>& bodies,
             const std::vector<VersionedFlight>& flights, const PairRules& pairs,
             const std::vector<HardWall>& walls, double now, double lifetime) {
    pairs_ = &pairs;
    walls_ = &walls;
    images_.reset(box);
    former_.clear();
    build_neighbourhoods(box, bodies, flights, pairs.largest_ratio(), now, lifetime);
    const int count = static_cast<int>(bodies.size());
    last_found_.assign(count, -1);
    // Pairs once, so that both of a pair agree about it whatever distances round to.
    std::vector<int> first_pair(count + 1, 0), capacities(count, 0);
    std::vector<Neighbour> all;
    for (int i = 0; i < count; i++) {
      find_neighbours(i, now);
      for (const Neighbour& n : found_) {
        if (n.body < i) continue;
        all.push_back(n);
        capacities[i]++;
        capacities[n.body]++;
      }
      first_pair[i + 1] = static_cast<int>(all.size());
    }
    for (int& capacity : capacities) capacity = PackedLists<Neighbour>::capacity_for(capacity);
    lists_.reset(capacities);
    for (int i = 0; i < count; i++) {
      for (int n = first_pair[i]; n < first_pair[i + 1]; n++) add_pair(i, all[n]);
      add_walls(i, flights[i].at(now), now);
    }
  }

  /// Time 0 is at the time `now` from here on.
  void shift_time_origin(double now) {
    drop_former_neighbourhoods(now);
    images_.shift_time_origin(now);
    shift_time_origin_of_neighbourhoods(now);
  }

  Neighbour* begin(int body) { return lists_.begin(body); }
  Neighbour* end(int body) { return lists_.end(body); }
  const Neighbour* begin(int body) const { return lists_.begin(body); }
  const Neighbour* end(int body) const { return lists_.end(body); }
  const PeriodicImage& image(int number) const { return images_[number]; }
  /// A body, or a wall, whose image is 0; nullptr: it is no neighbour.
  Neighbour* find_neighbour(int body, int partner, int image) {
    for (Neighbour* n = begin(body); n != end(body); n++)
      if (n->body == partner && n->image == image) return n;
    return nullptr;
  }

  /// Asks for the memory of a body's home and of where its list is.
  void prefetch_body(int body) const {
    prefetch(neighbourhood(body));
    lists_.prefetch_slice(body);
  }
  /// Asks for the memory of a list.
  void prefetch_list(int body) const { prefetch(begin(body), end(body)); }

  /// Notes for both of a pair, or for a body at a wall, whether it is in its well.
  void set_inside(int i, Neighbour& n, bool inside) {
    n.inside = inside;
    if (!n.is_wall()) reverse_of(i, n)->inside = inside;
  }

  /// Gives bodies other numbers. For new ones add() has to follow.
  void renumber(const BodyRenumbering& renumbering, double now) {
    drop_former_neighbourhoods(now);
    for (const int i : renumbering.removed()) {
      while (begin(i) != end(i))
        if (begin(i)->is_wall())
          lists_.remove(i, begin(i));
        else
          remove_pair(i, begin(i));
      remove_from_cells(i, neighbourhood(i));
    }
    std::vector<int> affected;  // who have neighbours with another number
    for (const int n : renumbering.changed())
      if (renumbering.old_number(n) >= 0)
        for (const Neighbour* k = begin(renumbering.old_number(n));
             k != end(renumbering.old_number(n)); k++)
          if (!k->is_wall()) affected.push_back(k->body);
    std::sort(affected.begin(), affected.end());
    affected.erase(std::unique(affected.begin(), affected.end()), affected.end());
    for (const int i : affected)
      for (Neighbour* n = begin(i); n != end(i); n++)
        if (!n->is_wall()) n->body = renumbering.new_number(n->body);
    lists_.renumber(renumbering);
    renumber_neighbourhoods(renumbering);
    last_found_.resize(renumbering.count(), -1);
  }

  /// Gives a new body a home and neighbours; false: it is of another size than any body before, and
  /// all has to be made anew.
  bool add(int i, const VersionedFlight& flight, double now) {
    if (!assign_size_class(i)) return false;
    recentre_neighbourhood(i, flight, now, now);
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
  void renew(int i, const VersionedFlight& flight, double now, double valid_from,
             const HasBeenHome& stayed_in_neighbourhood) {
    const BoundingNeighbourhood before = neighbourhood(i);
    if (flow() && now - valid_from > 0.5 * flow().lifetime()) valid_from = now;
    recentre_neighbourhood(i, flight, now, valid_from);
    const bool keep_former = !stayed_in_neighbourhood();
    if (keep_former)
      former_.push_back({i, before});
    else
      remove_from_cells(i, before);
    find_neighbours(i, valid_from);
    was_listed_.assign(found_.size(), false);
    for (int n = 0; n < static_cast<int>(found_.size()); n++) last_found_[found_[n].body] = n;

    former_walls_.clear();
    for (Neighbour* n = begin(i); n != end(i);) {
      if (n->is_wall()) {
        former_walls_.push_back(*n);
        lists_.remove(i, n);
      } else if (mark_listed(*n)) {
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
      if (!was_listed_[n]) add_pair(i, found_[n]);
    }
    add_walls(i, flight.at(now), now);
    for (Neighbour* n = begin(i); n != end(i); n++)
      for (const Neighbour& wall : former_walls_)
        if (n->body == wall.body) n->inside = wall.inside;
  }

  void drop_former_neighbourhoods(double now) {
    for (const FormerNeighbourhood& former : former_)
      remove_from_cells(former.body, former.neighbourhood);
    for (const FormerNeighbourhood& former : former_) {
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

  double bytes() const { return lists_.bytes() + neighbourhood_bytes(); }

 private:
  struct FormerNeighbourhood {  // home
    int body;
    BoundingNeighbourhood neighbourhood;
  };

  void add_pair(int i, Neighbour n) {
    lists_.add(i, n);
    const int j = n.body;
    n.body = i;
    n.image = images_[n.image].opposite;
    lists_.add(j, n);
  }

  /// Another neighbour of i takes the place of n.
  void remove_pair(int i, Neighbour* n) {
    lists_.remove(n->body, reverse_of(i, *n));
    lists_.remove(i, n);
  }

  /// The same pair in the list of the other body.
  Neighbour* reverse_of(int i, const Neighbour& n) {
    return find_neighbour(n.body, i, images_[n.image].opposite);
  }

  /// Marks the one of found_ that is this neighbour; whether there is one. A body can be there with
  /// several images.
  bool mark_listed(Neighbour& n) {
    for (int number = last_found_[n.body]; number >= 0; number--)
      if (found_[number].body == n.body && found_[number].image == n.image) {
        was_listed_[number] = true;
        n.former = n.former || found_[number].former;
        return true;
      }
    return false;
  }

  /// Sets found_ to the bodies that body i may meet.
  void find_neighbours(int i, double now) {
    found_.clear();
    for_each_near(i, now, [this, i, now](int j, const BoxOffset& boxes, double square) {
      const HardSphere &a = body(i), &b = body(j);
      if (!pairs_->interact(a, b)) return;
      const SurfaceDistances surfaces = pairs_->surfaces(a, b);
      const double reach = std::max(surfaces.core, surfaces.edge) + neighbourhood(i).radius +
                           neighbourhood(j).radius;
      if (square >= reach * reach) return;
      const int image = images_.find_number(boxes);
      if (!former_.empty())  // found by more than one home
        for (const Neighbour& n : found_)
          if (n.body == j && n.image == image) return;
      found_.push_back(make_neighbour(j, surfaces, image));
      found_.back().former = !former_.empty() && !may_meet(i, found_.back(), now);
    });
  }

  /// Whether a body could meet a neighbour while both are in their homes.
  bool may_meet(int i, const Neighbour& n, double now) const {
    constexpr double rounding = 1.0 + 1e-6;  // of the surfaces in lists
    return can_come_within(rounding * std::max(n.core, n.edge), i, n.body,
                           images_[n.image].displacement, now);
  }

  static Neighbour make_neighbour(int body, const SurfaceDistances& surfaces, int image) {
    return {body,
            static_cast<float>(surfaces.core),
            static_cast<float>(surfaces.edge),
            image,
            surfaces.has_well(),
            false,
            false};
  }

  void add_walls(int i, const Vector3& position, double now) {
    const HardSphere& of = body(i);
    const BoundingNeighbourhood& neighbourhood = this->neighbourhood(i);
    for (int w = 0; w < static_cast<int>(walls_->size()); w++) {
      const HardWall& wall = (*walls_)[w];
      if (!wall.interacts_with(of)) continue;
      const auto distance = [&](const Vector3& from) {
        return wall.motion.wall.nearest(from, wall.motion.at(now), 0.0).distance;
      };
      // A wall is not felt from behind.
      if (distance(position) <= 0.0) continue;
      const SurfaceDistances surfaces = wall.surfaces(of);
      const double reach = std::max(surfaces.core, surfaces.edge) + neighbourhood.radius;
      if (!wall.moves && distance(neighbourhood.centre_at(now)) >= reach &&
          (!flow() || distance(neighbourhood.centre_at(now + flow().lifetime())) >= reach))
        continue;
      lists_.add(i, make_neighbour(-1 - w, surfaces, 0));
    }
  }

  const PairRules* pairs_ = nullptr;
  const std::vector<HardWall>* walls_ = nullptr;
  PeriodicImages images_;
  PackedLists<Neighbour> lists_;
  std::vector<FormerNeighbourhood> former_;
  std::vector<Neighbour> found_, former_walls_;
  std::vector<char> was_listed_;  // of found_: was a neighbour before
  std::vector<int> last_found_;   // by body: the last of found_ that is it; -1: none
};

}  // namespace cohesion::hard_sphere
