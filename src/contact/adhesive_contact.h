// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "constants.h"
#include "contact/adhesion.h"
#include "contact/linear_spring_dashpot.h"
#include "validation.h"

namespace cohesion::contact {

/// Two particles, or a particle and a wall, that meet head-on under a linear spring-dashpot and an
/// adhesion force. x is the overlap, u the speed at first touch, v the approach speed far away:
///
///   mu x'' = -K x - eta x' + F_ad   while x > 0          u^2 = v^2 + 2 W/mu
///
/// With zeta = eta/(2 sqrt(mu K)), q = sqrt(1 - zeta^2), tau = w0 t, b = F_ad/sqrt(mu K) [speed]:
///
///   w0 x = b + exp(-zeta tau) (-b cos q tau + (u - zeta b)/q sin q tau)
///   Q = (x' + zeta y)^2 + q^2 y^2, y = w0 x - b, falls as exp(-2 zeta tau)
///
/// T is the first return to x = 0, the root of a monotone stretch between the largest overlap and
/// half a period later. Speed lost, from Q at x = 0 before and after, without cancellation:
///
///   u^2 - w^2 = 2 zeta b (u + w) + (1 - exp(-2 zeta T)) (u^2 - 2 zeta b u + b^2)
///
/// The pair escapes when mu w^2/2 > W. The escape velocity needs no search over speeds: the motion
/// run backwards from w = sqrt(2 W/mu) is the same motion with -zeta.
///
/// An adhesion that forms at touch has u = v: no W is gained on the way in.
///
///   F_ad -> 0:   v_esc = sqrt(2 W/mu (1/e^2 - 1)), sqrt(2 W/mu)/e of one that forms at touch
///   W -> 0:      v_esc = c(zeta) F_ad/sqrt(mu K), c -> sqrt(4 pi zeta) for zeta -> 0
///   in general:  v_esc/b is a function of zeta and W/(F_ad^2/K) alone
///
/// Restitutions below 1e-65 count as zero.
/// Source: M. Weber, thesis, appendix C (motion in contact); escape velocity derived here.
class AdhesiveContact {
 public:
  /// Throws InvalidParameter unless F_ad, H_cut and E_tail are finite and not below zero.
  AdhesiveContact(const LinearSpringDashpot& spring, const Adhesion& adhesion)
      : spring_(spring), adhesion_(adhesion) {
    require_non_negative("adhesion force F_ad", adhesion.force);
    require_non_negative("surface cut-off H_cut", adhesion.cutoff);
    require_non_negative("tail energy", adhesion.tail_energy);
    const double impedance = std::sqrt(spring.stiffness()) * std::sqrt(spring.reduced_mass());
    w0_ = std::sqrt(spring.stiffness() / spring.reduced_mass());
    zeta_ = 0.5 * spring.damping() / impedance;
    b_ = adhesion.force / impedance;
    well_speed_ = std::sqrt(2.0 * adhesion.well_energy() / spring.reduced_mass());
    approach_speed_ = std::sqrt(2.0 * adhesion.approach_energy() / spring.reduced_mass());
    unpaid_ = adhesion.forms_at_touch ? well_speed_ * well_speed_ : 0.0;
  }

  const LinearSpringDashpot& spring() const { return spring_; }
  const Adhesion& adhesion() const { return adhesion_; }

  /// F_ad/K, [length]: where a captured pair comes to rest.
  double static_overlap() const { return adhesion_.force / spring_.stiffness(); }

  /// F_ad^2/(2 K), [energy]: work of the adhesion force on the way to rest. A rigid particle has
  /// none; it grows as the spring is made softer.
  double spring_adhesion_energy() const { return 0.5 * adhesion_.force * static_overlap(); }

  /// Speed u at first touch of a pair that approaches at `far_speed`; [length/time].
  double entry_speed(double far_speed) const { return std::hypot(far_speed, approach_speed_); }

  /// Largest overlap [length] of a pair that touches at `entry_speed` u [length/time]; the static
  /// overlap when an overdamped pair creeps towards it from outside.
  double maximum_overlap(double entry_speed) const {
    require_non_negative("entry speed", entry_speed);
    if (entry_speed == 0.0 && b_ == 0.0) return 0.0;
    const Motion m(entry_speed, b_, zeta_);
    return (b_ + m.amplitude() * std::exp(-zeta_ * m.peak_time())) / w0_;
  }

  /// v_esc [length/time], the far approach speed above which the pair comes apart again: 0 without
  /// attraction or without any loss, infinite with attraction at zero restitution.
  double escape_velocity() const {
    const double scale = std::max(b_, well_speed_);
    if (scale == 0.0 || zeta_ == 0.0) return std::sqrt(unpaid_);
    const Motion backwards(well_speed_ / scale, b_ / scale, -zeta_);
    if (!backwards.oscillates()) return std::numeric_limits<double>::infinity();
    return scale * std::sqrt(unpaid_ / scale / scale - backwards.lost(*backwards.return_time()));
  }

