// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "contact/contact_parameters.h"
#include "event_stepping/contact_memory.h"
#include "event_stepping/pair_motion.h"
#include "event_stepping/pair_step.h"
#include "event_stepping/plane_pair.h"
#include "event_stepping/sphere_pair.h"
#include "event_stepping/spring_memory.h"
#include "sphere.h"

namespace cohesion::event_stepping {

/// What others do to a sphere, `others`, as its contact with a wall sees it. `separation`: to the
/// foot of the normal. What moves the centre along the wall leaves the distance and the normal as
/// they are.
inline PairMotion beside_wall(PairMotion others, const Vector3& separation) {
  const double part = dot(others.relative.separation, separation) / dot(separation, separation);
  others.relative.separation = part * separation;
  return others;
}

/// What friction does in a step.
struct FrictionStep {
  contact::TangentialStep spring;
  Vector3 memory;    ///< for the next step: the spring's displacement on the grid, [length]
  Vector3 torque_i;  ///< angular impulse on i, [momentum length]
  Vector3 torque_j;
};

/// What the resistance against rolling does in a step.
struct RollingStep {
  contact::TangentialStep spring;  ///< its impulse acts on the rolling motion only
  Vector3 memory;                  ///< as with friction
  Vector3 torque_i;                ///< angular impulse on i, its reverse on j, [momentum length]
};

/// One pair in contact: normal motion by Pair, tangential and rolling spring over the time in
/// contact. Pair is SpherePair, PlanePair or WellPair, which follow the motion exactly, or
/// SampledPair or SampledWell. Everything that does not change from step to step is worked out
/// once; pairs of equal bodies can share it.
template <class Pair>
class CohesiveContact {
 public:
  using Attraction = typename Pair::Attraction;
  static constexpr bool acts_within_step = Pair::acts_within_step;
  static constexpr bool on_grid = false;

  CohesiveContact(const contact::ContactParameters& parameters, const Attraction& attraction,
                  const Body& i, const Body& j, const StepWindow& window)
      : i_(i),
        j_(j),
        window_(window),
        inverse_mass_(i.inverse_mass + j.inverse_mass),
        reduced_mass_(1.0 / inverse_mass_),
        share_i_(reduced_mass_ * i.inverse_mass),
        share_j_(reduced_mass_ * j.inverse_mass),
        lever_i_(j.radius > 0.0 ? i.radius / (i.radius + j.radius) : 0.0),
        spin_share_i_(inverse_inertia(i)),
        spin_share_j_(inverse_inertia(j)),
        normal_contact_(contact::normal_contact(parameters, reduced_mass_)),
        pair_(normal_contact_, attraction, i.radius + j.radius, window.length()),
        tangential_(contact::tangential_contact(parameters, normal_contact_)),
        rolling_friction_(parameters.rolling_friction) {}

  bool joins(const Body& i, const Body& j) const { return i == i_ && j == j_; }

  const contact::LinearSpringDashpot& normal_contact() const { return normal_contact_; }
  /// Gap up to which the pair attracts in this scheme, [length].
  double range() const { return pair_.range(); }
  /// Whether there is any adhesion; at a well as wide as the contact it has no range.
  bool attracts() const { return pair_.range() > 0.0 || pair_.adhesion_energy(0.0) < 0.0; }
  double reduced_mass() const { return reduced_mass_; }

  /// The part of a relative change that falls to particle i (with a minus sign) and j.
  double share_i() const { return share_i_; }
  double share_j() const { return share_j_; }
  /// What an angular impulse changes of the spins, [1/(mass length^2)].
  double spin_share_i() const { return spin_share_i_; }
  double spin_share_j() const { return spin_share_j_; }

  bool within_reach(const RelativeState& grid) const { return pair_.within_reach(grid, window_); }

  /// Normal motion over the step. `inside`: whether the last step ended within the adhesion's
  /// range.
  PairStep advance(const RelativeState& grid, bool inside) const {
    return pair_.advance(grid, window_, inside);
  }

  /// Friction in the step that `normal` describes. `memory`: what the last step left
  /// (FrictionStep.memory).
  ///
  /// The lever arms of two spheres share the distance of their centres in proportion to the radii,
  /// so that angular momentum is kept exactly; beside a wall, the limit of a large sphere, the arm
  /// is the radius.
  FrictionStep friction(const PairMotion& grid, const PairStep& normal,
                        const Vector3& memory) const {
    const Vector3& r = grid.relative.separation;
    const double square = dot(r, r);
    const contact::Plane plane{r, 1.0 / square};
    const double lever_i = this->lever_i(square);
    const double lever_j = 1.0 - lever_i;
    const SpringVelocity u(surface_velocity(plane, lever_i,
                                            grid.relative.velocity + 0.5 * normal.change.velocity,
                                            grid.spin_i, grid.spin_j));
    const double answer = inverse_mass_ + square * (lever_i * lever_i * spin_share_i_ +
                                                    lever_j * lever_j * spin_share_j_);
    SpringStep step = follow_spring(tangential_, normal, window_, plane, memory, u, answer);
    const Vector3 turn = cross(r, step.spring.impulse);
    return {step.spring, step.memory, -lever_i * turn, -lever_j * turn};
  }

