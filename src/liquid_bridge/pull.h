// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion::liquid_bridge {

/// The pull of a bridge over the gap S of the surfaces: F in contact, and beyond
///
///   F(S) = F/(1 + 1.05 s + 2.5 s^2),   s = S/L
///
/// L = 0: constant. Its work from gap to gap, with D = 4 * 2.5 - 1.05^2,
///
///   integral of F(S) dS = 2 F L/sqrt(D) (atan((5 s_2 + 1.05)/sqrt(D)) - atan((5 s_1
///   + 1.05)/sqrt(D)))
///
/// is positive where the gap opens.
///
/// Source: C. D. Willett, M. J. Adams, S. A. Johnson, J. P. K. Seville, Langmuir 16 (2000) 9396,
/// eq. 12, for small volumes. It is printed there as 1 + 2.1 S* + 10 S*^2 with half of the gap in
/// S*. The paper was not at hand; formula and convention are those of public codes (YADE, a model
/// for LIGGGHTS), and S. Herminghaus, Adv. Phys. 54 (2005) 221 has the form above.
struct Pull {
  double force = 0.0;  ///< F, [force]
  double fall = 0.0;   ///< L, [length]

  /// F(S) at a gap [length], [force].
  double at(double gap) const {
    if (fall == 0.0 || gap <= 0.0) return force;
    const double s = gap / fall;
    return force / (1.0 + (linear + square * s) * s);
  }
  /// Mean of F(S) between two gaps not below 0 [length], [force].
  double mean(double from, double to) const {
    if (fall == 0.0 || from == to) return at(from);
    const double root = std::sqrt(4.0 * square - linear * linear);
    const double a = (2.0 * square * from / fall + linear) / root;
    const double apart = 2.0 * square * (to - from) / fall / root;
    // Of the difference of two angles, without cancellation.
    return force * (std::atan2(apart, 1.0 + a * (a + apart)) / apart) * (4.0 * square) /
           (root * root);
  }
  /// Work of opening from touch to a gap [length], [energy]; negative in contact.
  double work(double gap) const { return gap * (gap > 0.0 ? mean(0.0, gap) : force); }

 private:
  static constexpr double linear = 1.05, square = 2.5;
};

}  // namespace cohesion::liquid_bridge
