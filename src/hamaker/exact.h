// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "hamaker/parameters.h"
#include "sphere.h"

namespace cohesion::hamaker {

/// Attraction of two full spheres, or of a sphere and a half-space, at any gap H > 0; per A/6:
///
///   E = -[2/u + 2/(u + 4) + ln(u/(u + 4))]     F = dE/dH = 32/(u (u + 4))^2 du/dH > 0 attracts
///
/// with u = s - 4, s = (R^2 - (r_i - r_j)^2)/(r_i r_j) and R = r_i + r_j + H the distance of the
/// centres. In terms of the gap and the pair's geometry
///
///   u = q/R*,   q = H (2 + H/(r_i + r_j)),   du/dH = (2/R*) (1 + H/(r_i + r_j))
///
/// holds no difference of large numbers, and for a plane, 1/(r_i + r_j) = 0, it is
/// E = -[r/H + r/(H + 2r) + ln(H/(H + 2r))].
///
/// Limits: F -> R*/H^2 for H << R* (small_gap.h); for two spheres E -> -(32/3) (r_i r_j)^3/H^6 far
/// away. Relative rounding error: force 2e-15 and energy 4e-15 at all gaps and ratios of radii, for
/// the gap and geometry as given.
///
/// Source: H. C. Hamaker, Physica 4 (1937) 1058; M. A. van der Hoef et al., Adv. Chem. Eng. 31
/// (2006) 65, eq. 35 and 36, where E stands without its sign.
struct Exact {
  explicit Exact(const HamakerParameters& p) { require_smooth(p); }

  /// [force/energy]
  double force(double gap, const PairGeometry& g) const {
    const double r = g.reduced_radius;
    const double bend = gap * g.inverse_contact_distance;
    const double q = gap * (2.0 + bend);
    const double denominator = q * (q + 4.0 * r);
    return 64.0 * r * r * r * (1.0 + bend) / (denominator * denominator);
  }

  /// Zero at infinite gap; [1].
  double energy(double gap, const PairGeometry& g) const {
    const double r = g.reduced_radius;
    const double q = gap * (2.0 + gap * g.inverse_contact_distance);
    const double t = 2.0 * r / (q + 2.0 * r);
    if (t < 1.0 / 3.0) return -far_energy(t);
    return -(2.0 * r / q + 2.0 * r / (q + 4.0 * r) - std::log1p(4.0 * r / q));
  }

 private:
  /// The bracket at large u, where its terms cancel. With t = 2/(u + 2) it is
  /// 2 [t/(1 - t^2) - artanh t] = sum over n >= 1 of 4n/(2n + 1) t^(2n + 1).
  static double far_energy(double t) {
    double sum = 0.0;
    for (int n = 17; n > 0; n--) sum = sum * t * t + 4.0 * n / (2.0 * n + 1.0);  // 9^-17 is left
    return sum * t * t * t;
  }
};

}  // namespace cohesion::hamaker
