// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "event_stepping/normal_motion.h"
#include "vector3.h"

namespace cohesion::event_stepping {

/// Position and velocity of particle j relative to particle i (of the foot of the normal relative
/// to the particle's centre, at a wall).
struct RelativeState {
  Vector3 separation;
  Vector3 velocity;
};

/// The interval of time that one grid step stands for, as seen from the grid point: positions x_n
/// meet the velocities of n-1/2, so that the true state at n-1/2 is one half step of straight
/// flight away. The first step of a run starts at the grid point itself: before = 0.
struct StepWindow {
  double before;  ///< [time]
  double after;   ///< [time]
  double length() const { return before + after; }
};

/// What one step does to a pair, beside what a load does to one that flies: added to the relative
/// state at the grid point, it makes the grid follow the true motion.
struct PairStep {
  RelativeState change{};
  NormalRecord normal{};
  double overlap_at_end = 0.0;  ///< negative: gap
  bool inside = false;          ///< inside the range of the adhesion at the end of the step
  bool interacts = true;        ///< false: the pair flies, and nothing changes

  /// Sets `change`: from where the pair would have flown under `load` [length/time^2] to `end`.
  void set_change(const RelativeState& grid, const StepWindow& window, const Vector3& load,
                  const RelativeState& end) {
    const double length = window.length();
    change.velocity = end.velocity - grid.velocity - length * load;
    change.separation = end.separation - window.after * end.velocity - grid.separation +
                        (length * (window.after - 0.5 * length)) * load;
  }
};

}  // namespace cohesion::event_stepping
