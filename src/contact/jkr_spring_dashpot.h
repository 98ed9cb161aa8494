// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "contact/hertz_spring_dashpot.h"
#include "contact/law_point.h"
#include "validation.h"

namespace cohesion::contact {

/// The work of adhesion of two surfaces of this energy gamma, w = 2 gamma [energy/length^2]. Throws
/// InvalidParameter where gamma < 0.
inline double work_of_adhesion(double surface_energy) {
  require_non_negative("surface energy gamma", surface_energy);
  return 2.0 * surface_energy;
}

/// The energy of each of two surfaces of this work of adhesion, [energy/length^2].
inline double surface_energy(double work_of_adhesion) { return 0.5 * work_of_adhesion; }

/// The contact of Johnson, Kendall and Roberts with a dashpot, acting on the reduced mass mu of a
/// pair. With the work of adhesion w, the radius a of contact and the overlap x:
///
///   F = 4 E* a^3/(3 R*) - sqrt(8 pi w E*) a^(3/2)      x = a^2/R* - sqrt(2 pi w a/E*)
///   U = 8 E* a^5/(15 R*^2) - (4/3) (E* k/R*) a^(7/2) + E* k^2 a^2/2    k = sqrt(2 pi w/E*)
///
/// A neck forms where two touch, x = 0; they tear apart at a^3 = pi w R*^2/(8 E*), x < 0. The
/// energy is that of the surfaces, too: U = 0 without a neck, and what U falls at touch and is left
/// at tearing is lost. The dashpot c = sqrt(5) b sqrt(mu 4 E*/(3 R*)) sqrt(R*) sqrt(a) is that of
/// Hertz's contact with constant restitution where w = 0; so are force and energy then.
///
///   pull-off force                (3/2) pi w R*
///   work from touch to tearing    7.0922 (w^5 R*^4/E*^2)^(1/3)
///
/// Source: K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. Lond. A 324 (1971) 301; C.
/// Thornton, Z. Ning, Powder Technol. 99 (1998) 154.
class JkrSpringDashpot {
 public:
  /// hertz: the contact without adhesion, with constant restitution; R* [length], w
  /// [energy/length^2]. Throws InvalidParameter unless R* > 0 and w >= 0, and where the dashpot is
  /// another.
  JkrSpringDashpot(const HertzSpringDashpot& hertz, double reduced_radius, double work_of_adhesion)
      : modulus_(hertz.reduced_modulus(reduced_radius)),
        radius_(reduced_radius),
        reduced_mass_(hertz.reduced_mass()) {
    require_positive("reduced radius", reduced_radius);
    if (hertz.is_damped() && hertz.power() != HertzSpringDashpot::Damping::fourth_root)
      throw InvalidParameter("JKR's contact needs Hertz's dashpot of constant restitution");
    adhere(work_of_adhesion);
    stiffness_ = 4.0 * modulus_ / (3.0 * reduced_radius);
    damping_ = hertz.damping() / std::sqrt(std::sqrt(reduced_radius));
  }

  /// The same contact with another work of adhesion. Throws InvalidParameter unless it is >= 0.
  JkrSpringDashpot with_work_of_adhesion(double work_of_adhesion) const {
    JkrSpringDashpot other = *this;
    other.adhere(work_of_adhesion);
    return other;
  }

  /// The largest pull that a contact bears, (3/2) pi w R* [force].
  static double pull_off_force(double reduced_radius, double work_of_adhesion) {
    return 1.5 * pi * work_of_adhesion * reduced_radius;
  }
  /// The gap at which two tear apart, (3/4) (pi^2 w^2 R*/E*^2)^(1/3) [length].
  static double tearing_gap(double reduced_modulus, double reduced_radius,
                            double work_of_adhesion) {
    const double strain = pi * work_of_adhesion / reduced_modulus;
    return 0.75 * std::cbrt(strain * strain * reduced_radius);
  }

  double reduced_mass() const { return reduced_mass_; }
  double work_of_adhesion() const { return work_of_adhesion_; }
  bool is_damped() const { return damping_ > 0.0; }
  /// The overlap at which two tear apart, below 0, [length].
  double lowest_overlap() const { return lowest_; }
  /// The energy of the neck that forms at touch, below 0, [energy].
  double touch_energy() const { return at(0.0).energy; }
  /// Up to twice the pull-off force holds friction against a contact that is pulled, [force].
  double friction_load() const { return 2.0 * pull_off_force(radius_, work_of_adhesion_); }

