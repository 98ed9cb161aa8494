// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

#include "constants.h"
#include "contact/law_point.h"
#include "validation.h"

namespace cohesion::contact {

/// The linear spring-dashpot K x + eta x' acting on the reduced mass mu of a pair, without
/// adhesion, from first touch until the overlap is back at zero. x is the overlap.
///
///   w0^2 = K/mu   alpha = eta/(2 mu)   q^2 = w0^2 - alpha^2
///   x(t) = (v0/q) exp(-alpha t) sin(q t)
///   e    = exp(-pi alpha/q)          restitution: speed at x = 0 out over in
///   t_c  = pi/q                      contact time
///   x_max = (v0/w0) exp(-(alpha/q) asin(q/w0))   largest overlap, reached at t = asin(q/w0)/q
///           (alpha/w0 -> 1: v0/(w0 exp(1)))
///
/// A dashpot at or beyond critical damping (alpha >= w0) brings the overlap back to zero only after
/// an infinite time: e = 0, t_c infinite.
///
/// Source: M. Weber, thesis, appendices B and C; van der Hoef et al. (2006), section III.B.
class LinearSpringDashpot {
 public:
  /// stiffness K [force/length], damping eta [mass/time], reduced mass mu [mass].
  /// Throws InvalidParameter unless K > 0, eta >= 0, mu > 0, all finite.
  LinearSpringDashpot(double stiffness, double damping, double reduced_mass)
      : stiffness_(stiffness), damping_(damping), reduced_mass_(reduced_mass) {
    require_positive("stiffness K", stiffness);
    require_non_negative("damping eta", damping);
    require_positive("reduced mass", reduced_mass);
    w0_ = std::sqrt(stiffness / reduced_mass);
    alpha_ = damping / (2.0 * reduced_mass);
    // (w0 - alpha)(w0 + alpha) keeps its digits near critical damping where w0^2 - alpha^2 does
    // not.
    q_squared_ = (w0_ - alpha_) * (w0_ + alpha_);
    // Critical damping as from_restitution rounds it is critical damping.
    if (std::abs(q_squared_) < 16.0 * std::numeric_limits<double>::epsilon() * w0_ * w0_)
      q_squared_ = 0.0;
  }

  /// The dashpot that gives `restitution`: eta = -2 ln e sqrt(mu K)/sqrt(pi^2 + ln^2 e), and
  /// critical damping eta = 2 sqrt(mu K) for e = 0. Throws InvalidParameter unless 0 <= e <= 1.
  static LinearSpringDashpot from_restitution(double stiffness, double restitution,
                                              double reduced_mass) {
    require_positive("stiffness K", stiffness);
    require_positive("reduced mass", reduced_mass);
    require(std::isfinite(restitution) && restitution >= 0.0 && restitution <= 1.0, "restitution e",
            restitution, "must lie between 0 and 1");
    const double critical = 2.0 * std::sqrt(reduced_mass * stiffness);
    if (restitution == 0.0) return {stiffness, critical, reduced_mass};
    const double ln_e = std::log(restitution);
    return {stiffness, -ln_e / std::hypot(pi, ln_e) * critical, reduced_mass};
  }

  /// The spring that lets an impact at `speed` [length/time] reach `overlap` [length]:
  /// K = mu (v0/x_max)^2 exp(-2 (alpha/q) asin(q/w0)), where alpha/q = -ln e/pi.
  /// Throws InvalidParameter unless both are positive and 0 <= e <= 1.
  static LinearSpringDashpot from_maximum_overlap(double overlap, double speed, double restitution,
                                                  double reduced_mass) {
    require_positive("maximum overlap", overlap);
    require_positive("impact speed", speed);
    require_positive("reduced mass", reduced_mass);
    const double unit_overlap =
        from_restitution(1.0, restitution, 1.0).maximum_overlap(1.0);  // x_max w0/v0
    const double w0 = unit_overlap * speed / overlap;
    return from_restitution(reduced_mass * w0 * w0, restitution, reduced_mass);
  }

  /// As HertzSpringDashpot has them; no tangential spring follows its radius of contact.
  static constexpr double lowest_overlap() { return 0.0; }
  LawPoint at(double x) const {
    return {stiffness_ * x, stiffness_, 0.5 * stiffness_ * x * x, damping_, damping_ * x};
  }

  double stiffness() const { return stiffness_; }
  double damping() const { return damping_; }
  double reduced_mass() const { return reduced_mass_; }

  /// e, [1].
  double restitution() const {
    return q_squared_ > 0.0 ? std::exp(-pi * alpha_ / std::sqrt(q_squared_)) : 0.0;
  }

  /// t_c, [time]; infinite at and beyond critical damping.
  double contact_time() const {
    return q_squared_ > 0.0 ? pi / std::sqrt(q_squared_) : std::numeric_limits<double>::infinity();
  }

  /// x_max [length] of an impact at `speed` [length/time].
  double maximum_overlap(double speed) const {
    if (q_squared_ > 0.0) {
      const double q = std::sqrt(q_squared_);
      // atan2(q, alpha) equals asin(q/w0) and keeps its digits when alpha is small against w0.
      return speed / w0_ * std::exp(-alpha_ / q * std::atan2(q, alpha_));
    }
    const double p = std::sqrt(-q_squared_);
    if (p < 1e-8 * w0_) return speed / w0_ * std::exp(-1.0);
    return speed / w0_ * std::exp(-alpha_ / p * std::atanh(p / alpha_));
  }

 private:
  double stiffness_;
  double damping_;
  double reduced_mass_;
  double w0_;
  double alpha_;
  double q_squared_;
};

}  // namespace cohesion::contact
