// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "hard_sphere/bodies.h"
#include "hard_sphere/body_renumbering.h"
#include "hard_sphere/box_flow.h"
#include "hard_sphere/cells.h"

namespace cohesion::hard_sphere {

/// Bounding neighbourhood of a body: a sphere that contains its centre for some time, A. Donev, S.
/// Torquato, F. H. Stillinger, J. Comput. Phys. 202 (2005) 737. It moves with the affine flow of
/// the box.
struct BoundingNeighbourhood {
  Vector3 centre;        ///< at time 0, [length]
  Vector3 velocity;      ///< of the affine flow at the centre, [length/time]
  double radius;         ///< [length]
  double creation_time;  ///< earliest time at which it is valid, [time]
  // Address in the cells.
  Vector3 wrapped_centre;       ///< the centre, wrapped into the box, [length]
  Cells::BoxOffset box_offset;  ///< number of boxes between both
  int cell;
  int size_class;  ///< index of the size class

  Vector3 centre_at(double time) const { return centre + time * velocity; }
};

/// The bounding neighbourhoods of all bodies, and a search for pairs that can meet by linked cells.
/// Each class of sizes has its own cells, so that a few large bodies do not widen the cells of many
/// small ones.
class BoundingNeighbourhoods {
 public:
  /// Radius of a bounding neighbourhood over the radius of the largest body of its size class, [1].
  double margin = 0.6;
  /// Number of bodies in the box, including bodies that are absent on this process. Limits the
  /// number of cells.
  double bodies_in_box = 0.0;

  /// When a body needs a new neighbourhood, [time]: when its centre leaves the current one, or when
  /// the lifetime of that in a deforming box ends.
  double exit_time(int body, const VersionedFlight& flight) const {
    const BoundingNeighbourhood& neighbourhood = neighbourhoods_[body];
    const Vector3 r = flight.position - neighbourhood.centre_at(flight.start_time);
    const Vector3 w = flight.velocity - neighbourhood.velocity;
    // Ahead of the exit, so that round-off cannot hide an encounter at the surface.
    constexpr double early = 1.0 - 1e-9;
    const double border = early * neighbourhood.radius * neighbourhood.radius;
    const double leave = flight.start_time + time_to_rise(dot(r, w), dot(w, w), dot(r, r) - border);
    return flow_ ? std::min(leave, neighbourhood.creation_time + flow_.lifetime()) : leave;
  }

  /// Whether the neighbourhood of a body is valid now and contains a position.
  bool neighbourhood_contains(int body, const Vector3& position, double now) const {
    const BoundingNeighbourhood& neighbourhood = neighbourhoods_[body];
    const Vector3 r = position - neighbourhood.centre_at(now);
    return dot(r, r) <= neighbourhood.radius * neighbourhood.radius &&
           !(flow_ && now < neighbourhood.creation_time);
  }

 protected:
  /// Creates the neighbourhoods of all bodies. `largest_ratio`: PairRules::largest_ratio(). In a
  /// deforming box a neighbourhood is valid for `lifetime` [time].
  void build_neighbourhoods(const PeriodicBox& box, const std::vector<HardSphere>& bodies,
                            const std::vector<VersionedFlight>& flights, double largest_ratio,
                            double now, double lifetime) {
    flow_.set(box, lifetime);
    bodies_ = &bodies;
    largest_ratio_ = largest_ratio;
    neighbourhoods_.resize(bodies.size());
    set_classes(now);
    for (int i = 0; i < static_cast<int>(neighbourhoods_.size()); i++)
      centre_ahead_of_body(i, flights[i], now);
    fill_cells();
  }

  /// Shifts the time origin to `now`. In a box that does not deform nothing depends on it.
  void shift_time_origin_of_neighbourhoods(double now) {
    if (!flow_) return;
    flow_.shift_time_origin(now);
    widths_valid_until_ = -never;
    for (BoundingNeighbourhood& neighbourhood : neighbourhoods_) {
      neighbourhood.creation_time -= now;
      set_centre(neighbourhood, neighbourhood.centre_at(now), 0.0);
    }
    fill_cells();
  }

  const BoxFlow& flow() const { return flow_; }
  const HardSphere& body(int i) const { return (*bodies_)[i]; }
  const BoundingNeighbourhood& neighbourhood(int body) const { return neighbourhoods_[body]; }

