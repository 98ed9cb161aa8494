// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::contact_solver {

/// The interval of time of a step about its time level: positions x_n and staggered velocities of
/// n-1/2 are half a step apart. The first step of a run begins at the time level: before = 0.
struct StepWindow {
  double before;  ///< [time]
  double after;   ///< [time]
  double length() const { return before + after; }
};

}  // namespace cohesion::contact_solver
