// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/normal_law.h"
#include "contact/tangential_spring.h"
#include "mixing.h"
#include "validation.h"

namespace cohesion::contact {

/// A contact as users give it for a pair of materials; masses and radii come in per pair of
/// particles. Its laws are in normal_law.h and tangential_spring.h.
struct ContactParameters {
  double stiffness = 0.0;  ///< K of a linear spring, [force/length]
  double modulus = 0.0;    ///< E* of Hertz's contact, in place of K when above 0, [force/length^2]
  double work_of_adhesion = 0.0;  ///< w of JKR's contact, with E*, when above 0, [energy/length^2]
  double restitution = 1.0;       ///< e of the contact without cohesion, [1]
  double damping = -1.0;          ///< eta, [mass/time], in place of e when not negative
  /// K_t over dF/dx of the normal spring, [1]; 2/7: equal contact times of solid spheres.
  double tangential_ratio = 2.0 / 7.0;
  double tangential_damping_ratio = 0.5;  ///< eta_t/eta, [1]
  double friction = 0.0;                  ///< mu_f, [1]; 0: no tangential force at all
  double rolling_friction = 0.0;          ///< mu_R, [1]; 0: nothing resists rolling

  bool is_hertz() const { return modulus > 0.0; }
};

/// E* = E/(2 (1 - nu^2)) of two of this material, [force/length^2]. Throws InvalidParameter unless
/// E > 0 and 0 <= nu <= 1/2.
inline double reduced_modulus(double youngs_modulus, double poissons_ratio) {
  require_positive("Young's modulus E", youngs_modulus);
  require(poissons_ratio >= 0.0 && poissons_ratio <= 0.5, "Poisson's ratio nu", poissons_ratio,
          "must lie between 0 and 0.5");
  return 0.5 * youngs_modulus / (1.0 - poissons_ratio * poissons_ratio);
}

/// Sets Hertz's contact of two of this material, and the tangential stiffness of Mindlin, 8 G* a =
/// 2 (1 - nu)/(2 - nu) of the normal one. Throws InvalidParameter as reduced_modulus.
///
/// Source: R. D. Mindlin, J. Appl. Mech. 16 (1949) 259.
inline void set_hertz(ContactParameters& p, double youngs_modulus, double poissons_ratio) {
  p.modulus = reduced_modulus(youngs_modulus, poissons_ratio);
  p.tangential_ratio = 2.0 * (1.0 - poissons_ratio) / (2.0 - poissons_ratio);
}

/// Sets the work of adhesion of two surfaces of this energy [energy/length^2]. Throws
/// InvalidParameter unless gamma > 0.
inline void set_surface_energy(ContactParameters& p, double gamma) {
  p.work_of_adhesion = work_of_adhesion(gamma);
}

/// Throws InvalidParameter unless K > 0, or E* > 0 without K and eta, 0 <= e <= 1 and the rest is
/// not negative, all finite.
inline void require_valid(const ContactParameters& p) {
  if (p.is_hertz()) {
    require(p.stiffness == 0.0, "stiffness K", p.stiffness,
            "is of a linear spring: give it or the moduli of hertz, not both");
    require(!(p.damping >= 0.0), "damping eta", p.damping,
            "is of a linear dashpot: give the restitution of hertz");
  } else {
    require_positive("stiffness K", p.stiffness);
  }
  require(std::isfinite(p.restitution) && p.restitution >= 0.0 && p.restitution <= 1.0,
          "restitution e", p.restitution, "must lie between 0 and 1");
  require(std::isfinite(p.damping), "damping eta", p.damping, "must be a finite number");
  require_non_negative("work of adhesion", p.work_of_adhesion);
  require_non_negative("ratio of tangential to normal stiffness", p.tangential_ratio);
  require_non_negative("ratio of tangential to normal damping", p.tangential_damping_ratio);
  require_non_negative("friction coefficient", p.friction);
  require_non_negative("rolling friction coefficient", p.rolling_friction);
}

/// The contact of unlike materials, by geometric means, but 2/E* = 1/E*_a + 1/E*_b as elasticity
/// has it; damping is given in place of e when both give it. Throws InvalidParameter where one is
/// Hertz's and the other linear.
inline ContactParameters mixed(const ContactParameters& a, const ContactParameters& b) {
  require(
      a.is_hertz() == b.is_hertz(), "modulus", std::max(a.modulus, b.modulus),
      "is of one of two materials, and the other has a linear spring: give the contact of both");
  ContactParameters m;
  m.stiffness = geometric_mean(a.stiffness, b.stiffness);
  if (a.is_hertz()) m.modulus = 2.0 / (1.0 / a.modulus + 1.0 / b.modulus);
  m.work_of_adhesion = geometric_mean(a.work_of_adhesion, b.work_of_adhesion);
  m.restitution = geometric_mean(a.restitution, b.restitution);
  if (a.damping >= 0.0 && b.damping >= 0.0) m.damping = geometric_mean(a.damping, b.damping);
  m.tangential_ratio = geometric_mean(a.tangential_ratio, b.tangential_ratio);
  m.tangential_damping_ratio =
      geometric_mean(a.tangential_damping_ratio, b.tangential_damping_ratio);
  m.friction = geometric_mean(a.friction, b.friction);
  m.rolling_friction = geometric_mean(a.rolling_friction, b.rolling_friction);
  return m;
}

/// The normal contact of a pair of reduced mass mu, with a linear spring.
inline LinearSpringDashpot normal_contact(const ContactParameters& p, double reduced_mass) {
  if (p.damping >= 0.0) return {p.stiffness, p.damping, reduced_mass};
  return LinearSpringDashpot::from_restitution(p.stiffness, p.restitution, reduced_mass);
}

/// The alternatives of NormalLaw.
enum class LawKind { linear, hertz, jkr };
static_assert(std::variant_size_v<NormalLaw> == 3, "LawKind has one value for each alternative");
inline LawKind kind_of_law(const ContactParameters& p) {
  if (!p.is_hertz()) return LawKind::linear;
  return p.work_of_adhesion > 0.0 ? LawKind::jkr : LawKind::hertz;
}

/// The normal law of a pair of reduced radius R* = R_i R_j/(R_i + R_j) [length], R_i next to a
/// wall, and reduced mass mu.
inline NormalLaw normal_law(const ContactParameters& p, double reduced_radius,
                            double reduced_mass) {
  const LawKind kind = kind_of_law(p);
  if (kind == LawKind::linear) return normal_contact(p, reduced_mass);
  const auto hertz =
      HertzSpringDashpot::from_restitution(p.modulus, reduced_radius, p.restitution, reduced_mass);
  if (kind == LawKind::hertz) return hertz;
  return JkrSpringDashpot(hertz, reduced_radius, p.work_of_adhesion);
}

/// The tangential contact that belongs to a normal one.
inline TangentialParameters tangential_contact(const ContactParameters& p,
                                               const LinearSpringDashpot& normal) {
  return {p.tangential_ratio * p.stiffness, p.tangential_damping_ratio * normal.damping(),
          p.friction};
}

/// The same of a normal law at an overlap.
inline TangentialParameters tangential_contact(const ContactParameters& p, const LawPoint& normal) {
  return {p.tangential_ratio * normal.radius_stiffness, p.tangential_damping_ratio * normal.damping,
          p.friction};
}

/// The rolling contact has the same spring and dashpot, and mu_R in place of mu_f.
template <class Normal>
TangentialParameters rolling_contact(const ContactParameters& p, const Normal& normal) {
  TangentialParameters rolling = tangential_contact(p, normal);
  rolling.friction = p.rolling_friction;
  return rolling;
}

}  // namespace cohesion::contact
