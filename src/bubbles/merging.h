// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "bubbles/bubble.h"

namespace cohesion::bubbles {

/// Two bubbles that touch become one, of their volume, mass and momentum, at their centre of mass;
/// it has the smaller number of theirs. A third may merge with it the next time.
struct Merger {
  std::size_t into, gone;  ///< places in the list of bubbles
};

/// The bubble that two are together; `box` for how far they are from each other.
inline Bubble merged(const Bubble& into, const Bubble& gone, const BubbleBox& box) {
  Bubble one = into;
  one.mass = into.mass + gone.mass;
  const double share = gone.mass / one.mass;
  one.radius = radius_of(into.volume() + gone.volume());
  one.velocity += share * (gone.velocity - into.velocity);
  one.position += share * box.between(into.position, gone.position);
  one.rests_until = std::max(into.rests_until, gone.rests_until);
  return one;
}

/// Pairs of touching bubbles, smaller number first, in the order of both numbers: found by a sweep
/// along z, of which only neighbours within the largest diameter are compared.
inline std::vector<std::pair<std::size_t, std::size_t>> touching(const std::vector<Bubble>& bubbles,
                                                                 const BubbleBox& box) {
  std::vector<std::size_t> by_height(bubbles.size());
  double widest = 0.0;
  for (std::size_t i = 0; i < bubbles.size(); i++) {
    by_height[i] = i;
    widest = std::max(widest, 2.0 * bubbles[i].radius);
  }
  std::sort(by_height.begin(), by_height.end(), [&](std::size_t a, std::size_t b) {
    return bubbles[a].position.z < bubbles[b].position.z;
  });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const double height = box.high[2] - box.low[2];
  const auto compare = [&](std::size_t i, std::size_t j) {
    const double reach = bubbles[i].radius + bubbles[j].radius;
    if (norm(box.between(bubbles[i].position, bubbles[j].position)) > reach) return;
    pairs.push_back(bubbles[i].number < bubbles[j].number ? std::pair(i, j) : std::pair(j, i));
  };
  for (std::size_t a = 0; a < by_height.size(); a++)
    for (std::size_t b = a + 1; b < by_height.size(); b++) {
      const double apart = bubbles[by_height[b]].position.z - bubbles[by_height[a]].position.z;
      const bool far = apart > widest;
      if (far && !box.periodic[2]) break;
      if (far && height - apart > widest) continue;
      compare(by_height[a], by_height[b]);
    }
  std::sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
    return std::pair(bubbles[a.first].number, bubbles[a.second].number) <
           std::pair(bubbles[b.first].number, bubbles[b.second].number);
  });
  return pairs;
}

/// The mergers at a time: of touching pairs in the order of touching(), each bubble once, up to a
/// joint diameter of `largest` [length]; bubbles that rest are left out.
inline std::vector<Merger> mergers(const std::vector<Bubble>& bubbles, const BubbleBox& box,
                                   double largest, double time) {
  std::vector<Merger> found;
  std::vector<bool> taken(bubbles.size(), false);
  // Two halves of the largest are one of it again but for rounding.
  const double most = sphere_volume(0.5 * largest) * (1.0 + 1e-12);
  for (const auto& [i, j] : touching(bubbles, box)) {
    if (taken[i] || taken[j]) continue;
    if (bubbles[i].volume() + bubbles[j].volume() > most) continue;
    if (std::max(bubbles[i].rests_until, bubbles[j].rests_until) > time) continue;
    taken[i] = taken[j] = true;
    found.push_back({i, j});
  }
  return found;
}

}  // namespace cohesion::bubbles
