// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "vector3.h"

namespace cohesion::hard_sphere {

/// Linked cells of points. Each point has a body and a periodic box relative to the body. All cells
/// have the same capacity and are contiguous in memory, so that one loop searches a row of cells.
/// Unused slots hold a point at a very large distance.
class Cells {
 public:
  using BoxOffset = std::array<int, 3>;

  /// Empties all cells, and sets their number and capacity.
  void reset(std::size_t cells, int capacity) {
    capacity_ = capacity;
    sizes_.assign(cells, 0);
    for (std::vector<double>* const k : {&x_, &y_, &z_}) k->assign(cells * capacity, nowhere);
    bodies_.assign(cells * capacity, -1);
    box_offsets_.resize(cells * capacity);
  }

  void add(int cell, const Vector3& point, int body, const BoxOffset& box_offset) {
    if (sizes_[cell] == capacity_) grow();
    put(first(cell) + sizes_[cell]++, point, body, box_offset);
  }

  /// Removes the point of a body.
  void remove(int cell, const Vector3& point, int body, const BoxOffset& box_offset) {
    const std::size_t last = first(cell) + sizes_[cell] - 1;
    put(find(cell, point, body, box_offset), {x_[last], y_[last], z_[last]}, bodies_[last],
        box_offsets_[last]);
    put(last, {nowhere, nowhere, nowhere}, -1, {});
    sizes_[cell]--;
  }

  /// Changes the number of the body of a point.
  void renumber(int cell, const Vector3& point, int body, const BoxOffset& box_offset, int number) {
    bodies_[find(cell, point, body, box_offset)] = number;
  }

  /// Calls near(body, box_offset, square) for each point of `cells` contiguous cells for which
  /// square_of(r) is below `limit`; r is the vector from `from` to the point.
  template <class SquareOf, class Near>
  void for_each_near(int first_cell, int cells, const Vector3& from, double limit,
                     const SquareOf& square_of, const Near& near) {
    const std::size_t begin = first(first_cell), size = static_cast<std::size_t>(cells) * capacity_;
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
      count += squares[n] < limit;
    }
    for (int k = 0; k < count; k++)
      near(bodies_[begin + near_[k]], box_offsets_[begin + near_[k]], squares[near_[k]]);
  }

  double bytes() const {
    return static_cast<double>(sizes_.capacity() * sizeof(int) +
                               x_.capacity() *
                                   (3 * sizeof(double) + sizeof(int) + sizeof(BoxOffset)));
  }

 private:
  // Large, but its square does not overflow.
  static constexpr double nowhere = 1e100;

  std::size_t first(int cell) const { return static_cast<std::size_t>(cell) * capacity_; }

  std::size_t find(int cell, const Vector3& point, int body, const BoxOffset& box_offset) const {
    const std::size_t last = first(cell) + sizes_[cell] - 1;
    std::size_t n = first(cell);
    while (n < last && !(bodies_[n] == body && box_offsets_[n] == box_offset && x_[n] == point.x &&
                         y_[n] == point.y && z_[n] == point.z))
      n++;
    return n;
  }

  void put(std::size_t n, const Vector3& point, int body, const BoxOffset& box_offset) {
    x_[n] = point.x, y_[n] = point.y, z_[n] = point.z;
    bodies_[n] = body;
    box_offsets_[n] = box_offset;
  }

  /// Increases the capacity of all cells.
  void grow() {
    const Cells old = *this;
    reset(old.sizes_.size(), old.capacity_ + 2 + old.capacity_ / 2);
    for (std::size_t cell = 0; cell < old.sizes_.size(); cell++)
      for (int k = 0; k < old.sizes_[cell]; k++) {
        const std::size_t n = cell * old.capacity_ + k;
        add(static_cast<int>(cell), {old.x_[n], old.y_[n], old.z_[n]}, old.bodies_[n],
            old.box_offsets_[n]);
      }
  }

  int capacity_ = 1;
  std::vector<int> sizes_;
  std::vector<double> x_, y_, z_;
  std::vector<int> bodies_;
  std::vector<BoxOffset> box_offsets_;
  std::vector<double> squares_;
  std::vector<int> near_;
};

}  // namespace cohesion::hard_sphere
