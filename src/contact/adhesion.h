// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "liquid_bridge/pull.h"

namespace cohesion::contact {

/// The attraction of one pair beyond H_cut, as a pair that leaves it under a load sees it:
/// hamaker/tail.h.
class Tail {
 public:
  virtual ~Tail() = default;
  /// Of a pair at `gap` [length] that a constant load [force] pulls apart, [energy].
  virtual double barrier(double load, double gap) const = 0;
  /// The work of the attraction from H_cut to a gap, [energy].
  virtual double work_up_to(double gap) const = 0;
  /// H_out, [length].
  virtual double outer_cutoff() const = 0;
  /// Whether a gap is within the outer cut-off, but for rounding.
  bool contains(double gap) const {
    constexpr double rounding = 1e-12;
    return gap <= (1.0 + rounding) * outer_cutoff();
  }
};

/// A short-ranged attraction as closed-form contact motion sees it: a constant force from the gap
/// H_cut inwards, in contact too, and a tail beyond it that acts at H_cut all at once. A load works
/// on the way through it: `tail` says how far it helps.
/// One that forms at touch, as a liquid bridge, acts in the gap only between two that have touched;
/// its force may fall over the gap. Each law of attraction has its adhesion_of().
struct Adhesion {
  double force = 0.0;        ///< F_ad, [force]
  double cutoff = 0.0;       ///< H_cut, [length]
  double tail_energy = 0.0;  ///< E_tail, [energy]: work of the attraction from far away to H_cut
  bool forms_at_touch = false;
  /// Of E_tail; none: E_tail is that of an edge without width, through which no load helps.
  std::shared_ptr<const Tail> tail{};
  double fall = 0.0;  ///< L of the pull of a bridge, [length]; 0: constant up to H_cut

  bool attracts() const { return force > 0.0 || tail_energy > 0.0; }
  liquid_bridge::Pull pull() const { return {force, fall}; }
  /// W = E_tail + F_ad H_cut, [energy], with the work of a pull that falls in the place of F_ad
  /// H_cut: what the pair pays on its way from last touch.
  double well_energy() const { return tail_energy + pull().work(cutoff); }
  /// What it gains on its way to first touch, [energy].
  double approach_energy() const { return forms_at_touch ? 0.0 : well_energy(); }
};

}  // namespace cohesion::contact
