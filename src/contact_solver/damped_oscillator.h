// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact_solver/motion_along_normal.h"

namespace cohesion::contact_solver {

/// Spring and dashpot whose force at grid points, from the position there and the velocity of the
/// half step before, makes a particle on the grid follow a damped oscillator exactly.
struct DiscreteConstants {
  double stiffness;  ///< K', [force/length]
  double damping;    ///< eta', [mass/time]
};

/// Closed-form motion of an overlap under a linear spring-dashpot and a constant drive:
///
///   x'' = c - 2 alpha x' - w0^2 x
///
/// c [length/time^2] is the constant force over the reduced mass (adhesion, less the centrifugal
/// term of a turning pair). Under, at and beyond critical damping.
///
/// Source: M. Weber, thesis, appendix C, with the constant force added.
class DampedOscillator {
 public:
  /// w0^2 = K/mu >= 0 [1/time^2], alpha = eta/(2 mu) >= 0 [1/time]. Without a spring, w0 = 0, there
  /// must be no drive, which would have no equilibrium.
  DampedOscillator(double w0_squared, double alpha)
      : w0_squared_(w0_squared),
        inverse_w0_squared_(w0_squared > 0.0 ? 1.0 / w0_squared : 0.0),
        alpha_(alpha) {
    const double w0 = std::sqrt(w0_squared);
    const double q_squared = (w0 - alpha) * (w0 + alpha);
    // Critical damping as rounding leaves it is critical damping.
    const double nearly_zero = 16.0 * std::numeric_limits<double>::epsilon() * w0_squared;
    underdamped_ = q_squared > nearly_zero;
    overdamped_ = q_squared < -nearly_zero;
    q_ = std::sqrt(std::abs(q_squared));
  }

  double w0_squared() const { return w0_squared_; }
  double alpha() const { return alpha_; }

  /// What a time t does to the offset from equilibrium and its rate, once for all pairs that share
  /// w0, alpha and t.
  struct Propagator {
    double time;
    double xx, xv, vx, vv;
  };

  Propagator propagator(double t) const {
    if (overdamped_) {
      // The slow mode exp(-slow t) and the fast one exp(-(alpha + q) t), put together without
      // differences of nearly equal numbers, near critical damping and far beyond.
      const double slow = w0_squared_ / (alpha_ + q_);
      const double slow_mode = std::exp(-slow * t);
      const double fast_mode = std::exp(-(alpha_ + q_) * t);
      const double s = slow_mode * -std::expm1(-2.0 * q_ * t) / (2.0 * q_);
      return {t, slow_mode + slow * s, s, -w0_squared_ * s, fast_mode - slow * s};
    }
    const double decay = std::exp(-alpha_ * t);
    const double c = underdamped_ ? decay * std::cos(q_ * t) : decay;
    const double s = underdamped_ ? decay * std::sin(q_ * t) / q_ : decay * t;
    return {t, c + alpha_ * s, s, -w0_squared_ * s, c - alpha_ * s};
  }

  /// K' = m (1 + d - 2 c)/t^2 and eta' = m (1 - d)/t of x_(n+1) = 2 c x_n - d x_(n-1) on a grid of
  /// step t [time]; 2 c is the sum of what a step leaves of the two modes, d their product. `mass`:
  /// that w0 and alpha are of.
  DiscreteConstants on_grid(double t, double mass) const {
    const double lost = -std::expm1(-2.0 * alpha_ * t);
    double curvature;  // 1 + d - 2 c
    if (overdamped_) {
      const double slow = w0_squared_ / (alpha_ + q_);
      curvature = std::expm1(-slow * t) * std::expm1(-(alpha_ + q_) * t);
    } else {
      const double faded = std::expm1(-alpha_ * t);
      const double turned = underdamped_ ? std::sin(0.5 * q_ * t) : 0.0;
      curvature = faded * faded + 4.0 * std::exp(-alpha_ * t) * turned * turned;
    }
    return {mass * curvature / (t * t), mass * lost / t};
  }

  Overlap after(const Propagator& p, Overlap start, double drive) const {
    const double equilibrium = drive * inverse_w0_squared_;
    const double offset = start.x - equilibrium;
    return {equilibrium + p.xx * offset + p.xv * start.v, p.vx * offset + p.vv * start.v};
  }

  Overlap after(double t, Overlap start, double drive) const {
    return after(propagator(t), start, drive);
  }

  /// An overlap that goes from start.x >= 0 (v > 0 if x = 0) to `end`, turning at most once, and
  /// certainly stays positive in between: it turns at a maximum, if at all.
  static bool stays_positive(Overlap start, Overlap end) {
    // Without branches: which way a persistent contact moves cannot be predicted.
    return static_cast<bool>((end.x >= 0.0) & ((start.v >= 0.0) | (end.v <= 0.0)));
  }

