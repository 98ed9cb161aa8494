// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "contact/adhesive_contact.h"

/// Which square well and which Hamaker attraction hold head-on pairs up to the same speed, computed
/// exactly: with scheme exact at any time step. With scheme sampled: sampled_escape.h.
/// Source: M. Weber, thesis, ch. 7, where both models are compared at equal escape velocity.
namespace cohesion::advice {

/// Throws InvalidParameter unless 0 < e < 1.
inline void require_sticking(const contact::LinearSpringDashpot& spring) {
  const double e = spring.restitution();
  require(e > 0.0 && e < 1.0, "restitution e", e,
          "must lie between 0 and 1: without loss no pair sticks, and with all lost every pair");
}

/// Depth D of the square well whose pairs stick up to `speed` v_esc in a head-on impact:
///
///   v_esc^2 = (2 D/mu) (1/e^2 - 1)   ->   D = mu v_esc^2/(2 (1/e^2 - 1))
///
/// mu and e are those of `spring`; `speed` [length/time]; returns [energy]. The width of the well
/// does not matter head-on. Throws InvalidParameter unless 0 < e < 1 and v_esc is finite and not
/// below zero.
inline double depth_of_escape_velocity(const contact::LinearSpringDashpot& spring, double speed) {
  require_non_negative("escape velocity", speed);
  require_sticking(spring);
  return 0.5 * spring.reduced_mass() * speed * speed /
         std::expm1(-2.0 * std::log(spring.restitution()));
}

/// The square well of the same head-on escape velocity as `adhesion`, [energy].
inline double equal_depth(const contact::LinearSpringDashpot& spring,
                          const contact::Adhesion& adhesion) {
  return depth_of_escape_velocity(spring,
                                  contact::AdhesiveContact(spring, adhesion).escape_velocity());
}

/// v_esc of a square well of depth D [energy], [length/time].
inline double escape_velocity_of_depth(const contact::LinearSpringDashpot& spring, double depth) {
  return contact::AdhesiveContact(spring, {0.0, 0.0, depth}).escape_velocity();
}

/// The factor on `unit` whose pairs stick up to `speed` [length/time]: the Hamaker constant A when
/// `unit` is the adhesion per unit of it, as force and energy are proportional to A. v_esc grows
/// with it, from zero without bound, so that bisection finds it, to round-off.
/// Throws InvalidParameter unless 0 < e < 1, v_esc is finite and positive and `unit` attracts.
inline double adhesion_of_escape_velocity(const contact::LinearSpringDashpot& spring,
                                          const contact::Adhesion& unit, double speed) {
  require_positive("escape velocity", speed);
  require_sticking(spring);
  require_positive("adhesion force F_ad per unit", unit.force);
  const auto sticks = [&](double factor) {
    const contact::Adhesion a{factor * unit.force, unit.cutoff, factor * unit.tail_energy};
    return contact::AdhesiveContact(spring, a).escape_velocity() > speed;
  };
  // b = F_ad/sqrt(mu K) is of the order of the speed unless the loss is small or the well deep.
  double high = speed * std::sqrt(spring.stiffness() * spring.reduced_mass()) / unit.force;
  while (!sticks(high)) high *= 2.0;
  double low = 0.5 * high;
  while (sticks(low)) low *= 0.5;
  for (double middle = 0.5 * (low + high); middle > low && middle < high;
       middle = 0.5 * (low + high))
    (sticks(middle) ? high : low) = middle;
  return 0.5 * (low + high);
}

}  // namespace cohesion::advice
