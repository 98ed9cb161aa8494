// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "validation.h"

namespace cohesion::hamaker {

struct SmallGapParameters {
  double hamaker_constant;  ///< A, [energy]; 0 switches the law off
  double surface_cutoff;    ///< H_cut, [length]: the force is constant below this gap
  double outer_cutoff;      ///< H_out, [length]: force and energy are zero from this gap on
};

/// Hamaker attraction of two close surfaces with a surface-adhesion cut-off.
///
///   F(H) = A R* / (6 H^2)        H_cut <= H < H_out
///   F(H) = A R* / (6 H_cut^2)    H <  H_cut, overlap (H < 0) included: the surface adhesion force
///   F(H) = 0                     H >= H_out
///
///   E(H) = -A R*/6 (1/H - 1/H_out)   between the cut-offs: zero and continuous at H_out
///   E(H) = E(H_cut) - F(H_cut) (H_cut - H)   below H_cut
///
/// F > 0 attracts; F = dE/dH. H is the gap between the surfaces, R* the reduced radius (sphere.h):
/// one law for sphere-sphere of any two radii and for sphere-plane. Valid for H << R*. Any
/// consistent set of units; SI in the documentation.
///
/// Source: Derjaguin's approximation of the sphere-sphere attraction, H. C. Hamaker, Physica 4
/// (1937) 1058; cut-off as in M. Weber, thesis, section 6.2.4.1.
class SmallGap {
 public:
  /// Throws InvalidParameter unless A >= 0 and 0 < H_cut < H_out, all finite.
  explicit SmallGap(const SmallGapParameters& p)
      : surface_cutoff_(p.surface_cutoff), outer_cutoff_(p.outer_cutoff) {
    require_non_negative("Hamaker constant A", p.hamaker_constant);
    require_positive("surface cut-off H_cut", p.surface_cutoff);
    require_positive("outer cut-off", p.outer_cutoff);
    require(p.surface_cutoff < p.outer_cutoff, "surface cut-off H_cut", p.surface_cutoff,
            "must be smaller than the outer cut-off");
    a_over_6_ = p.hamaker_constant / 6.0;
    adhesion_ = a_over_6_ / (surface_cutoff_ * surface_cutoff_);
    energy_shift_ = a_over_6_ / outer_cutoff_;
    energy_at_surface_cutoff_ = energy_shift_ - a_over_6_ / surface_cutoff_;
  }

  double surface_cutoff() const { return surface_cutoff_; }
  double outer_cutoff() const { return outer_cutoff_; }

  /// Attraction at `gap` [length] for `reduced_radius` [length]; [force], positive attracts.
  double force(double gap, double reduced_radius) const {
    if (gap >= outer_cutoff_) return 0.0;
    if (gap < surface_cutoff_) return reduced_radius * adhesion_;
    return reduced_radius * a_over_6_ / (gap * gap);
  }

  /// Energy at `gap` [length], zero at the outer cut-off; [energy].
  double energy(double gap, double reduced_radius) const {
    if (gap >= outer_cutoff_) return 0.0;
    if (gap < surface_cutoff_)
      return reduced_radius * (energy_at_surface_cutoff_ - adhesion_ * (surface_cutoff_ - gap));
    return reduced_radius * (energy_shift_ - a_over_6_ / gap);
  }

  /// The surface adhesion force F_ad = F(H <= H_cut), [force].
  double adhesion_force(double reduced_radius) const { return reduced_radius * adhesion_; }

 private:
  double surface_cutoff_;
  double outer_cutoff_;
  double a_over_6_;
  double adhesion_;
  double energy_shift_;
  double energy_at_surface_cutoff_;
};

}  // namespace cohesion::hamaker
