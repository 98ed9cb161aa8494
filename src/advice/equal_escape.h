// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "contact/adhesive_contact.h"

namespace cohesion::advice {

/// Depth D of the square well whose pairs stick up to `speed` v_esc in a head-on impact:
///
///   v_esc^2 = (2 D/mu) (1/e^2 - 1)   ->   D = mu v_esc^2/(2 (1/e^2 - 1))
///
/// mu and e are those of `spring`; `speed` [length/time]; returns [energy]. The width of the well
/// does not matter head-on. Throws InvalidParameter unless 0 < e < 1 and v_esc is finite and not
/// below zero.
/// Source: M. Weber, thesis, ch. 7, where both models are compared at equal escape velocity.
inline double depth_of_escape_velocity(const contact::LinearSpringDashpot& spring, double speed) {
  require_non_negative("escape velocity", speed);
  const double e = spring.restitution();
  require(e > 0.0 && e < 1.0, "restitution e", e,
          "must lie between 0 and 1: without loss no pair sticks, and with all lost every pair");
  return 0.5 * spring.reduced_mass() * speed * speed / std::expm1(-2.0 * std::log(e));
}

/// The square well of the same head-on escape velocity as `adhesion`, [energy].
inline double equal_depth(const contact::LinearSpringDashpot& spring,
                          const contact::Adhesion& adhesion) {
  return depth_of_escape_velocity(spring,
                                  contact::AdhesiveContact(spring, adhesion).escape_velocity());
}

}  // namespace cohesion::advice
