// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>

#include "bubbles/bubble.h"

namespace cohesion::bubbles {

/// A bubble above a size breaks into two equal ones, side by side in a horizontal plane, their
/// surfaces a tenth of their diameter apart, with its velocity: volume, mass, momentum and centre
/// of mass are kept. Both rest for a while: they do not merge. The direction goes around from
/// number to number by the golden angle, and on by eighths of a turn until both halves are in the
/// box; where none fits the bubble stays as it is. The rule is one of the simplest, with no time
/// scale of its own but that rest.
inline std::optional<std::pair<Bubble, Bubble>> broken(const Bubble& whole, long new_number,
                                                       const BubbleBox& box, double rests_until) {
  constexpr double golden_angle = 2.399963229728653, gap = 0.1;
  constexpr int directions = 8;
  Bubble half = whole;
  half.mass = 0.5 * whole.mass;
  half.radius = radius_of(0.5 * whole.volume());
  half.rests_until = rests_until;
  for (int k = 0; k < directions; k++) {
    const double angle =
        golden_angle * static_cast<double>(whole.number) + 2.0 * pi * k / directions;
    const double away = (1.0 + gap) * half.radius;
    const Vector3 offset{away * std::cos(angle), away * std::sin(angle), 0.0};
    std::pair<Bubble, Bubble> halves(half, half);
    halves.first.position += offset;
    halves.second.position -= offset;
    halves.second.number = new_number;
    if (box.holds(halves.first.position, half.radius) &&
        box.holds(halves.second.position, half.radius))
      return halves;
  }
  return std::nullopt;
}

}  // namespace cohesion::bubbles
