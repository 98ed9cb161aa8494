// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "hamaker/parameters.h"
#include "sphere.h"

namespace cohesion::hamaker {

/// Hamaker attraction with a surface-adhesion cut-off. Form gives attraction f(H) and energy e(H)
/// per A/6 across a gap H > 0: SmallGap, Exact, or Rough of either.
///
///   F(H) = (A/6) f(H)        H_cut <= H < H_out
///   F(H) = F(H_cut)          H <  H_cut, overlap (H < 0) included: the surface adhesion force
///   F(H) = 0                 H >= H_out
///
///   E(H) = (A/6) [e(H) - e(H_out)]             between the cut-offs: zero and continuous at H_out
///   E(H) = E(H_cut) - F(H_cut) (H_cut - H)     below H_cut
///
/// F > 0 attracts; F = dE/dH. One law for two spheres of any radii and for sphere and plane. Any
/// consistent set of units; SI in the documentation.
///
/// Source: cut-off as in M. Weber, thesis, section 6.2.4.1.
template <class Form>
class Law {
 public:
  /// Throws InvalidParameter as require_valid does, and when Form passes over an asperity given.
  explicit Law(const Parameters& p)
      : form_(p),
        a_over_6_(p.hamaker_constant / 6.0),
        surface_cutoff_(p.surface_cutoff),
        outer_cutoff_(p.outer_cutoff) {
    require_valid(p);
  }

  double surface_cutoff() const { return surface_cutoff_; }
  double outer_cutoff() const { return outer_cutoff_; }

  /// Attraction at `gap` [length]; [force], positive attracts.
  double force(double gap, const PairGeometry& g) const {
    if (gap >= outer_cutoff_) return 0.0;
    return a_over_6_ * form_.force(std::max(gap, surface_cutoff_), g);
  }

  /// Energy at `gap` [length], zero from the outer cut-off on; [energy].
  double energy(double gap, const PairGeometry& g) const {
    if (gap >= outer_cutoff_) return 0.0;
    if (gap < surface_cutoff_) return -tail_energy(g) - adhesion_force(g) * (surface_cutoff_ - gap);
    return a_over_6_ * (form_.energy(gap, g) - form_.energy(outer_cutoff_, g));
  }

  /// The surface adhesion force F_ad = F(H <= H_cut), [force].
  double adhesion_force(const PairGeometry& g) const {
    return a_over_6_ * form_.force(surface_cutoff_, g);
  }

  /// Work against the attraction from H_cut to H_out, E(H_out) - E(H_cut) >= 0, [energy].
  double tail_energy(const PairGeometry& g) const {
    return a_over_6_ * (form_.energy(outer_cutoff_, g) - form_.energy(surface_cutoff_, g));
  }

 private:
  Form form_;
  double a_over_6_;
  double surface_cutoff_;
  double outer_cutoff_;
};

}  // namespace cohesion::hamaker
