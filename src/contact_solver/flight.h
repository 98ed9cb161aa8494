// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace cohesion::contact_solver {

/// The true motion of a pair within a step: straight across the normal at its start, along it under
/// a constant external acceleration. The sideways speed follows from the angular momentum.
struct Flight {
  double distance;  ///< of the centres, or from the wall, [length]
  double radial;    ///< rate of it, [length/time]
  double sideways;  ///< speed across the normal, [length/time]

  /// Acceleration of the distance, [length/time^2]. `external`: by other forces.
  double outward(double external) const { return external + sideways * sideways / distance; }

  /// The flight a `time` [time] later.
  Flight after(double time, double external) const {
    const double along = distance + time * (radial + 0.5 * time * external);
    const double speed = radial + time * external;
    const double across = time * sideways;
    const double end = std::sqrt(along * along + across * across);
    return {end, (along * speed + across * sideways) / end,
            (along * sideways - across * speed) / end};
  }

  /// The flight where it is at the distance `end`, which it meets after `t`, at most `time`, on a
  /// parabola; that leaves out how the pair turns on its way. Corrects t.
  Flight at_meeting(double& t, double time, double external, double end) const {
    Flight now = after(t, external);
    const bool in = now.radial < 0.0;
    for (int k = 0; k < 2 && now.radial != 0.0 && in == (now.radial < 0.0); k++) {
      t = std::min(std::max(t + (end - now.distance) / now.radial, 0.0), time);
      now = after(t, external);
    }
    return now;
  }
};

}  // namespace cohesion::contact_solver
