// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::contact {

/// A short-ranged attraction as closed-form contact motion sees it: a constant force from the gap
/// H_cut inwards, in contact too, and a tail beyond it that is so thin that it is crossed at once.
struct Adhesion {
  double force = 0.0;        ///< F_ad, [force]
  double cutoff = 0.0;       ///< H_cut, [length]
  double tail_energy = 0.0;  ///< E_tail, [energy]: work of the attraction from far away to H_cut

  /// W = E_tail + F_ad H_cut, [energy]: what the pair gains on its way to first touch.
  double well_energy() const { return tail_energy + force * cutoff; }
};

/// The adhesion of a pair under `law` (hamaker/law.h); none at all when it has no force.
template <class Law, class Geometry>
Adhesion adhesion_of(const Law& law, const Geometry& geometry) {
  const double force = law.adhesion_force(geometry);
  if (force == 0.0) return {};
  return {force, law.surface_cutoff(), law.tail_energy(geometry)};
}

}  // namespace cohesion::contact