  /// At an overlap x >= lowest_overlap() [length]. Inlined, so that what a caller does not need
  /// costs nothing.
  [[gnu::always_inline]] LawPoint at(double x) const {
    const bool adheres = neck_ > 0.0;
    const double s = adheres ? scale_ * root_of_radius(std::max(x, lowest_) * inverse_cube_)
                             : std::sqrt(std::sqrt(radius_ * std::max(x, 0.0)));
    const double s2 = s * s, s3 = s2 * s, kR = neck_ * radius_;
    const double pull = modulus_ * neck_;
    // Where they tear apart the stiffness is without bound.
    const double steep = std::max(4.0 * s3 - kR, 1e-9 * kR);
    LawPoint p;
    p.force = stiffness_ * s3 * s3 - 2.0 * pull * s3;
    p.stiffness = adheres ? radius_ * 6.0 * s2 * (stiffness_ * s3 - pull) / steep
                          : 1.5 * radius_ * stiffness_ * s2;
    p.energy = s2 * s2 *
               (0.4 * stiffness_ / radius_ * s3 * s3 - 4.0 / 3.0 * pull / radius_ * s3 +
                0.5 * pull * neck_);
    p.damping = damping_ * s;
    p.damping_integral = damping_ / radius_ * s2 * (0.8 * s3 - 0.5 * kR);
    p.radius_stiffness = 2.0 * modulus_ * s2;
    return p;
  }

 private:
  /// 4^(-1/3): sqrt(a) where they tear apart, over scale_.
  static constexpr double tearing = 0.6299605249474366;

  /// The root q >= 4^(-1/3) of q^4 - q = x, sqrt(a) and the overlap in units of scale_, to
  /// rounding: a first guess good to 2.1e-6 and two steps of Newton's method with one slope.
  static double root_of_radius(double x) {
    constexpr double lowest = -0.4724703937105774;  // -3 4^(-4/3)
    const double above = x - lowest;
    if (!(above > 0.0)) return tearing;
    double q = x < 35.0 ? root_near_tearing(std::sqrt(above)) : root_far_from_tearing(x);
    const double inverse_slope = 1.0 / (4.0 * q * q * q - 1.0);
    for (int k = 0; k < 2; k++) q -= (q * (q * q * q - 1.0) - x) * inverse_slope;
    return std::max(q, tearing);
  }
  /// A rational function fitted for 0 <= t <= 6, t^2 the overlap from tearing on.
  static double root_near_tearing(double t) {
    return (tearing +
            t * (1.2392675677806708 + t * (0.4897877074016311 + t * 0.03200248780744569))) /
           (1.0 + t * (0.9385588148048291 + t * (0.1641813021361082 + t * 0.0027391763801528912)));
  }
  /// Three terms of the series for large x.
  static double root_far_from_tearing(double x) {
    const double s = std::sqrt(std::sqrt(x)), inverse = 1.0 / s;
    return s + inverse * inverse * (0.25 - 0.03125 * inverse * inverse * inverse);
  }

  void adhere(double work_of_adhesion) {
    require_non_negative("work of adhesion", work_of_adhesion);
    work_of_adhesion_ = work_of_adhesion;
    neck_ = std::sqrt(2.0 * pi * work_of_adhesion / modulus_);
    scale_ = std::cbrt(neck_ * radius_);
    inverse_cube_ = neck_ > 0.0 ? radius_ / std::pow(scale_, 4.0) : 0.0;
    lowest_ = -tearing_gap(modulus_, radius_, work_of_adhesion);
  }

  double modulus_;
  double radius_;
  double work_of_adhesion_;
  double reduced_mass_;
  double neck_;          // k
  double scale_;         // (k R*)^(1/3), of sqrt(a)
  double inverse_cube_;  // of the overlap, over that unit
  double lowest_;
  double stiffness_;  // 4 E*/(3 R*)
  double damping_;    // over sqrt(a)
};

}  // namespace cohesion::contact
