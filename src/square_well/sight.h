// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::square_well {

// A scheme that looks at its pairs once a step (sampled_contact/sampled_well.h) and no farther than
// it must: a pair that has left its well pays D where it is found outside, so it must be seen
// there. `radii`: the sum of both; beside a wall that of the one sphere.

/// Largest gap at which a pair is seen, [length]. largest_ratio: r_out/r of the widest well;
/// margin: how far beyond, over the radius, [1].
inline double sight(double largest_ratio, double margin, double radii) {
  return (largest_ratio - 1.0 + margin) * radii;
}

/// Whether a pair at `gap` [length] is beyond `sight` [length] when it has flown for `step` [time]
/// with the normal speed of approach `approach` [speed].
inline bool flies_out_of_sight(double gap, double approach, double step, double sight) {
  return gap - step * approach > sight;
}

/// Whether a pair is too slow to do so, from wherever in its well and in whatever direction: its
/// way in a step is within the margin. speed_squared: of the relative velocity.
inline bool stays_in_sight(double speed_squared, double step, double margin, double radii_squared) {
  return speed_squared * (step * step) <= margin * margin * radii_squared;
}

}  // namespace cohesion::square_well
