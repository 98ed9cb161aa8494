// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hamaker/parameters.h"
#include "hamaker/tail.h"
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
class HamakerLaw final : public Tail {
 public:
  /// Throws InvalidParameter as require_valid does, and when Form passes over an asperity given.
  explicit HamakerLaw(const HamakerParameters& p)
      : form_(p),
        a_over_6_(p.hamaker_constant / 6.0),
        surface_cutoff_(p.surface_cutoff),
        outer_cutoff_(p.outer_cutoff) {
    require_valid(p);
  }

  double surface_cutoff() const { return surface_cutoff_; }
  double outer_cutoff() const override { return outer_cutoff_; }

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

  /// The barrier of the tail for a pair at `gap` that a constant load L [force] pulls apart: the
  /// largest difference of the work against the attraction and that of the load,
  ///
  ///   B = max over H in [gap, H_out] of  E(H) - E(gap) - L (H - gap)        [energy]
  ///
  /// A gap below H_cut counts as H_cut. The attraction falls with the gap, so that the top of the
  /// barrier is where F(H) = L, or at the end of this interval that is nearest to it. From H_cut
  /// on, with f = L/F_ad and the form of small gaps,
  ///
  ///   B = F_ad H_cut (1 - sqrt(f))^2          (H_cut/H_out)^2 <= f < 1, top at H_cut/sqrt(f)
  ///   B = tail_energy - L (H_out - H_cut)     below it, top at H_out
  ///   B = 0                                   f >= 1
  ///
  /// Source: derived here.
  double barrier(double load, double gap, const PairGeometry& g) const override {
    const double from = std::max(gap, surface_cutoff_);
    if (from >= outer_cutoff_ || load >= force(from, g)) return 0.0;
    const double top = gap_of(load, from, g);
    return a_over_6_ * (form_.energy(top, g) - form_.energy(from, g)) - load * (top - from);
  }

  double work_up_to(double gap, const PairGeometry& g) const override {
    return energy(gap, g) + tail_energy(g);
  }

 private:
  /// The gap in [from, H_out] where the attraction is `load`, which is below that at `from`; H_out
  /// where it is above all beyond. By regula falsi (Illinois) in ln F over ln H, of which the form
  /// of small gaps is a straight line. At the top of a barrier a relative error x of the gap is one
  /// of x^2 of the barrier.
  double gap_of(double load, double from, const PairGeometry& g) const {
    const auto excess = [&](double log_gap) {
      return std::log(a_over_6_ * form_.force(std::exp(log_gap), g) / load);
    };
    if (!(load > a_over_6_ * form_.force(outer_cutoff_, g))) return outer_cutoff_;
    double low = std::log(from), high = std::log(outer_cutoff_), at = low;
    double at_low = excess(low), at_high = excess(high);
    for (int i = 0, side = 0; i < 100; i++) {
      const double last = at;
      at = low + (high - low) * at_low / (at_low - at_high);
      if (!(std::abs(at - last) > 1e-9)) break;
      const double e = excess(at);
      const int now = e > 0.0 ? 1 : -1;
      (e > 0.0 ? low : high) = at;
      (e > 0.0 ? at_low : at_high) = e;
      // The end that stays a second time counts half, so that it moves, too.
      if (now == side) (e > 0.0 ? at_high : at_low) *= 0.5;
      side = now;
    }
    return std::clamp(std::exp(at), from, outer_cutoff_);
  }

  Form form_;
  double a_over_6_;
  double surface_cutoff_;
  double outer_cutoff_;
};

}  // namespace cohesion::hamaker
