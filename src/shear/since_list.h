// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "vector3.h"

namespace cohesion::shear {

/// The shear of a whole box, flow along x, about a height that it leaves where it is: by a strain,
/// as displacements [length] show it, or at a rate [1/time], as velocities [length/time] do.
struct BoxShear {
  double amount;  ///< strain, or rate [1/time]
  double middle;  ///< the height that does not move, [length]

  /// Displacement or velocity along the flow of what is carried with the box at height y [length].
  double at(double y) const { return amount * (y - middle); }
  /// What is left of a displacement that began at height y, or of a velocity there; the same for a
  /// particle and all its images.
  double beyond(double along, double y) const { return along - at(y); }
};

/// Where particles and box were when a list of neighbours was made: how far each has moved since
/// beyond the shear of the box, which is what list_margin() bounds.
class SinceList {
 public:
  /// `places`: x, y, z of `count` particles [length]; `tilt` of the box: by how much the image
  /// above it is shifted [length].
  void begin(const double* places, std::size_t count, double tilt) {
    places_.assign(places, places + 3 * count);
    tilt_ = tilt;
  }

  std::size_t count() const { return places_.size() / 3; }

  /// The shear since then of a box that has this tilt and height [length] now.
  BoxShear sheared(double tilt, double height, double middle) const {
    return {(tilt - tilt_) / height, middle};
  }

  /// Square of the distance that particle i, which is at `place` now, has moved beyond the shear,
  /// [length^2].
  double strayed_squared(std::size_t i, const Vector3& place, const BoxShear& shear) const {
    const double* const then = places_.data() + 3 * i;
    const double x = shear.beyond(place.x - then[0], then[1]);
    const double y = place.y - then[1], z = place.z - then[2];
    return x * x + y * y + z * z;
  }

 private:
  std::vector<double> places_;
  double tilt_ = 0.0;
};

}  // namespace cohesion::shear