  /// Gives a body a new neighbourhood, which is valid from the time `valid_from` on. Searches find
  /// the former one, too, until remove_from_cells().
  void recentre_neighbourhood(int body, const VersionedFlight& flight, double now,
                              double valid_from) {
    centre_ahead_of_body(body, flight, now);
    neighbourhoods_[body].creation_time = valid_from;
    insert_into_cells(body);
  }

  /// Renumbers bodies. Removed bodies have left the cells already; new ones have no neighbourhood
  /// yet.
  void renumber_neighbourhoods(const BodyRenumbering& renumbering) {
    for (const int n : renumbering.changed()) {
      if (renumbering.old_number(n) < 0) continue;
      const BoundingNeighbourhood& neighbourhood = neighbourhoods_[renumbering.old_number(n)];
      cells_.renumber(neighbourhood.cell, neighbourhood.wrapped_centre, renumbering.old_number(n),
                      neighbourhood.box_offset, n);
    }
    renumbering.reorder(neighbourhoods_);
  }

  /// Sets the size class of a new body. Returns false if build_neighbourhoods() has not created
  /// this class or if the body is larger than all of it.
  bool assign_size_class(int i) {
    const double radius = body(i).radius;
    const int size = size_class_of(radius);
    if (size >= static_cast<int>(classes_.size()) || radius > classes_[size].largest_radius)
      return false;
    neighbourhoods_[i].size_class = size;
    return true;
  }

  /// Removes a current or former neighbourhood of a body from the cells.
  void remove_from_cells(int body, const BoundingNeighbourhood& neighbourhood) {
    cells_.remove(neighbourhood.cell, neighbourhood.wrapped_centre, body, neighbourhood.box_offset);
  }

  /// Calls near(j, boxes, squared_distance) for all neighbourhoods that may be close enough to that
  /// of body i for the bodies to meet. `boxes` is the image of j. The squared distance is the least
  /// one of both centres during the next lifetime, [length^2].
  template <class Near>
  void for_each_near(int i, double now, const Near& near) {
    if (now > widths_valid_until_) update_inverse_widths(now);
    for (const SizeClass& c : classes_)
      if (c.members > 0) search_size_class(c, i, now, near);
  }

  /// Whether i and the image of j with a displacement [length] can come closer than a distance
  /// [length] during the next lifetime, while both are in their neighbourhoods.
  bool can_come_within(double distance, int i, int j, const Vector3& displacement,
                       double now) const {
    const Vector3 r = neighbourhoods_[j].centre - neighbourhoods_[i].centre + displacement;
    const double reach = distance + neighbourhoods_[i].radius + neighbourhoods_[j].radius;
    return flow_.least_squared_distance(r, now) < reach * reach;
  }

  double neighbourhood_bytes() const {
    return cells_.bytes() +
           static_cast<double>(neighbourhoods_.capacity() * sizeof(BoundingNeighbourhood));
  }

 private:
  struct SizeClass {
    double largest_radius = 0.0;
    double neighbourhood_radius = 0.0;
    int members = 0;
    int cells[3] = {1, 1, 1};
    int first_cell = 0;
  };
  struct CellRange {  // of cells
    int first, last;
  };

  /// Bodies whose radii differ by a factor of up to two share a class.
  void set_classes(double now) {
    least_radius_ = never;
    for (const HardSphere& b : *bodies_)
      if (b.radius > 0.0) least_radius_ = std::min(least_radius_, b.radius);
    classes_.clear();
    for (std::size_t i = 0; i < neighbourhoods_.size(); i++) {
      const double radius = (*bodies_)[i].radius;
      const int size = size_class_of(radius);
      if (size >= static_cast<int>(classes_.size())) classes_.resize(size + 1);
      SizeClass& c = classes_[size];
      c.largest_radius = std::max(c.largest_radius, radius);
      c.members++;
      neighbourhoods_[i].size_class = size;
    }
    update_inverse_widths(now);
    number_of_cells_ = 0;
    for (SizeClass& c : classes_) {
      c.neighbourhood_radius = margin * c.largest_radius;
      set_cells(c);
      c.first_cell = number_of_cells_;
      number_of_cells_ += c.cells[0] * c.cells[1] * c.cells[2];
    }
  }

