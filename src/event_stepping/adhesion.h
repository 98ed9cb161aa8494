// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::event_stepping {

/// A short-ranged attraction as the event scheme sees it: a constant force from the gap `range`
/// inwards, in contact too, and a tail outside it that is so thin that it is crossed at once.
struct Adhesion {
  double force = 0.0;        ///< F_ad, [force]
  double range = 0.0;        ///< H_cut, [length]
  double tail_energy = 0.0;  ///< energy between the tail's end and H_cut, [energy]
};

/// The adhesion of a pair under `law` (hamaker/law.h): constant force up to the surface cut-off,
/// all of the tail's energy at it.
template <class Law, class Geometry>
Adhesion adhesion_of(const Law& law, const Geometry& geometry) {
  const double force = law.adhesion_force(geometry);
  if (force == 0.0) return {};
  return {force, law.surface_cutoff(), law.tail_energy(geometry)};
}

}  // namespace cohesion::event_stepping
