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

/// A body or wall that a body may meet while it is in its bounding neighbourhood. To save memory
/// the distances are in single precision, with a relative error up to 1e-7.
struct Neighbour {
  int body;  ///< or -1 - number of the wall
  float core;
  float edge;  ///< SurfaceDistances, [length]
  int image : 29;
  bool has_well : 1;
  bool inside : 1;  ///< whether the pair is in its well
  bool former : 1;  ///< perhaps a neighbour only by a former neighbourhood of one of both

  SurfaceDistances rounded_surfaces() const { return {core, edge}; }
  bool is_wall() const { return body < 0; }
  int wall() const { return -1 - body; }
};
static_assert(sizeof(Neighbour) == 16);

/// Neighbour lists of all bodies and walls. Two bodies are neighbours if they could meet while both
/// are in their bounding neighbourhoods. A body that leaves its neighbourhood gets a new one, and
/// only its own list is rebuilt: A. Donev, S. Torquato, F. H. Stillinger, J. Comput. Phys. 202
/// (2005) 737; F. Smallenburg, Eur. Phys. J. E 45 (2022) 22.
class NeighbourLists : public BoundingNeighbourhoods {
 public:
  NeighbourLists() = default;
  // Not copied, since it holds pointers to the bodies, rules and walls of a simulation.
  NeighbourLists(const NeighbourLists&) = delete;
  NeighbourLists& operator=(const NeighbourLists&) = delete;

  /// Builds the neighbourhoods and lists of all bodies. The box contains all bodies in directions
  /// that are not periodic. In a deforming box a neighbourhood is valid for `lifetime` [time]. The
  /// arguments have to stay at their addresses.
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
    // Each pair is tested once, so that round-off cannot enter it in one list only.
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

  /// Shifts the time origin to `now`.
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
  /// The neighbour of a body; a wall has image 0. nullptr: not in the list.
  Neighbour* find_neighbour(int body, int partner, int image) {
    for (Neighbour* n = begin(body); n != end(body); n++)
      if (n->body == partner && n->image == image) return n;
    return nullptr;
  }

  /// Prefetches the neighbourhood of a body and the address of its list.
  void prefetch_body(int body) const {
    prefetch(neighbourhood(body));
    lists_.prefetch_slice(body);
  }
  /// Prefetches a list.
  void prefetch_list(int body) const { prefetch(begin(body), end(body)); }

  /// Stores in the lists of both partners whether the pair is in its well.
  void set_inside(int i, Neighbour& n, bool inside) {
    n.inside = inside;
    if (!n.is_wall()) opposite_entry(i, n)->inside = inside;
  }

  /// Renumbers bodies. The caller then calls add() for new ones.
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
    std::vector<int> affected;  // bodies with neighbours that have a new number
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

  /// Gives a new body a neighbourhood and a list. Returns false if its size belongs to no size
  /// class; the caller then calls build().
  bool add(int i, const VersionedFlight& flight, double now) {
    if (!assign_size_class(i)) return false;
    recentre_neighbourhood(i, flight, now, now);
    find_neighbours(i, now);
    for (const Neighbour& n : found_) add_pair(i, n);
    add_walls(i, flight.at(now), now);
    return true;
  }

  /// Gives a body a new neighbourhood at its present position and rebuilds its list. The list
  /// contains the bodies that it may meet, or could have met since the time `valid_from`, unless
  /// that would use up much of the lifetime. If has_stayed_inside() is false for the new
  /// neighbourhood since then, searches find the body by its former neighbourhood, too, and it
  /// keeps its former neighbours, until drop_former_neighbourhoods().
  template <class HasStayedInside>
  void renew(int i, const VersionedFlight& flight, double now, double valid_from,
             const HasStayedInside& has_stayed_inside) {
    const BoundingNeighbourhood before = neighbourhood(i);
    if (flow() && now - valid_from > 0.5 * flow().lifetime()) valid_from = now;
    recentre_neighbourhood(i, flight, now, valid_from);
    const bool keep_former = !has_stayed_inside();
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
  struct FormerNeighbourhood {
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

  /// Replaces n in the list of i by the last neighbour.
  void remove_pair(int i, Neighbour* n) {
    lists_.remove(n->body, opposite_entry(i, *n));
    lists_.remove(i, n);
  }

  /// The entry of the same pair in the list of the other body.
  Neighbour* opposite_entry(int i, const Neighbour& n) {
    return find_neighbour(n.body, i, images_[n.image].opposite);
  }

  /// Marks the element of found_ that is this neighbour; returns whether there is one. A body can
  /// be a neighbour with several images.
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
    for_each_near(i, now, [this, i, now](int j, const Cells::BoxOffset& boxes, double square) {
      const HardSphere &a = body(i), &b = body(j);
      if (!pairs_->interact(a, b)) return;
      const SurfaceDistances surfaces = pairs_->surfaces(a, b);
      const double reach = std::max(surfaces.core, surfaces.edge) + neighbourhood(i).radius +
                           neighbourhood(j).radius;
      if (square >= reach * reach) return;
      const int image = images_.find_number(boxes);
      if (!former_.empty())  // a search finds a body by several neighbourhoods
        for (const Neighbour& n : found_)
          if (n.body == j && n.image == image) return;
      found_.push_back(make_neighbour(j, surfaces, image));
      found_.back().former = !former_.empty() && !may_meet(i, found_.back(), now);
    });
  }

  /// Whether a body could meet a neighbour while both are in their neighbourhoods.
  bool may_meet(int i, const Neighbour& n, double now) const {
    constexpr double rounding = 1.0 + 1e-6;  // of the surfaces in single precision
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
    const HardSphere& sphere = body(i);
    const BoundingNeighbourhood& neighbourhood = this->neighbourhood(i);
    for (int w = 0; w < static_cast<int>(walls_->size()); w++) {
      const HardWall& wall = (*walls_)[w];
      if (!wall.interacts_with(sphere)) continue;
      const auto distance = [&](const Vector3& from) {
        return wall.motion.wall.nearest(from, wall.motion.at(now), 0.0).distance;
      };
      // A wall acts on one side only.
      if (distance(position) <= 0.0) continue;
      const SurfaceDistances surfaces = wall.surfaces(sphere);
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
  std::vector<char> was_listed_;  // by element of found_
  std::vector<int> last_found_;   // by body: its last element in found_; -1: none
};

}  // namespace cohesion::hard_sphere
