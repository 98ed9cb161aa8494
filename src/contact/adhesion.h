// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hamaker/tail.h"
#include "liquid_bridge/pull.h"

namespace cohesion::contact {

/// A short-ranged attraction as closed-form contact motion sees it: a constant force from the gap
/// H_cut inwards, in contact too, and a tail beyond it that acts at H_cut all at once. A load works
/// on the way through it: `tail` is the law from which the barrier under a load follows.
/// One that forms at touch, as a liquid bridge, acts in the gap only between two that have touched;
/// its force may fall over the gap.
struct Adhesion {
  double force = 0.0;        ///< F_ad, [force]
  double cutoff = 0.0;       ///< H_cut, [length]
  double tail_energy = 0.0;  ///< E_tail, [energy]: work of the attraction from far away to H_cut
  bool forms_at_touch = false;
  /// The law of the tail, not owned: it must outlive this. Null: the tail acts at an edge without
  /// width.
  const hamaker::Tail* tail = nullptr;
  double fall = 0.0;        ///< L of the pull of a bridge, [length]; 0: constant up to H_cut
  PairGeometry geometry{};  ///< of the pair, argument of `tail`

  bool attracts() const { return force > 0.0 || tail_energy > 0.0; }
  liquid_bridge::Pull pull() const { return {force, fall}; }
  /// W = E_tail + F_ad H_cut, [energy], with the work of a pull that falls in the place of F_ad
  /// H_cut: what the pair pays on its way from last touch.
  double well_energy() const { return tail_energy + pull().work(cutoff); }
  /// What it gains on its way to first touch, [energy].
  double approach_energy() const { return forms_at_touch ? 0.0 : well_energy(); }
};

/// The adhesion of a pair under `law` (hamaker/law.h), for closed forms: without `tail`. None at
/// all when the law has no force.
template <class Law>
Adhesion adhesion_of(const Law& law, const PairGeometry& geometry) {
  const double force = law.adhesion_force(geometry);
  if (force == 0.0) return {};
  return {force, law.surface_cutoff(), law.tail_energy(geometry), false, nullptr, 0.0, geometry};
}
/// The same for a solver: its `tail` points to `law`, which must outlive it.
template <class Law>
Adhesion adhesion_with_tail(const Law& law, const PairGeometry& geometry) {
  Adhesion adhesion = adhesion_of(law, geometry);
  if (adhesion.force != 0.0) adhesion.tail = &law;
  return adhesion;
}
template <class Law>
Adhesion adhesion_with_tail(const Law&&, const PairGeometry&) = delete;

}  // namespace cohesion::contact
