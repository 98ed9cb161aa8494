// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "contact/linear_spring_dashpot.h"
#include "contact/tangential_spring.h"
#include "mixing.h"
#include "validation.h"

namespace cohesion::contact {

/// A linear contact as users give it for a pair of materials; masses come in per pair of particles.
/// Its laws are in linear_spring_dashpot.h and tangential_spring.h.
struct ContactParameters {
  double stiffness = 0.0;                 ///< K, [force/length]
  double restitution = 1.0;               ///< e of the contact without cohesion, [1]
  double damping = -1.0;                  ///< eta, [mass/time], in place of e when not negative
  double tangential_ratio = 2.0 / 7.0;    ///< K_t/K, [1]; 2/7: equal contact times of solid spheres
  double tangential_damping_ratio = 0.5;  ///< eta_t/eta, [1]
  double friction = 0.0;                  ///< mu_f, [1]; 0: no tangential force at all
  double rolling_friction = 0.0;          ///< mu_R, [1]; 0: nothing resists rolling
};

/// Throws InvalidParameter unless K > 0, 0 <= e <= 1 and the rest is not negative, all finite.
inline void require_valid(const ContactParameters& p) {
  require_positive("stiffness K", p.stiffness);
  require(std::isfinite(p.restitution) && p.restitution >= 0.0 && p.restitution <= 1.0,
          "restitution e", p.restitution, "must lie between 0 and 1");
  require(std::isfinite(p.damping), "damping eta", p.damping, "must be a finite number");
  require_non_negative("ratio of tangential to normal stiffness", p.tangential_ratio);
  require_non_negative("ratio of tangential to normal damping", p.tangential_damping_ratio);
  require_non_negative("friction coefficient", p.friction);
  require_non_negative("rolling friction coefficient", p.rolling_friction);
}

/// The contact of unlike materials, by geometric means; damping is given in place of e when both
/// give it.
inline ContactParameters mixed(const ContactParameters& a, const ContactParameters& b) {
  ContactParameters m;
  m.stiffness = geometric_mean(a.stiffness, b.stiffness);
  m.restitution = geometric_mean(a.restitution, b.restitution);
  if (a.damping >= 0.0 && b.damping >= 0.0) m.damping = geometric_mean(a.damping, b.damping);
  m.tangential_ratio = geometric_mean(a.tangential_ratio, b.tangential_ratio);
  m.tangential_damping_ratio =
      geometric_mean(a.tangential_damping_ratio, b.tangential_damping_ratio);
  m.friction = geometric_mean(a.friction, b.friction);
  m.rolling_friction = geometric_mean(a.rolling_friction, b.rolling_friction);
  return m;
}

/// The normal contact of a pair of reduced mass mu.
inline LinearSpringDashpot normal_contact(const ContactParameters& p, double reduced_mass) {
  if (p.damping >= 0.0) return {p.stiffness, p.damping, reduced_mass};
  return LinearSpringDashpot::from_restitution(p.stiffness, p.restitution, reduced_mass);
}

/// The tangential contact that belongs to a normal one.
inline TangentialParameters tangential_contact(const ContactParameters& p,
                                               const LinearSpringDashpot& normal) {
  return {p.tangential_ratio * p.stiffness, p.tangential_damping_ratio * normal.damping(),
          p.friction};
}

/// The rolling contact has the same spring and dashpot, and mu_R in place of mu_f.
inline TangentialParameters rolling_contact(const ContactParameters& p,
                                            const LinearSpringDashpot& normal) {
  TangentialParameters rolling = tangential_contact(p, normal);
  rolling.friction = p.rolling_friction;
  return rolling;
}

}  // namespace cohesion::contact
