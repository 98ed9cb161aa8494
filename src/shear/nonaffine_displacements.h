// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "prefetch.h"
#include "vector3.h"

namespace cohesion::shear {

/// The shear of a whole box, flow along x, about a height that it leaves where it is: by a strain,
/// as displacements [length] show it, or at a rate [1/time], as velocities [length/time] do.
struct BoxShear {
  double amount;  ///< strain, or rate [1/time]
  double middle;  ///< the height that does not move, [length]

  /// The affine displacement or velocity along the flow at height y [length]: that of what is
  /// carried with the box.
  double affine(double y) const { return amount * (y - middle); }
  /// The nonaffine part of a displacement that began at height y, or of a velocity there; the same
  /// for a particle and all its images.
  double nonaffine(double along, double y) const { return along - affine(y); }
};

/// The nonaffine displacements of particles since a list of neighbours was made: how far each has
/// moved beyond the shear of the box, which is what list_margin() bounds.
class NonaffineDisplacements {
 public:
  /// Displacements count from here on. `positions`: x, y, z of `count` particles [length]; `tilt`
  /// of the box: by how much the image above it is shifted [length].
  void set_reference(const double* positions, std::size_t count, double tilt) {
    positions_.assign(positions, positions + 3 * count);
    tilt_ = tilt;
  }

  std::size_t count() const { return positions_.size() / 3; }

  /// The shear since the reference of a box that has this tilt and height [length].
  BoxShear shear_since_reference(double tilt, double height, double middle) const {
    return {(tilt - tilt_) / height, middle};
  }

  /// Asks for the memory of a particle's reference.
  void foresee(std::size_t i) const { prefetch_numbers(positions_.data() + 3 * i, 3); }

  /// Square of the nonaffine displacement of particle i, which is at `position`, [length^2].
  double squared(std::size_t i, const Vector3& position, const BoxShear& shear) const {
    const double* const reference = positions_.data() + 3 * i;
    const double x = shear.nonaffine(position.x - reference[0], reference[1]);
    const double y = position.y - reference[1], z = position.z - reference[2];
    return x * x + y * y + z * z;
  }

 private:
  std::vector<double> positions_;
  double tilt_ = 0.0;
};

}  // namespace cohesion::shear
