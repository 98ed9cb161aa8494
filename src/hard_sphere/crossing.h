// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hard_sphere/impact.h"
#include "vector3.h"

/// When partners that fly straight meet the next surface.
///
/// The state decides which surface that can be, not the distance alone: a flag says whether the
/// pair is in its well, the sign of b = r.w whether it closes in. So round-off at a surface that
/// was just crossed can neither cross it a second time nor miss it: a pair past its surface and
/// still moving the wrong way meets it now. Idea: Bannerman et al., Comput. Part. Mech. 1 (2014)
/// 191.
namespace cohesion::hard_sphere {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// Distances of centres (of a centre to a wall) at which something happens, [length].
struct Surfaces {
  double core;  ///< hard core
  double edge;  ///< of the well; not above core: there is none
  bool well() const { return edge > core; }
};

struct Crossing {
  double wait = never;  ///< from now, [time]
  Surface surface = Surface::core;
};

/// Time until |r + w t| has fallen to S: b = r.w, ww = w.w, c = r.r - S^2.
inline double time_to_fall(double b, double ww, double c) {
  if (b >= 0.0) return never;
  if (c <= 0.0) return 0.0;
  const double discriminant = b * b - ww * c;
  return discriminant < 0.0 ? never : c / (std::sqrt(discriminant) - b);
}

/// Time until |r + w t| has risen to S from inside.
inline double time_to_rise(double b, double ww, double c) {
  if (ww == 0.0) return never;
  if (b >= 0.0 && c >= 0.0) return b > 0.0 ? 0.0 : never;
  const double root = std::sqrt(std::max(b * b - ww * c, 0.0));
  return b > 0.0 ? -c / (b + root) : (root - b) / ww;
}

/// The next surface of two spheres, r = x_j - x_i now, w = v_j - v_i.
inline Crossing next_crossing(const Vector3& r, const Vector3& w, const Surfaces& at, bool inside) {
  const double b = dot(r, w), ww = dot(w, w), rr = dot(r, r);
  if (!inside) {
    if (b >= 0.0) return {};
    const double outer = at.well() ? at.edge : at.core;
    return {time_to_fall(b, ww, rr - outer * outer),
            at.well() ? Surface::edge_inward : Surface::core};
  }
  const double hit = time_to_fall(b, ww, rr - at.core * at.core);
  if (hit < never) return {hit, Surface::core};
  return {time_to_rise(b, ww, rr - at.edge * at.edge), Surface::edge_outward};
}

}  // namespace cohesion::hard_sphere
