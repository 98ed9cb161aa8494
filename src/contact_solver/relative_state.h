// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector3.h"

namespace cohesion::contact_solver {

/// Position and velocity of particle j relative to particle i (of the foot of the normal relative
/// to the particle's centre, at a wall).
struct RelativeState {
  Vector3 separation;
  Vector3 velocity;
};

/// The interval of time of a step about its time level: positions x_n and staggered velocities of
/// n-1/2 are half a step apart. The first step of a run begins at the time level: before = 0.
struct StepWindow {
  double before;  ///< [time]
  double after;   ///< [time]
  double length() const { return before + after; }
};

}  // namespace cohesion::contact_solver
