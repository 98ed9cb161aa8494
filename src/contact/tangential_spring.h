// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "vector3.h"

namespace cohesion::contact {

struct TangentialParameters {
  double stiffness;  ///< K_t, [force/length]
  double damping;    ///< eta_t, [mass/time]
  double friction;   ///< mu_f, [1]
};

/// What the tangential spring does in one stretch of contact.
struct TangentialStep {
  Vector3 impulse;        ///< on particle j, its reverse on i, [momentum]
  Vector3 displacement;   ///< of the spring at the end, [length]
  double damped = 0.0;    ///< energy lost in the dashpot, [energy]
  double friction = 0.0;  ///< energy lost in sliding, [energy]
};

/// Tangential spring, dashpot and Coulomb slider over a stretch of contact of any length.
///
///   J = -T (K_t s_mid + eta_t v_mid)    |J| <= mu_f P    v_mid = v + J/(2 m_t)
///
/// by the implicit midpoint rule: the energy of spring and motion is kept exactly but for what
/// dashpot and slider take, and no stiffness or damping makes it unstable. P is the impulse of the
/// normal spring and dashpot in the same stretch; m_t the mass that answers a tangential impulse,
/// 1/m_t = 1/m_i + 1/m_j + l_i^2/I_i + l_j^2/I_j with lever arms l. The slider is in series with
/// spring and dashpot: while it slides, they stretch at the rate at which they carry the Coulomb
/// force, and the spring alone holds no more than that. So the slider never gives energy.
///
/// Source: P. A. Cundall and O. D. L. Strack, Geotechnique 29 (1979) 47; van der Hoef et al.,
/// Adv. Chem. Eng. 31 (2006) 65, eq. 27-29.
class TangentialSpring {
 public:
  explicit TangentialSpring(const TangentialParameters& p) : p_(p) {}

  /// displacement [length] and velocity [length/time] of j's surface against i's, both in the plane
  /// of contact, at the start; time T; m_t; P [momentum].
  TangentialStep advance(const Vector3& displacement, const Vector3& velocity, double time,
                         double tangential_mass, double normal_impulse) const {
    TangentialStep step;
    const double answer = 0.5 * time * p_.stiffness + p_.damping;  // force per v_mid
    const double softened = 1.0 / (1.0 + 0.5 * time * answer / tangential_mass);
    step.impulse = (-time * softened) * (p_.stiffness * displacement + answer * velocity);

    const double limit = p_.friction * std::max(normal_impulse, 0.0);
    const double size = norm(step.impulse);
    const bool slides = size > limit;
    if (slides) step.impulse = (limit / size) * step.impulse;
    const Vector3 middle = velocity + (0.5 / tangential_mass) * step.impulse;
    Vector3 stretching = middle;
    if (slides) {
      const Vector3 force = (-1.0 / time) * step.impulse;
      stretching = (1.0 / answer) * (force - p_.stiffness * displacement);
    }
    step.displacement = displacement + time * stretching;
    step.damped = p_.damping * dot(stretching, stretching) * time;
    if (!slides) return step;
    const double carried = p_.stiffness * norm(step.displacement) * time;
    if (carried > limit) step.displacement = (limit / carried) * step.displacement;
    step.friction = stored_energy(displacement) - stored_energy(step.displacement) -
                    dot(step.impulse, middle) - step.damped;
    return step;
  }

  /// [energy]
  double stored_energy(const Vector3& displacement) const {
    return 0.5 * p_.stiffness * dot(displacement, displacement);
  }

  /// The displacement in the plane of contact of another normal, its length kept.
  static Vector3 turned(const Vector3& displacement, const Vector3& normal) {
    const double before = dot(displacement, displacement);
    const Vector3 in_plane = displacement - dot(displacement, normal) * normal;
    const double after = dot(in_plane, in_plane);
    return after > 0.0 ? std::sqrt(before / after) * in_plane : Vector3{};
  }

 private:
  TangentialParameters p_;
};

}  // namespace cohesion::contact