  /// The first time in (0, t_end] at which an overlap that starts at x >= 0 (v > 0 if x = 0) is
  /// back at zero; infinity if it stays positive. `end` is the state at t_end, and is set to that
  /// at the zero. t_end is at most half a period, so that the overlap turns at most once.
  double first_zero(Overlap start, double drive, double t_end, Overlap& end) const {
    if (stays_positive(start, end)) return never;
    if (start.v >= 0.0 || end.v <= 0.0) return falling_zero(start, drive, t_end, end);
    const double turn = std::min(turning_time(start, drive), t_end);
    const Overlap lowest = after(turn, start, drive);
    if (!(lowest.x < 0.0)) return never;
    end = lowest;
    return falling_zero(start, drive, turn, end);
  }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  /// When the rate is first zero; infinity if never.
  double turning_time(Overlap start, double drive) const {
    const double pull = w0_squared_ * start.x - drive + alpha_ * start.v;
    if (underdamped_) {
      const double sign = start.v < 0.0 ? -1.0 : 1.0;
      return std::atan2(sign * q_ * start.v, sign * pull) / q_;
    }
    const bool one_sign = (start.v > 0.0 && pull > 0.0) || (start.v < 0.0 && pull < 0.0);
    if (!one_sign || std::abs(start.v) * 1e-300 >= std::abs(pull)) return never;
    const double ratio = start.v / pull;
    if (!overdamped_) return ratio;
    return q_ * ratio < 1.0 ? std::atanh(q_ * ratio) / q_ : never;
  }

  /// The falling zero between the start and `low`, where the overlap is `at` < 0: by parabolas,
  /// kept in the bracket, until what they leave out is below rounding. Sets `at` to the state
  /// there.
  double falling_zero(Overlap start, double drive, double low, Overlap& at) const {
    constexpr double rounding = 2.0 * std::numeric_limits<double>::epsilon();
    double high = 0.0, t = low;
    for (int i = 0; i < 100; i++) {
      const double bend = drive - 2.0 * alpha_ * at.v - w0_squared_ * at.x;
      const double square = at.v * at.v - 2.0 * bend * at.x;
      double next = 0.5 * (high + low);
      if (square > 0.0 && (at.v < 0.0 || bend != 0.0)) {
        const double rate = std::sqrt(square);
        const double way = at.v < 0.0 ? 2.0 * at.x / (rate - at.v) : (-at.v - rate) / bend;
        const double third = -2.0 * alpha_ * bend - w0_squared_ * at.v;
        const double fourth = -2.0 * alpha_ * third - w0_squared_ * bend;
        const double left_out =
            way * way * std::abs(way) * (std::abs(third) + 0.25 * std::abs(fourth * way)) / 6.0;
        if (left_out <= rounding * low * rate) {
          at = {0.0, std::min(at.v + way * (bend + 0.5 * way * third), 0.0)};
          return std::clamp(t + way, high, low);
        }
        if (t + way > high && t + way < low) next = t + way;
      }
      if (std::abs(next - t) <= rounding * low) break;
      t = next;
      at = after(t, start, drive);
      (at.x >= 0.0 ? high : low) = t;
    }
    at = {0.0, std::min(at.v, 0.0)};
    return t;
  }

  double w0_squared_;
  double inverse_w0_squared_;
  double alpha_;
  double q_;
  bool underdamped_;
  bool overdamped_;
};

/// K' and eta' on a grid of step t [time] of a spring and dashpot that act on `mass`; the spring
/// may be missing.
inline DiscreteConstants discrete_constants(double stiffness, double damping, double mass,
                                            double t) {
  return DampedOscillator(stiffness / mass, 0.5 * damping / mass).on_grid(t, mass);
}

/// The forces, for half a step each, between which a run of such steps stands: `first` from the
/// true velocity at its first grid point to that of the first half step, `last` from the velocity
/// of the last half step to the true one at its last grid point.
struct DiscreteEndConstants {
  DiscreteConstants first, last;
};

inline DiscreteEndConstants discrete_end_constants(double stiffness, double damping, double mass,
                                                   double t) {
  const DiscreteConstants plain = discrete_constants(stiffness, damping, mass, t);
  const auto p = DampedOscillator(stiffness / mass, 0.5 * damping / mass).propagator(t);
  // Two places half a swing apart do not determine a velocity.
  if (!(p.xv > 0.1 * t * (p.xx + p.vv > 0.0 ? p.vv : 1.0))) return {plain, plain};
  const double m = 2.0 * mass / t, kept = p.xx * p.vv - p.xv * p.vx;
  return {{m / t * (1.0 - p.xx), m * (1.0 - p.xv / t)},
          {m * (kept - p.vv) / p.xv, m * (1.0 - t * kept / p.xv)}};
}

}  // namespace cohesion::contact_solver
