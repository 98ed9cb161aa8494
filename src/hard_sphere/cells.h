// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "vector3.h"

namespace cohesion::hard_sphere {

/// Points in cells, each with a body that it belongs to and how many boxes away from there the body
/// is. All cells have the same room, and cells that follow each other lie side by side: so that
/// many of them can be looked through in one loop. A place that is not taken is infinitely far
/// away.
class Cells {
 public:
  using Folds = std::array<int, 3>;

  /// Empties all cells and sets their number and the room of each.
  void reset(std::size_t cells, int room) {
    room_ = room;
    sizes_.assign(cells, 0);
    for (std::vector<double>* const k : {&x_, &y_, &z_}) k->assign(cells * room, nowhere);
    bodies_.assign(cells * room, -1);
    folds_.resize(cells * room);
  }

  void add(int cell, const Vector3& point, int body, const Folds& folds) {
    if (sizes_[cell] == room_) grow();
    put(first(cell) + sizes_[cell]++, point, body, folds);
  }

  /// Takes out the point of a body at this place.
  void remove(int cell, const Vector3& point, int body, const Folds& folds) {
    const std::size_t last = first(cell) + sizes_[cell] - 1;
    put(find(cell, point, body, folds), {x_[last], y_[last], z_[last]}, bodies_[last],
        folds_[last]);
    put(last, {nowhere, nowhere, nowhere}, -1, {});
    sizes_[cell]--;
  }

  /// Gives the body of a point at this place another number.
  void renumber(int cell, const Vector3& point, int body, const Folds& folds, int number) {
    bodies_[find(cell, point, body, folds)] = number;
  }

  /// Calls near(body, folds, square) for each point of `cells` cells from the first on for which
  /// square_of(r), r from `from` to the point, is below `most`.
  template <class SquareOf, class Near>
  void look_through(int first_cell, int cells, const Vector3& from, double most,
                    const SquareOf& square_of, const Near& near) {
    const std::size_t begin = first(first_cell), size = static_cast<std::size_t>(cells) * room_;
    if (size > squares_.size()) {
      squares_.resize(2 * size);
      near_.resize(2 * size);
    }
    const double* const x = x_.data() + begin;
    const double* const y = y_.data() + begin;
    const double* const z = z_.data() + begin;
    double* const squares = squares_.data();
    for (std::size_t n = 0; n < size; n++)
      squares[n] = square_of(Vector3{x[n] - from.x, y[n] - from.y, z[n] - from.z});
    int count = 0;
    for (std::size_t n = 0; n < size; n++) {
      near_[count] = static_cast<int>(n);
      count += squares[n] < most;
    }
    for (int k = 0; k < count; k++)
      near(bodies_[begin + near_[k]], folds_[begin + near_[k]], squares[near_[k]]);
  }

  double bytes() const {
    return static_cast<double>(sizes_.capacity() * sizeof(int) +
                               x_.capacity() * (3 * sizeof(double) + sizeof(int) + sizeof(Folds)));
  }

 private:
  // Its square is no number that overflows.
  static constexpr double nowhere = 1e100;

  std::size_t first(int cell) const { return static_cast<std::size_t>(cell) * room_; }

  std::size_t find(int cell, const Vector3& point, int body, const Folds& folds) const {
    const std::size_t last = first(cell) + sizes_[cell] - 1;
    std::size_t n = first(cell);
    while (n < last && !(bodies_[n] == body && folds_[n] == folds && x_[n] == point.x &&
                         y_[n] == point.y && z_[n] == point.z))
      n++;
    return n;
  }

  void put(std::size_t n, const Vector3& point, int body, const Folds& folds) {
    x_[n] = point.x, y_[n] = point.y, z_[n] = point.z;
    bodies_[n] = body;
    folds_[n] = folds;
  }

  /// Gives all cells more room.
  void grow() {
    const Cells old = *this;
    reset(old.sizes_.size(), old.room_ + 2 + old.room_ / 2);
    for (std::size_t cell = 0; cell < old.sizes_.size(); cell++)
      for (int k = 0; k < old.sizes_[cell]; k++) {
        const std::size_t n = cell * old.room_ + k;
        add(static_cast<int>(cell), {old.x_[n], old.y_[n], old.z_[n]}, old.bodies_[n],
            old.folds_[n]);
      }
  }

  int room_ = 1;
  std::vector<int> sizes_;
  std::vector<double> x_, y_, z_;
  std::vector<int> bodies_;
  std::vector<Folds> folds_;
  std::vector<double> squares_;
  std::vector<int> near_;
};

}  // namespace cohesion::hard_sphere
