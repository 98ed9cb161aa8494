// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <unordered_map>
#include <vector>

#include "hard_sphere/periodic_box.h"

namespace cohesion::hard_sphere {

/// Periodic image of a body: what it adds to a place and to a velocity.
struct Image {
  Vector3 displacement;  ///< at time 0, [length]
  Vector3 velocity;      ///< [length/time]
  int reverse = 0;       ///< the number of the opposite one
  Vector3 boxes;         ///< how many boxes away it is

  Vector3 at(double time) const { return displacement + time * velocity; }
};

/// The images in which bodies meet, numbered as they are asked for. Number 0 is no box away.
class Images {
 public:
  /// Forgets all, and takes those of another box from here on.
  void reset(const PeriodicBox& box) {
    box_ = box;
    images_.assign(1, Image{});
    near_.fill(0);
    far_.clear();
  }

  /// Time 0 is at the time `now` from here on.
  void set_clock_back(double now) {
    box_.edges = box_.at(now);
    for (Image& image : images_) image.displacement = box_.edges * image.boxes;
  }

  const Image& operator[](int number) const { return images_[number]; }

  /// The number of the image that is some boxes away.
  int number_of(const std::array<int, 3>& boxes) {
    const auto [x, y, z] = boxes;
    if (x == 0 && y == 0 && z == 0) return 0;
    int& number = known(x, y, z);
    if (number == 0) {
      number = static_cast<int>(images_.size());
      add(x, y, z, number + 1);
      known(-x, -y, -z) = number + 1;
      add(-x, -y, -z, number);
    }
    return number;
  }

 private:
  /// Where the number of an image is kept; 0: it has none yet. The place stays when others come.
  int& known(int x, int y, int z) {
    if (std::abs(x) <= 1 && std::abs(y) <= 1 && std::abs(z) <= 1)
      return near_[(x + 1) + 3 * (y + 1) + 9 * (z + 1)];
    constexpr std::int64_t most = 1 << 20;
    return far_[(x * most + y) * most + z];
  }

  void add(int x, int y, int z, int reverse) {
    const Vector3 boxes{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    images_.push_back({box_.edges * boxes, box_.rates * boxes, reverse, boxes});
  }

  PeriodicBox box_;
  std::vector<Image> images_;
  // Numbers: of the 26 boxes around, which are nearly all that are asked for, and of others.
  std::array<int, 27> near_{};
  std::unordered_map<std::int64_t, int> far_;
};

}  // namespace cohesion::hard_sphere
