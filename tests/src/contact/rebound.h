// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/adhesive_contact.h"

/// What a contact leaves of a speed, by the motion from which AdhesiveContact has the escape
/// velocity, but forwards in time.
namespace cohesion::contact {

/// Speed w [length/time] at which a pair that touched at `entry_speed` comes apart; 0 when it never
/// does.
inline double exit_speed(const AdhesiveContact& c, double entry_speed) {
  require_non_negative("entry speed", entry_speed);
  if (entry_speed == 0.0) return 0.0;
  const AdhesiveContact::Motion m(entry_speed, c.b_, c.zeta_);
  const auto time = m.return_time();
  return time ? m.return_speed(*time) : 0.0;
}

/// Speed far apart after the contact over `far_speed` [length/time] before it, [1]; 0 when
/// captured. Throws InvalidParameter unless far_speed > 0.
inline double effective_restitution(const AdhesiveContact& c, double far_speed) {
  require_positive("approach speed", far_speed);
  const double deficit = c.unpaid_ / far_speed / far_speed;
  if (c.zeta_ == 0.0) return std::sqrt(std::max(1.0 - deficit, 0.0));
  const double u = c.entry_speed(far_speed);
  const AdhesiveContact::Motion m(u, c.b_, c.zeta_);
  const auto time = m.return_time();
  if (!time) return 0.0;
  // (w^2 - 2 W/mu)/v^2, from w or from the loss: by which carries the smaller rounding.
  const double w = m.return_speed(*time);
  const double left = w * (u + c.b_) < far_speed * far_speed
                          ? (w - c.well_speed_) / far_speed * ((w + c.well_speed_) / far_speed)
                          : 1.0 - m.lost(*time) / far_speed / far_speed - deficit;
  return left > 0.0 ? std::sqrt(left) : 0.0;
}

}  // namespace cohesion::contact
