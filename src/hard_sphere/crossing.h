// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hard_sphere/impact.h"
#include "vector3.h"

/// When two bodies in free flight meet the next surface: the roots of |r + w t| = S, B. J. Alder,
/// T. E. Wainwright, J. Chem. Phys. 31 (1959) 459.
///
/// The state decides which surface that can be, not the distance alone: a flag says whether the
/// pair is in its well, the sign of b = r.w whether it closes in. So round-off at a surface that
/// was just crossed can neither cross it a second time nor miss it: a pair past its surface and
/// still moving the wrong way meets it now. Idea: Bannerman et al., Comput. Part. Mech. 1 (2014)
/// 191.
namespace cohesion::hard_sphere {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// Distances of centres (of a centre to a wall) at which something happens, [length].
struct SurfaceDistances {
  double core;  ///< hard core
  double edge;  ///< of the well; not above core: there is no well
  bool has_well() const { return edge > core; }
};

struct Crossing {
  double wait = never;  ///< time from now until the crossing, [time]
  Surface surface = Surface::core;
};

/// Time until |r + w t| has fallen to S, [time]: b = r.w, ww = w.w, c = r.r - S^2.
inline double time_to_fall(double b, double ww, double c) {
  if (b >= 0.0) return never;
  if (c <= 0.0) return 0.0;
  const double discriminant = b * b - ww * c;
  return discriminant < 0.0 ? never : c / (std::sqrt(discriminant) - b);
}

/// Time until |r + w t| has risen to S from inside, [time].
inline double time_to_rise(double b, double ww, double c) {
  if (ww == 0.0) return never;
  if (b >= 0.0 && c >= 0.0) return b > 0.0 ? 0.0 : never;
  const double root = std::sqrt(std::max(b * b - ww * c, 0.0));
  return b > 0.0 ? -c / (b + root) : (root - b) / ww;
}

/// Whether the normal speed of a pair, b = r.w, is round-off of its velocities, vv = max(v_i.v_i,
/// v_j.v_j). An impulse that small changes no digit of them: the pair would have its event again at
/// once, for ever. Such a pair counts as neither approaching nor parting; it moves by less than
/// 1e-15 of its flight.
inline bool normal_speed_is_round_off(double b, double rr, double vv) {
  return b * b <= 1e-30 * rr * vv;
}

/// Time until |r + w t| has risen to the edge S of a well, [time], with c = r.r - S^2, rr = r.r. A
/// pair that is on the edge or beyond it and in its well, by round-off, leaves now where it parts.
/// Where it does not, or so slowly that an impulse changes no digit, it leaves as soon as it parts:
/// else it would fly on along the edge and away from it.
inline double time_to_leave(double b, double ww, double rr, double vv, double c) {
  constexpr double above_round_off = 1.5e-15;
  const double least = above_round_off * std::sqrt(rr * vv);
  if (c < 0.0 || b > least) return time_to_rise(b, ww, c);
  if (ww * rr <= least * least) return never;
  return (std::max(std::sqrt(std::max(b * b - ww * c, 0.0)), least) - b) / ww;
}

/// Whether a pair may meet a surface within the time `left`: a test without roots, with b, ww, rr
/// as above; no means no. What falls needs (r^2 - S^2)/(-2 b) at least, since it gets no faster;
/// what is inside the edge then has not crossed it before. The surfaces may be off by 1e-7 of them.
inline bool may_cross_within(double left, double b, double ww, double rr,
                             const SurfaceDistances& surfaces, bool inside) {
  constexpr double room = 1.0 + 1e-6, for_long = 1e100;
  left = left < for_long ? left : for_long;
  const double inner = inside ? surfaces.core : surfaces.edge;
  const bool falls = (b < 0.0) & (rr - room * inner * inner <= -2.0 * room * b * left);
  const bool rises = room * (rr + left * (2.0 * b + left * ww)) >= surfaces.edge * surfaces.edge;
  return falls | (inside & rises);
}

/// The next surface that two spheres meet, with r = x_j - x_i now, w = v_j - v_i, and vv as above.
inline Crossing next_crossing(const Vector3& r, const Vector3& w, double vv,
                              const SurfaceDistances& surfaces, bool inside) {
  const double b = dot(r, w), ww = dot(w, w), rr = dot(r, r);
  if (!inside && b >= 0.0) return {};
  const bool entering = !inside && surfaces.has_well();
  const double inner = entering ? surfaces.edge : surfaces.core;
  const double fall = time_to_fall(b, ww, rr - inner * inner);
  if (entering) return {fall, Surface::edge_inward};
  if (fall < never && !normal_speed_is_round_off(b, rr, vv)) return {fall, Surface::core};
  if (!inside) return {};
  const double c = rr - surfaces.edge * surfaces.edge;
  return {time_to_leave(b, ww, rr, vv, c), Surface::edge_outward};
}

}  // namespace cohesion::hard_sphere