  int size_class_of(double radius) const {
    return radius > least_radius_ ? static_cast<int>(std::log2(radius / least_radius_)) : 0;
  }

  /// Updates the bound on the inverse widths of the box for the lifetimes of two neighbourhoods.
  void update_inverse_widths(double now) {
    const double later = flow_ ? now + 2.0 * flow_.lifetime() : now;
    const auto first = PeriodicBox::inverse_widths(flow_.box().edges_at(now));
    const auto last = PeriodicBox::inverse_widths(flow_.box().edges_at(later));
    for (int k = 0; k < 3; k++) inverse_widths_[k] = std::max(first[k], last[k]);
    widths_valid_until_ = flow_ ? now + flow_.lifetime() : never;
  }

  /// Cells are as wide as the largest distance of two neighbours of the class. Their number is
  /// limited in proportion to the number of bodies.
  void set_cells(SizeClass& c) {
    const double reach = 2.0 * (largest_ratio_ * c.largest_radius + c.neighbourhood_radius);
    double number[3], all = 1.0;
    for (int k = 0; k < 3; k++) {
      number[k] = reach > 0.0 ? std::max(1.0, std::floor(1.0 / (reach * inverse_widths_[k]))) : 1.0;
      all *= number[k];
    }
    const double most = 8.0 + 2.0 * bodies_in_box;
    const double shrink = all > most ? std::cbrt(all / most) : 1.0;
    for (int k = 0; k < 3; k++)
      c.cells[k] = static_cast<int>(std::max(1.0, std::floor(number[k] / shrink)));
  }

  /// Centres a neighbourhood ahead of its body on the flight, so that the body stays in it for
  /// longer.
  void centre_ahead_of_body(int body, const VersionedFlight& flight, double now) {
    BoundingNeighbourhood& neighbourhood = neighbourhoods_[body];
    neighbourhood.radius = classes_[neighbourhood.size_class].neighbourhood_radius;
    neighbourhood.creation_time = now;
    const Vector3 position = flight.at(now);
    constexpr double ahead = 0.7;
    const Vector3 w = flight.velocity - flow_.velocity(flow_.fraction(position, now));
    const double speed = norm(w);
    set_centre(neighbourhood,
               speed > 0.0 ? position + (ahead * neighbourhood.radius / speed) * w : position, now);
  }

  /// Sets the centre [length] at a time. A centre outside a box that is not periodic belongs to the
  /// outermost cell.
  void set_centre(BoundingNeighbourhood& neighbourhood, const Vector3& position, double now) {
    const PeriodicBox& box = flow_.box();
    const Vector3 fraction = flow_.fraction(position, now);
    neighbourhood.centre = flow_ ? flow_.position(fraction) : position;
    neighbourhood.velocity = flow_.velocity(fraction);
    const double f[] = {fraction.x, fraction.y, fraction.z};
    const SizeClass& c = classes_[neighbourhood.size_class];
    double box_offset[3];
    int cells[3];
    for (int k = 0; k < 3; k++) {
      box_offset[k] = box.periodic[k] ? std::floor(f[k]) : 0.0;
      neighbourhood.box_offset[k] = static_cast<int>(box_offset[k]);
      cells[k] = static_cast<int>(
          std::clamp(std::floor((f[k] - box_offset[k]) * c.cells[k]), 0.0, c.cells[k] - 1.0));
    }
    neighbourhood.wrapped_centre =
        neighbourhood.centre - box.edges * Vector3{box_offset[0], box_offset[1], box_offset[2]};
    neighbourhood.cell = c.first_cell + cells[0] + c.cells[0] * (cells[1] + c.cells[1] * cells[2]);
  }

  void insert_into_cells(int body) {
    const BoundingNeighbourhood& neighbourhood = neighbourhoods_[body];
    cells_.add(neighbourhood.cell, neighbourhood.wrapped_centre, body, neighbourhood.box_offset);
  }

  void fill_cells() {
    std::vector<int> sizes(number_of_cells_, 0);
    int most = 0;
    for (const BoundingNeighbourhood& neighbourhood : neighbourhoods_)
      most = std::max(most, ++sizes[neighbourhood.cell]);
    cells_.reset(number_of_cells_, most + 1);
    for (int i = 0; i < static_cast<int>(neighbourhoods_.size()); i++) insert_into_cells(i);
  }

