// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace cohesion::shear {

/// The strain of a box that is sheared at a rate which may change between steps of a grid in time.
///
/// While rate and step stay the same the strain is worked out from the number of steps since they
/// changed, not summed up: n steps leave two roundings, not n, and it does not matter where a run
/// was stopped in between.
struct BoxStrain {
  double at_change = 0.0;           ///< strain when rate or step changed last
  std::int64_t step_of_change = 0;  ///< the step of the grid of that change
  double rate = 0.0;                ///< since then, [1/time]
  double time_step = 0.0;           ///< since then, [time]

  /// Strain at the end of step `step`, not before step_of_change.
  double at(std::int64_t step) const {
    return at_change + rate * (time_step * static_cast<double>(step - step_of_change));
  }

  /// Sets the rate and the time step from the end of step `step` on.
  void continue_with(std::int64_t step, double new_rate, double new_time_step) {
    if (new_rate == rate && new_time_step == time_step) return;
    *this = {at(step), step, new_rate, new_time_step};
  }
};

/// The shift of the periodic images across the gradient direction. Source: A. W. Lees, S. F.
/// Edwards, J. Phys. C 5 (1972) 1921. A lattice of images shifted by tilt along the flow is the
/// same for tilt and tilt + length.
struct ImageShift {
  double start = 0.0;   ///< tilt at strain 0, [length]
  double height = 1.0;  ///< of the box in the gradient direction, [length]
  double length = 1.0;  ///< of the box in the flow direction, [length]

  /// Shift of the image above without counting back whole lengths, [length].
  double whole(double strain) const { return start + strain * height; }
  /// Whole lengths between that and a tilt of the same lattice.
  double lengths_before(double strain, double tilt) const {
    return std::nearbyint((whole(strain) - tilt) / length);
  }
  /// Tilt after so many whole lengths were counted back, [length].
  double tilt(double strain, double lengths) const { return whole(strain) - lengths * length; }
  /// The velocity of the image above relative to the box, for a rate [1/time], [length/time].
  double velocity(double rate) const { return rate * height; }
};

}  // namespace cohesion::shear
