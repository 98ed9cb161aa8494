// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <unordered_map>
#include <vector>

#include "hard_sphere/periodic_box.h"

namespace cohesion::hard_sphere {

/// Periodic image of a body: offsets of its position and velocity.
struct PeriodicImage {
  Vector3 displacement;  ///< at time 0, [length]
  Vector3 velocity;      ///< [length/time]
  int opposite = 0;      ///< number of the opposite image
  Vector3 boxes;         ///< offset in boxes along each edge

  Vector3 displacement_at(double time) const { return displacement + time * velocity; }
};

/// The images that occur in neighbour lists, numbered in the order of their first use. Image 0 has
/// no offset.
class PeriodicImages {
 public:
  /// Discards all images, and sets the box.
  void reset(const PeriodicBox& box) {
    box_ = box;
    images_.assign(1, PeriodicImage{});
    near_numbers_.fill(0);
    far_numbers_.clear();
  }

  /// Shifts the time origin to `now`.
  void shift_time_origin(double now) {
    box_.edges = box_.edges_at(now);
    for (PeriodicImage& image : images_) image.displacement = box_.edges * image.boxes;
  }

  const PeriodicImage& operator[](int number) const { return images_[number]; }

  /// The number of the image with an offset in boxes; a new one if it has none yet.
  int find_number(const std::array<int, 3>& boxes) {
    const auto [x, y, z] = boxes;
    if (x == 0 && y == 0 && z == 0) return 0;
    int& number = number_slot(x, y, z);
    if (number == 0) {
      number = static_cast<int>(images_.size());
      add(x, y, z, number + 1);
      number_slot(-x, -y, -z) = number + 1;
      add(-x, -y, -z, number);
    }
    return number;
  }

 private:
  /// Where the number of an image is stored; 0: none yet. The reference stays valid when others are
  /// added.
  int& number_slot(int x, int y, int z) {
    if (std::abs(x) <= 1 && std::abs(y) <= 1 && std::abs(z) <= 1)
      return near_numbers_[(x + 1) + 3 * (y + 1) + 9 * (z + 1)];
    constexpr std::int64_t most = 1 << 20;
    return far_numbers_[(x * most + y) * most + z];
  }

  void add(int x, int y, int z, int opposite) {
    const Vector3 boxes{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    images_.push_back({box_.edges * boxes, box_.rates * boxes, opposite, boxes});
  }

  PeriodicBox box_;
  std::vector<PeriodicImage> images_;
  // Numbers of the 26 adjacent boxes, which are nearly all that occur, and of boxes farther away.
  std::array<int, 27> near_numbers_{};
  std::unordered_map<std::int64_t, int> far_numbers_;
};

}  // namespace cohesion::hard_sphere
