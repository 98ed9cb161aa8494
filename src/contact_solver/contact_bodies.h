// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/tangential_spring.h"
#include "contact_solver/pair_motion.h"

namespace cohesion::contact_solver {

/// Two spheres that touch, or a sphere and a wall: their effective masses, and how their surfaces
/// move.
///
/// The lever arms of two spheres divide the distance of their centres in proportion to the radii,
/// so that angular momentum is kept exactly; beside a wall, the limit of a large sphere, the arm is
/// the radius.
class ContactBodies {
 public:
  ContactBodies(const Body& i, const Body& j)
      : i_(i),
        j_(j),
        inverse_mass_(i.inverse_mass + j.inverse_mass),
        reduced_mass_(1.0 / inverse_mass_),
        lever_i_(j.radius > 0.0 ? i.radius / (i.radius + j.radius) : 0.0),
        rolling_radius_(j.radius > 0.0 ? lever_i_ * j.radius : i.radius),
        inverse_inertia_i_(inverse_inertia(i)),
        inverse_inertia_j_(inverse_inertia(j)) {}

  bool are(const Body& i, const Body& j) const {
    return (i.difference(i_) | j.difference(j_)) == 0;
  }
  bool is_wall() const { return !(j_.radius > 0.0); }
  /// Distance of the centres of spheres that touch, beside a wall the radius, [length].
  double distance() const { return i_.radius + j_.radius; }
  double inverse_mass() const { return inverse_mass_; }
  double inverse_mass_i() const { return i_.inverse_mass; }
  double inverse_mass_j() const { return j_.inverse_mass; }
  double reduced_mass() const { return reduced_mass_; }
  /// 1/I_i and 1/I_j, [1/(mass length^2)].
  double inverse_inertia_i() const { return inverse_inertia_i_; }
  double inverse_inertia_j() const { return inverse_inertia_j_; }

  /// The lever of rolling, R = R_i R_j/(R_i + R_j), beside a wall R_i, [length].
  double rolling_radius() const { return rolling_radius_; }
  /// 1/m_t = 1/m_i + 1/m_j + l_i^2/I_i + l_j^2/I_j, of an impulse in the plane of contact, with
  /// lever arms l, [1/mass].
  ///
  /// Source: derived here, from what an impulse changes of both velocities and spins.
  double inverse_sliding_mass() const {
    const double square = distance() * distance();
    const double i = is_wall() ? 1.0 : lever_i_, j = 1.0 - i;
    return inverse_mass_ + square * (i * i * inverse_inertia_i_ + j * j * inverse_inertia_j_);
  }
  /// 1/m_r = R^2 (1/I_i + 1/I_j), of an impulse that resists rolling, [1/mass].
  double inverse_rolling_mass() const {
    return rolling_radius_ * rolling_radius_ * (inverse_inertia_i_ + inverse_inertia_j_);
  }

  /// Where the surfaces touch, for a separation of the centres (to the foot of the normal).
  class Touch {
   public:
    Touch(const ContactBodies& bodies, const Vector3& separation)
        : Touch(bodies, separation, 1.0 / norm(separation)) {}
    /// `inverse`: one over the length of the separation.
    [[gnu::always_inline]] Touch(const ContactBodies& bodies, const Vector3& separation,
                                 double inverse)
        : bodies_(bodies),
          plane_{separation, inverse * inverse},
          lever_i_(bodies.is_wall() ? bodies.i_.radius * inverse : bodies.lever_i_) {}
    /// The same of two spheres.
    [[gnu::always_inline]] static Touch of_spheres(const ContactBodies& bodies,
                                                   const Vector3& separation, double inverse) {
      return {bodies, {separation, inverse * inverse}, bodies.lever_i_};
    }

    const contact::Plane& plane() const { return plane_; }

    /// The velocity of j's surface against i's in the plane of contact, [length/time].
    [[gnu::always_inline]] Vector3 sliding_velocity(const Vector3& velocity, const Vector3& spin_i,
                                                    const Vector3& spin_j) const {
      return sliding_velocity_across(plane_.part_in(velocity), spin_i, spin_j);
    }
    /// The same, where `across` is the part of the relative velocity in the plane.
    [[gnu::always_inline]] Vector3 sliding_velocity_across(const Vector3& across,
                                                           const Vector3& spin_i,
                                                           const Vector3& spin_j) const {
      return across - cross(lever_i_ * spin_i + (1.0 - lever_i_) * spin_j, plane_.normal);
    }
    /// The velocity at which they roll on each other, [length/time]:
    ///
    ///   v_r = R (w_i - w_j), the part across n
    ///
    /// which is the same for every observer, also one that turns. The source has v_r = R (w_i -
    /// w_j) x n and the torque R n x F: the same, a quarter turn about n away. Here all changes
    /// sign with the exchange of i and j, as engines expect of what they remember for a pair.
    ///
    /// Source: S. Luding, Granular Matter 10 (2008) 235; Y. Wang, F. Alonso-Marroquin, W. W. Guo,
    /// Particuology 23 (2015) 49.
    [[gnu::always_inline]] Vector3 rolling_velocity(const Vector3& spin_i,
                                                    const Vector3& spin_j) const {
      return bodies_.rolling_radius_ * plane_.part_in(spin_i - spin_j);
    }

    /// Adds an impulse on j's surface to an action that has no torques yet.
    [[gnu::always_inline]] void add_sliding_impulse(const Vector3& impulse, PairAction& to) const {
      const Vector3 turn = cross(plane_.normal, impulse);
      to.impulse += impulse;
      to.torque_i = -lever_i_ * turn;
      to.torque_j = (lever_i_ - 1.0) * turn;
    }
    /// Adds the impulse of the rolling spring, which is no force, but the torques R F and -R F.
    [[gnu::always_inline]] void add_rolling_impulse(const Vector3& impulse, PairAction& to) const {
      to.torque_i += bodies_.rolling_radius_ * impulse;
      to.torque_j -= bodies_.rolling_radius_ * impulse;
    }

   private:
    Touch(const ContactBodies& bodies, const contact::Plane& plane, double lever_i)
        : bodies_(bodies), plane_(plane), lever_i_(lever_i) {}

    const ContactBodies& bodies_;
    contact::Plane plane_;
    double lever_i_;  // of i, as a part of the distance
  };

 private:
  Body i_;
  Body j_;
  double inverse_mass_;
  double reduced_mass_;
  double lever_i_;  // of two spheres: i's part of the distance
  double rolling_radius_;
  double inverse_inertia_i_;
  double inverse_inertia_j_;
};

}  // namespace cohesion::contact_solver