 private:
  // Of the tests: tests/src/contact/rebound.h
  friend double exit_speed(const AdhesiveContact&, double entry_speed);
  friend double effective_restitution(const AdhesiveContact&, double far_speed);

  /// The motion from x = 0, x' = u in the units of the class comment; speeds for all but times.
  class Motion {
   public:
    Motion(double u, double b, double zeta) : u_(u), b_(b), zeta_(zeta) {
      const double q_squared = (1.0 - zeta) * (1.0 + zeta);
      // As LinearSpringDashpot: critical damping as from_restitution rounds it is critical.
      if (std::abs(q_squared) >= 16.0 * std::numeric_limits<double>::epsilon())
        (q_squared > 0.0 ? q_ : p_) = std::sqrt(std::abs(q_squared));
    }

    /// Is there a half period, with a restitution that numbers can hold?
    bool oscillates() const { return pi * std::abs(zeta_) < 150.0 * q_; }

    /// sqrt(Q) at x = 0. Overdamped, where a peak exists, both factors are positive.
    double amplitude() const {
      if (p_ == 0.0) return std::hypot(u_ - zeta_ * b_, q_ * b_);
      const double slow = u_ - (zeta_ - p_) * b_, fast = u_ - (zeta_ + p_) * b_;
      return fast > 0.0 ? std::sqrt(slow) * std::sqrt(fast) : 0.0;
    }

    /// Time of the largest overlap; infinite when an overdamped pair creeps.
    double peak_time() const {
      const double pull = zeta_ * u_ - b_;
      if (q_ > 0.0) return std::atan2(u_ * q_, pull) / q_;
      if (pull <= p_ * u_) return std::numeric_limits<double>::infinity();
      return p_ > 0.0 ? std::atanh(p_ * u_ / pull) / p_ : u_ / pull;
    }

    /// T, none when the pair stays in contact.
    std::optional<double> return_time() const {
      if (!oscillates()) return std::nullopt;
      double low = peak_time(), high = low + pi / q_;
      if (overlap(high) > 0.0) {
        // Backwards the pair always returns; a graze may miss x = 0 by a rounding.
        if (zeta_ > 0.0) return std::nullopt;
        return high;
      }
      // Newton, bisecting where it leaves the bracket or gains less than a factor of two.
      double time = 0.5 * (low + high), last = high - low;
      for (int i = 0; i < 200 && high - low > 0.0; ++i) {
        const double x = overlap(time);
        if (x == 0.0) break;
        (x > 0.0 ? low : high) = time;
        const double newton = time - x / rate(time);
        const bool good =
            newton > low && newton < high && 2.0 * std::abs(newton - time) < std::abs(last);
        const double next = good ? newton : 0.5 * (low + high);
        last = next - time;
        if (next == time) break;
        time = next;
      }
      return time;
    }

    /// w >= 0.
    double return_speed(double time) const {
      return zeta_ == 0.0 ? u_ : std::max(0.0, -rate(time));
    }

    /// u^2 - w^2, [speed^2].
    double lost(double time) const {
      const double q0 = amplitude();
      const double decayed = -std::expm1(-2.0 * zeta_ * time) * q0 * q0;
      if (zeta_ > 0.0) return 2.0 * zeta_ * b_ * (u_ + return_speed(time)) + decayed;
      // w from w^2 + 2 zeta b w = u^2 - 2 zeta b u - decayed, all terms of one sign.
      const double half = zeta_ * b_;
      const double w = -half + std::sqrt(half * half + u_ * u_ - 2.0 * half * u_ - decayed);
      return 2.0 * half * (u_ + w) + decayed;
    }

   private:
    /// w0 x; 1 - exp cos is split so that it keeps its digits when the pair barely returns.
    double overlap(double time) const {
      const double half = std::sin(0.5 * q_ * time), fall = std::expm1(-zeta_ * time);
      const double c = std::cos(q_ * time), s = std::sin(q_ * time);
      return b_ * (2.0 * half * half - fall * c) +
             (u_ - zeta_ * b_) / q_ * std::exp(-zeta_ * time) * s;
    }

    /// x'
    double rate(double time) const {
      return std::exp(-zeta_ * time) *
             (u_ * std::cos(q_ * time) + (b_ - zeta_ * u_) / q_ * std::sin(q_ * time));
    }

    double u_, b_, zeta_;
    double q_ = 0.0, p_ = 0.0;  // sqrt(1 - zeta^2) or sqrt(zeta^2 - 1), the other 0
  };

  LinearSpringDashpot spring_;
  Adhesion adhesion_;
  double w0_;
  double zeta_;
  double b_;               // F_ad/sqrt(mu K), [speed]
  double well_speed_;      // sqrt(2 W/mu)
  double approach_speed_;  // the same of what is gained on the way in
  double unpaid_;          // difference of their squares
};

}  // namespace cohesion::contact