  /// Resistance against rolling in the step that `normal` describes, arguments as for friction(): a
  /// spring, dashpot and slider like the tangential ones, stretched at the rolling velocity
  ///
  ///   v_r = R (w_i - w_j), the part across n    R = R_i R_j/(R_i + R_j), beside a wall R_i
  ///
  /// which is the same for every observer, also one that turns. What they carry, F, is no force:
  /// the particles get the torques R F and -R F, and 1/m_r = R^2 (1/I_i + 1/I_j) answers.
  ///
  /// The source has v_r = R (w_i - w_j) x n and the torque R n x F: the same, a quarter turn about
  /// n away. Here all changes sign with the exchange of i and j, as engines expect of what they
  /// remember for a pair.
  ///
  /// Source: S. Luding, Granular Matter 10 (2008) 235; Y. Wang, F. Alonso-Marroquin, W. W. Guo,
  /// Particuology 23 (2015) 49.
  RollingStep rolling(const PairMotion& grid, const PairStep& normal, const Vector3& memory,
                      const PairSpins& by_friction = {}) const {
    const Vector3& r = grid.relative.separation;
    const contact::Plane plane{r, 1.0 / dot(r, r)};
    const double radius = rolling_radius();
    SpringVelocity u(rolling_velocity(plane, grid.spin_i, grid.spin_j));
    const Vector3 by_partner = rolling_velocity(plane, by_friction.i, by_friction.j);
    u.add({}, &by_partner);
    SpringStep step = follow_spring(tangential_.with_friction(rolling_friction_), normal, window_,
                                    plane, memory, u, inverse_rolling_mass());
    return {step.spring, step.memory, radius * step.spring.impulse};
  }

  /// What the torques R F and -R F change of the spins; `torque_i` the first of them as angular
  /// impulse.
  PairSpins rolled(const Vector3& torque_i) const {
    return {spin_share_i_ * torque_i, -spin_share_j_ * torque_i};
  }

  /// R, [length].
  double rolling_radius() const { return j_.radius > 0.0 ? lever_i_ * j_.radius : i_.radius; }
  /// 1/m_r, [1/mass].
  double inverse_rolling_mass() const {
    return rolling_radius() * rolling_radius() * (spin_share_i_ + spin_share_j_);
  }

  /// Of the tangential spring, and of the rolling one.
  double friction_energy(const Vector3& displacement) const {
    return tangential_.stored_energy(displacement);
  }

  double spring_energy(const PairStep& step) const {
    return pair_.spring_energy(step.overlap_at_end);
  }
  double adhesion_energy(const PairStep& step) const {
    return step.inside ? pair_.adhesion_energy(step.overlap_at_end) : 0.0;
  }

  /// What is stored at the grid point. `memory` holds the in-range flag as its phase.
  StoredEnergies stored(const PairMotion& grid, const ContactMemory& memory) const {
    const Vector3& r = grid.relative.separation;
    const double square = dot(r, r);
    const contact::Plane plane{r, 1.0 / square};
    PairStep now;
    now.overlap_at_end = i_.radius + j_.radius - std::sqrt(square);
    now.inside = memory.in_range();
    const auto spring = [&](const Vector3& stretch, const Vector3& rate) {
      if (dot(stretch, stretch) == 0.0) return 0.0;
      return friction_energy(plane.turned_into(stretch) + 2.0 * window_.before * rate);
    };
    return {spring_energy(now),
            spring(memory.sliding.stretch,
                   surface_velocity(plane, lever_i(square), grid.relative.velocity, grid.spin_i,
                                    grid.spin_j)),
            spring(memory.rolling.stretch, rolling_velocity(plane, grid.spin_i, grid.spin_j)),
            adhesion_energy(now)};
  }

 private:
  /// How fast the surfaces part in the plane of contact, whose normal is the separation.
  static Vector3 surface_velocity(const contact::Plane& plane, double lever_i,
                                  const Vector3& velocity, const Vector3& spin_i,
                                  const Vector3& spin_j) {
    return plane.part_in(velocity -
                         cross(lever_i * spin_i + (1.0 - lever_i) * spin_j, plane.normal));
  }
  Vector3 rolling_velocity(const contact::Plane& plane, const Vector3& spin_i,
                           const Vector3& spin_j) const {
    return rolling_radius() * plane.part_in(spin_i - spin_j);
  }
  /// The lever arm of i as a part of the distance, whose square is given.
  double lever_i(double square) const {
    return j_.radius > 0.0 ? lever_i_ : i_.radius / std::sqrt(square);
  }

  Body i_;
  Body j_;
  StepWindow window_;
  double inverse_mass_;
  double reduced_mass_;
  double share_i_;
  double share_j_;
  double lever_i_;  // of two spheres: i's part of the distance
  double spin_share_i_;
  double spin_share_j_;
  contact::LinearSpringDashpot normal_contact_;
  Pair pair_;
  contact::TangentialSpring tangential_;
  double rolling_friction_;
};

}  // namespace cohesion::event_stepping
