// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hard_sphere/impact.h"
#include "vector3.h"

/// Time at which two bodies in free flight reach the next surface: the roots of |r + w t| = S:
/// B. J. Alder, T. E. Wainwright, J. Chem. Phys. 31 (1959) 459.
///
/// The state of the pair decides which surface that can be, not the distance alone: a flag stores
/// whether the pair is in its well, and the sign of b = r.w whether it approaches. So round-off at
/// a surface that was just crossed can neither repeat the crossing nor skip the next one: a pair
/// beyond a surface that still moves the wrong way crosses it now. Method: Bannerman et al.,
/// Comput. Part. Mech. 1 (2014) 191.
namespace cohesion::hard_sphere {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// Distances between centres, or between a centre and a wall, at which events occur, [length].
struct SurfaceDistances {
  double core;  ///< of the hard core
  double edge;  ///< of the well; not above core: no well
  bool has_well() const { return edge > core; }
};

struct Crossing {
  double wait = never;  ///< time from now until the crossing, [time]
  Surface surface = Surface::core;
};

/// Time until |r + w t| has decreased to S, [time]; b = r.w, ww = w.w, c = r.r - S^2.
inline double time_to_fall(double b, double ww, double c) {
  if (b >= 0.0) return never;
  if (c <= 0.0) return 0.0;
  const double discriminant = b * b - ww * c;
  return discriminant < 0.0 ? never : c / (std::sqrt(discriminant) - b);
}

/// Time until |r + w t| has increased to S from inside, [time].
inline double time_to_rise(double b, double ww, double c) {
  if (ww == 0.0) return never;
  if (b >= 0.0 && c >= 0.0) return b > 0.0 ? 0.0 : never;
  const double root = std::sqrt(std::max(b * b - ww * c, 0.0));
  return b > 0.0 ? -c / (b + root) : (root - b) / ww;
}

/// Whether the normal speed of a pair, b = r.w, is round-off of its velocities, vv = max(v_i.v_i,
/// v_j.v_j). Such a small impulse would leave the velocities unchanged, and the pair would repeat
/// its event for ever. The pair is treated as neither approaching nor separating; it moves by less
/// than 1e-15 of its flight.
inline bool normal_speed_is_round_off(double b, double rr, double vv) {
  return b * b <= 1e-30 * rr * vv;
}

/// Time until |r + w t| has increased to the edge S of a well, [time]; c = r.r - S^2, rr = r.r. A
/// bound pair that round-off has put on or beyond the edge leaves now if it separates. If it does
/// not separate, or too slowly for an impulse to change its velocities, it leaves as soon as it
/// does: otherwise it would move along the edge and away from it.
inline double time_to_leave(double b, double ww, double rr, double vv, double c) {
  constexpr double above_round_off = 1.5e-15;
  const double least = above_round_off * std::sqrt(rr * vv);
  if (c < 0.0 || b > least) return time_to_rise(b, ww, c);
  if (ww * rr <= least * least) return never;
  return (std::max(std::sqrt(std::max(b * b - ww * c, 0.0)), least) - b) / ww;
}

/// Whether a pair may reach a surface within the time `left`: a conservative test without roots; b,
/// ww, rr as above. False means that there is no crossing. A decrease to S needs at least (r^2 -
/// S^2)/(-2 b), since the approach never accelerates; a pair that is inside the edge at that time
/// has not crossed it before. The surfaces may have a relative error of 1e-7.
inline bool may_cross_within(double left, double b, double ww, double rr,
                             const SurfaceDistances& surfaces, bool inside) {
  constexpr double tolerance = 1.0 + 1e-6, long_time = 1e100;
  left = left < long_time ? left : long_time;
  const double inner = inside ? surfaces.core : surfaces.edge;
  const bool falls = (b < 0.0) & (rr - tolerance * inner * inner <= -2.0 * tolerance * b * left);
  const bool rises =
      tolerance * (rr + left * (2.0 * b + left * ww)) >= surfaces.edge * surfaces.edge;
  return falls | (inside & rises);
}

/// The next surface that two spheres reach; r = x_j - x_i now, w = v_j - v_i, vv as above.
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
