// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "constants.h"
#include "contact/law_point.h"
#include "validation.h"

namespace cohesion::contact {

/// The contact of Hertz with a dashpot, acting on the reduced mass mu of a pair, without adhesion.
/// x is the overlap:
///
///   F = k x^(3/2) + c(x) x'    k = (4/3) E* sqrt(R*)
///
/// with c ~ x^(1/4), for which the restitution is the same at every speed, or c ~ x^(1/2).
///
/// Source: H. Hertz, J. reine angew. Math. 92 (1881) 156; Y. Tsuji, T. Tanaka, T. Ishida, Powder
/// Technol. 71 (1992) 239; D. Antypov, J. A. Elliott, EPL 94 (2011) 50004.
class HertzSpringDashpot {
 public:
  /// The power of the overlap in c.
  enum class Damping { fourth_root, square_root };

  /// k [force/length^(3/2)], c over that power of the overlap, mu [mass]. Throws InvalidParameter
  /// unless k > 0, c >= 0, mu > 0, all finite.
  HertzSpringDashpot(double coefficient, Damping power, double damping, double reduced_mass)
      : coefficient_(coefficient),
        power_(power),
        damping_(damping),
        integral_(power == Damping::fourth_root ? 0.8 : 2.0 / 3.0),
        reduced_mass_(reduced_mass) {
    require_positive("coefficient of the Hertz contact", coefficient);
    require_non_negative("damping of the Hertz contact", damping);
    require_positive("reduced mass", reduced_mass);
  }

  /// c = sqrt(5) b sqrt(mu k) x^(1/4), b = -ln e/sqrt(pi^2 + ln^2 e), which gives the restitution e
  /// at every speed; b = 1 for e = 0. E* [force/length^2], R* [length]. Throws InvalidParameter
  /// unless 0 <= e <= 1.
  static HertzSpringDashpot from_restitution(double effective_modulus, double reduced_radius,
                                             double restitution, double reduced_mass) {
    require_positive("effective Young's modulus", effective_modulus);
    require_positive("reduced radius", reduced_radius);
    require_positive("reduced mass", reduced_mass);
    require(std::isfinite(restitution) && restitution >= 0.0 && restitution <= 1.0, "restitution e",
            restitution, "must lie between 0 and 1");
    const double k = 4.0 / 3.0 * effective_modulus * std::sqrt(reduced_radius);
    const double lost = restitution > 0.0 ? -std::log(restitution) : 0.0;
    const double part = restitution > 0.0 ? lost / std::hypot(pi, lost) : 1.0;
    return {k, Damping::fourth_root, std::sqrt(5.0 * reduced_mass * k) * part, reduced_mass};
  }

  /// LawPoint::radius_stiffness of Hertz's contact whose force over the overlap is F/x
  /// [force/length].
  static constexpr double radius_stiffness_of(double force_over_overlap) {
    return 1.5 * force_over_overlap;
  }

  double coefficient() const { return coefficient_; }
  /// E* [force/length^2] of a contact with this R* [length].
  double reduced_modulus(double reduced_radius) const {
    return 0.75 * coefficient_ / std::sqrt(reduced_radius);
  }
  double reduced_mass() const { return reduced_mass_; }
  /// c over its power of the overlap.
  double damping() const { return damping_; }
  Damping power() const { return power_; }
  bool is_damped() const { return damping_ > 0.0; }

  /// As JkrSpringDashpot has them: contacts end at touch, and nothing adheres.
  static constexpr double lowest_overlap() { return 0.0; }
  static constexpr double friction_load() { return 0.0; }

  /// At an overlap x >= 0 [length].
  [[gnu::always_inline]] LawPoint at(double x) const {
    const double root = std::sqrt(x);
    const double force = coefficient_ * root * x;
    const double stiffness = 1.5 * coefficient_ * root;
    const double damping = damping_ * (power_ == Damping::fourth_root ? std::sqrt(root) : root);
    return {force, stiffness, 0.4 * force * x, damping, integral_ * damping * x, stiffness};
  }

  /// The time of an elastic impact that touches at speed v [length/time]: 2.9433 (m/v^(1/5)), with
  /// m = (5 mu/(4 k))^(2/5).
  double contact_time(double speed) const {
    return 2.9432750 * std::pow(1.25 * reduced_mass_ / coefficient_, 0.4) * std::pow(speed, -0.2);
  }

 private:
  double coefficient_;
  Damping power_;
  double damping_;
  double integral_;  // of a power of the overlap, over its product with it
  double reduced_mass_;
};

}  // namespace cohesion::contact