  /// Searches the cells of a size class. Cells beyond a periodic boundary are those of the next
  /// box.
  template <class Near>
  void search_size_class(const SizeClass& c, int i, double now, const Near& near) {
    const BoundingNeighbourhood& neighbourhood = neighbourhoods_[i];
    const double reach = largest_ratio_ * (body(i).radius + c.largest_radius) +
                         neighbourhood.radius + c.neighbourhood_radius;
    const Vector3 fraction = flow_.fraction(neighbourhood.wrapped_centre, 0.0);
    const CellRange zs = cell_range(c, 2, fraction.z, reach * inverse_widths_[2]);
    const CellRange ys = cell_range(c, 1, fraction.y, reach * inverse_widths_[1]);
    const CellRange xs = cell_range(c, 0, fraction.x, reach * inverse_widths_[0]);
    for (int z = zs.first; z <= zs.last; z++) {
      const int offset_z = boxes_away(z, c.cells[2]);
      for (int y = ys.first; y <= ys.last; y++) {
        const int offset_y = boxes_away(y, c.cells[1]);
        const int row = c.first_cell + c.cells[0] * (y - offset_y * c.cells[1] +
                                                     c.cells[1] * (z - offset_z * c.cells[2]));
        for (int x = xs.first; x <= xs.last;) {
          const int offset_x = boxes_away(x, c.cells[0]);
          const int last = std::min(xs.last, (offset_x + 1) * c.cells[0] - 1);
          search_cells(row + x - offset_x * c.cells[0], last - x + 1, i,
                       {offset_x, offset_y, offset_z}, now, reach * reach, near);
          x = last + 1;
        }
      }
    }
  }

  /// The range of cells along an axis within `reach` of a position, both in fractions of the box.
  CellRange cell_range(const SizeClass& c, int axis, double position, double reach) const {
    const int first = static_cast<int>(std::floor((position - reach) * c.cells[axis]));
    const int last = static_cast<int>(std::floor((position + reach) * c.cells[axis]));
    if (flow_.box().periodic[axis]) return {first, last};
    return {std::clamp(first, 0, c.cells[axis] - 1), std::clamp(last, 0, c.cells[axis] - 1)};
  }

  static int boxes_away(int cell, int cells) {
    return cell >= 0 && cell < cells ? 0 : static_cast<int>(std::floor(double(cell) / cells));
  }

  /// Searches contiguous cells of the periodic box `box_offset` for centres closer than the square
  /// root of `limit`.
  template <class Near>
  void search_cells(int first_cell, int cells, int i, const Cells::BoxOffset& box_offset,
                    double now, double limit, const Near& near) {
    Vector3 from = neighbourhoods_[i].wrapped_centre;
    if (box_offset[0] != 0 || box_offset[1] != 0 || box_offset[2] != 0)
      from -= flow_.box().edges *
              Vector3{double(box_offset[0]), double(box_offset[1]), double(box_offset[2])};
    const Cells::BoxOffset& offset_i = neighbourhoods_[i].box_offset;
    const auto found = [&](int j, const Cells::BoxOffset& offset_j, double square) {
      if (j == i) return;
      near(j,
           Cells::BoxOffset{box_offset[0] + offset_i[0] - offset_j[0],
                            box_offset[1] + offset_i[1] - offset_j[1],
                            box_offset[2] + offset_i[2] - offset_j[2]},
           square);
    };
    flow_.with_least_squared_distance(now, [&](const auto& square) {
      cells_.for_each_near(first_cell, cells, from, limit, square, found);
    });
  }

  BoxFlow flow_;
  const std::vector<HardSphere>* bodies_ = nullptr;
  double largest_ratio_ = 1.0;
  double least_radius_ = never;
  std::array<double, 3> inverse_widths_{};
  double widths_valid_until_ = -never;  // end of the validity of inverse_widths_, [time]
  std::vector<SizeClass> classes_;
  std::vector<BoundingNeighbourhood> neighbourhoods_;
  int number_of_cells_ = 0;
  Cells cells_;
};

}  // namespace cohesion::hard_sphere
