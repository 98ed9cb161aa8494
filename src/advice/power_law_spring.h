// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/contact_parameters.h"
#include "validation.h"

namespace cohesion::advice {

/// Springs and dashpot of a contact whose force grows as a power of the overlap x,
///
///   F = c x^p,   dashpot eta ~ x^((p-1)/2)     p = 1: linear, p = 3/2: Hertz
///
/// given by what they are at one overlap. Any consistent set of units.
struct ContactSprings {
  double stiffness;                   ///< F/x, [force/length]
  double damping;                     ///< eta, [mass/time]
  double tangential_stiffness = 0.0;  ///< K_t, [force/length]; grows as `stiffness` does
  double rolling_stiffness = 0.0;     ///< K_r, [force/length]; the same
  double tangential_damping = 0.0;    ///< eta_t, [mass/time]; grows as `damping` does
  double rolling_damping = 0.0;       ///< eta_r, [mass/time]; the same
  double exponent = 1.0;              ///< p, [1]
  double overlap = 0.0;               ///< x at which they are this; read unless p = 1, [length]
  /// How the dashpot of p = 3/2 grows; linear_springs() takes it for the fourth root.
  contact::HertzSpringDashpot::Damping power = contact::HertzSpringDashpot::Damping::fourth_root;

  /// JKR's contact, for which the springs of Hertz's stand.
  std::optional<contact::JkrSpringDashpot> jkr = {};

  double modulus = 0.0;  ///< E* of Hertz's and JKR's contact, where known, [force/length^2]

  /// Of p = 3/2, on the reduced mass mu [mass].
  contact::HertzSpringDashpot hertz(double reduced_mass) const {
    const double root = std::sqrt(overlap);
    const bool fourth_root = power == contact::HertzSpringDashpot::Damping::fourth_root;
    return {stiffness / root, power, damping / (fourth_root ? std::sqrt(root) : root),
            reduced_mass};
  }
};

/// Of a contact: where its spring is not linear, at a small overlap. reduced_radius [length]: R* of
/// two spheres, R beside a wall; mu [mass].
inline ContactSprings springs_of(const contact::ContactParameters& p, double reduced_radius,
                                 double reduced_mass) {
  constexpr double small = 1e-4;
  contact::ContactParameters without_adhesion = p;
  without_adhesion.work_of_adhesion = 0.0;
  const contact::NormalLaw law =
      contact::normal_law(without_adhesion, reduced_radius, reduced_mass);
  ContactSprings s{};
  contact::TangentialParameters tangential{};
  if (const auto* linear = std::get_if<contact::LinearSpringDashpot>(&law)) {
    s.stiffness = linear->stiffness();
    s.damping = linear->damping();
    s.exponent = 1.0;
    tangential = contact::tangential_contact(p, *linear);
  } else {
    s.overlap = small * reduced_radius;
    s.exponent = 1.5;
    s.modulus = p.modulus;
    const contact::LawPoint at = std::get<contact::HertzSpringDashpot>(law).at(s.overlap);
    s.stiffness = at.force / s.overlap;
    s.damping = at.damping;
    tangential = contact::tangential_contact(p, at);
    if (p.work_of_adhesion > 0.0)
      s.jkr =
          std::get<contact::JkrSpringDashpot>(contact::normal_law(p, reduced_radius, reduced_mass));
  }
  if (p.friction > 0.0) {
    s.tangential_stiffness = tangential.stiffness;
    s.tangential_damping = tangential.damping;
  }
  if (p.rolling_friction > 0.0) {
    s.rolling_stiffness = tangential.stiffness;
    s.rolling_damping = tangential.damping;
  }
  return s;
}

/// Largest overlap [length], without dashpot, of a pair of reduced mass mu [mass] that touches at
/// `speed` u [length/time] while `attraction` F_ad [force] pulls: c x^(p+1)/(p+1) = F_ad x + mu
/// u^2/2.
inline double largest_overlap(const ContactSprings& s, double reduced_mass, double attraction,
                              double speed) {
  const double p = s.exponent;
  const double work = 0.5 * reduced_mass * speed * speed;
  // Of the force c x^p.
  const double c = s.stiffness * std::pow(s.overlap, 1.0 - p);
  // Beyond both, the spring has stored twice what either can give.
  double high = std::max(std::pow(2.0 * attraction * (p + 1.0) / c, 1.0 / p),
                         std::pow(2.0 * work * (p + 1.0) / c, 1.0 / (p + 1.0)));
  double low = 0.0;
  // Halved to the last bit: what is looked for is not far below the upper end.
  for (int k = 0; k < 60; k++) {
    const double x = 0.5 * (low + high);
    (c * std::pow(x, p + 1.0) / (p + 1.0) < attraction * x + work ? low : high) = x;
  }
  return high;
}

/// The linear springs and dashpot, p = 1, that stand for `s` in an impact: pressed as far by it,
/// and of the same restitution. With F/x and eta at the largest overlap,
///
///   K = 2/(p+1) F/x      eta -> 2/(p+1) eta
///
/// K stores there what the power law does. With z = 2/(p+1) x^((p+1)/2) as measure of the overlap,
/// the speed v over z, v dv/dz = -(eta/mu) v - ..., is that of a linear oscillator: the restitution
/// does not depend on the speed, and is that of zeta = eta/(2 sqrt(mu F/x)) sqrt(2/(p+1)), which K
/// and eta above have. Their contact takes pi/2.94 = 1.07 times as long as Hertz's.
///
/// Where nothing moves and nothing attracts: at the overlap at which `s` is given.
/// Throws InvalidParameter unless F/x, mu and, for p != 1, the overlap are positive.
///
/// Source: derived here; for Hertz: D. Antypov and J. A. Elliott, EPL 94 (2011) 50004.
inline ContactSprings linear_springs(const ContactSprings& s, double reduced_mass,
                                     double attraction, double speed) {
  require_positive("stiffness K", s.stiffness);
  require_positive("reduced mass", reduced_mass);
  if (s.exponent == 1.0) return s;
  require_positive("overlap", s.overlap);
  double x = largest_overlap(s, reduced_mass, attraction, speed);
  if (x == 0.0) x = s.overlap;
  const double stiffer = std::pow(x / s.overlap, s.exponent - 1.0);
  const double mean = 2.0 / (s.exponent + 1.0);
  return {mean * stiffer * s.stiffness,
          mean * std::sqrt(stiffer) * s.damping,
          stiffer * s.tangential_stiffness,
          stiffer * s.rolling_stiffness,
          std::sqrt(stiffer) * s.tangential_damping,
          std::sqrt(stiffer) * s.rolling_damping,
          1.0,
          x};
}

}  // namespace cohesion::advice
