// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "vector3.h"

namespace cohesion::contact {

struct TangentialParameters {
  double stiffness;  ///< K_t, [force/length]
  double damping;    ///< eta_t, [mass/time]
  double friction;   ///< mu_f, or mu_R of a spring that resists rolling, [1]
};

/// What the tangential spring does in one interval of contact.
struct TangentialStep {
  Vector3 impulse;        ///< on particle j, its reverse on i, [momentum]
  Vector3 displacement;   ///< of the spring at the end, [length]
  double damped = 0.0;    ///< energy lost in the dashpot, [energy]
  double friction = 0.0;  ///< energy lost in sliding, [energy]
};

/// The plane of contact of two particles.
struct Plane {
  Vector3 normal;         ///< of any length
  double inverse_square;  ///< 1/(normal normal)

  Vector3 part_in(const Vector3& a) const { return a - (inverse_square * dot(a, normal)) * normal; }

  /// A vector in the plane of another contact turned into this one, its length kept.
  [[gnu::always_inline]] Vector3 turned_into(const Vector3& a) const {
    const double along = dot(a, normal), whole = dot(a, a);
    const double square = whole - inverse_square * along * along;
    const double stretch = square > 0.0 ? std::sqrt(whole / square) : 0.0;
    return stretch * (a - (inverse_square * along) * normal);
  }
};

/// Tangential spring, dashpot and Coulomb slider over an interval of contact of any length.
///
///   J = -T (K_t s_mid + eta_t v_mid)    |J| <= mu_f P    v_mid = v + J/(2 m_t)
///
/// by the implicit midpoint rule: the energy of spring and motion is kept exactly but for what
/// dashpot and slider take, and no stiffness or damping makes it unstable. P is the impulse of the
/// normal spring and dashpot in the same interval; m_t the effective mass of a tangential impulse,
/// 1/m_t = 1/m_i + 1/m_j + l_i^2/I_i + l_j^2/I_j with lever arms l. The slider is in series with
/// spring and dashpot: while it slides, they stretch at the rate at which they carry the Coulomb
/// force, which goes linearly through the interval to mu_f N at its end:
///
///   eta_t s' + K_t s = mu_f N(t)
///
/// but no further than the surfaces move. Where that would make the slider give energy (an interval
/// too long for the change of N), they stretch by the midpoint rule, and the spring alone carries
/// no more than the mean Coulomb force: then it never does. The law is of second order in T, also
/// where sliding ends.
///
/// The same law resists rolling, elastic-plastic, with the effective mass of rolling m_r in place
/// of m_t (contact_solver/contact_bodies.h).
///
/// Source: P. A. Cundall and O. D. L. Strack, Geotechnique 29 (1979) 47; van der Hoef et al.,
/// Adv. Chem. Eng. 31 (2006) 65, eq. 27-29. Rolling: S. Luding, Granular Matter 10 (2008) 235;
/// Y. Wang, F. Alonso-Marroquin, W. W. Guo, Particuology 23 (2015) 49.
class TangentialSpring {
 public:
  explicit TangentialSpring(const TangentialParameters& p) : p_(p) {}

  /// displacement [length] and velocity [length/time] of j's surface against i's, both in the plane
  /// of contact, at the start; time T; 1/m_t; P [momentum]; N at the end [force].
  [[gnu::always_inline]] TangentialStep advance(const Vector3& displacement,
                                                const Vector3& velocity, double time,
                                                double inverse_mass, double normal_impulse,
                                                double normal_force_at_end) const {
    const Vector3 sticking_impulse =
        impulse_of_sticking(displacement, velocity, time, inverse_mass);
    const double limit = p_.friction * std::max(normal_impulse, 0.0);
    TangentialStep step;
    if (norm(sticking_impulse) > limit) {
      step = slide(displacement, velocity, time, inverse_mass, sticking_impulse, limit,
                   normal_force_at_end);
    } else {
      const Vector3 middle = velocity + (0.5 * inverse_mass) * sticking_impulse;
      step = {sticking_impulse, displacement + time * middle,
              p_.damping * dot(middle, middle) * time, 0.0};
    }
    return step;
  }

  /// [energy]
  double stored_energy(const Vector3& displacement) const {
    return 0.5 * p_.stiffness * dot(displacement, displacement);
  }

 private:
  /// The force per v_mid: what spring and dashpot are worth as a dashpot, [mass/time].
  double effective_damping(double time) const { return 0.5 * time * p_.stiffness + p_.damping; }

  /// The impulse that keeps the surfaces together, whatever the limit of the slider.
  Vector3 impulse_of_sticking(const Vector3& displacement, const Vector3& velocity, double time,
                              double inverse_mass) const {
    const double damping = effective_damping(time);
    const double softened = time / (1.0 + 0.5 * time * damping * inverse_mass);
    return (-softened * p_.stiffness) * displacement - (softened * damping) * velocity;
  }

  /// An interval in which sticking would take `sticking_impulse`, which is above `limit`. Vectors
  /// are passed by value: those of the caller need no place in memory then, unless something
  /// slides.
  [[gnu::noinline]] TangentialStep slide(Vector3 displacement, Vector3 velocity, double time,
                                         double inverse_mass, Vector3 sticking_impulse,
                                         double limit, double normal_force_at_end) const {
    TangentialStep step;
    const Vector3 direction = (-1.0 / norm(sticking_impulse)) * sticking_impulse;
    step.impulse = -limit * direction;
    const Vector3 middle = velocity + (0.5 * inverse_mass) * step.impulse;
    const double work = -dot(step.impulse, middle);
    const double end = p_.friction * std::max(normal_force_at_end, 0.0);
    set_losses(
        step, displacement,
        displacement_after_sliding(displacement, direction, time * middle, time, limit / time, end),
        work, time);
    if (step.friction < 0.0)
      set_losses(step, displacement,
                 displacement_by_midpoint(displacement, direction, effective_damping(time), time,
                                          limit / time),
                 work, time);
    return step;
  }

  /// The step's energies, from the work of the Coulomb force on the surfaces.
  void set_losses(TangentialStep& step, const Vector3& before, const Vector3& after, double work,
                  double time) const {
    const Vector3 stretch = after - before;
    step.displacement = after;
    step.damped = p_.damping * dot(stretch, stretch) / time;
    step.friction = stored_energy(before) - stored_energy(after) + work - step.damped;
  }

  /// The displacement after an interval of sliding under the Coulomb force of given mean and end.
  Vector3 displacement_after_sliding(const Vector3& before, const Vector3& direction,
                                     const Vector3& way, double time, double mean,
                                     double end) const {
    if (p_.stiffness == 0.0) return before + way;
    const double lag = p_.damping / p_.stiffness;
    const double rate = 2.0 * (end - mean) / time;
    const double start = 2.0 * mean - end;
    const double memory = lag > 0.0 ? std::exp(-time / lag) : 0.0;
    const double compliance = 1.0 / p_.stiffness;
    const Vector3 after =
        memory * before +
        (compliance * (end - lag * rate - memory * (start - lag * rate))) * direction;
    return dot(after - before, direction) > dot(way, direction) ? before + way : after;
  }

  Vector3 displacement_by_midpoint(const Vector3& before, const Vector3& direction, double damping,
                                   double time, double mean) const {
    const Vector3 after = before + (time / damping) * (mean * direction - p_.stiffness * before);
    const double spring_force = p_.stiffness * norm(after);
    return spring_force > mean ? (mean / spring_force) * after : after;
  }

  TangentialParameters p_;
};

}  // namespace cohesion::contact
