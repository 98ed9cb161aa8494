// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/linear_spring_dashpot.h"
#include "event_stepping/followed_step.h"

namespace cohesion::event_stepping {

/// No less than what a followed contact, by itself, makes of its relative velocity in a step, from
/// that on the grid: what it owes; spring, dashpot and pull at the speed and the overlap that its
/// energy allows; the edge; and for friction, of a coefficient up to 1, as much again.
///
/// Source: derived here.
class KickBound {
 public:
  /// inverse_mass [1/mass]: of the relative motion; distance [length]: of the centres of bodies
  /// that touch; pull [force] and energy_at_touch [energy], 0 or below: of the adhesion; step
  /// [time].
  KickBound(const contact::LinearSpringDashpot& normal, double inverse_mass, double distance,
            double pull, double energy_at_touch, double step)
      : step_(step),
        distance_(distance),
        pull_(step * pull * inverse_mass),
        swing_(std::sqrt(normal.stiffness() * inverse_mass)),
        damping_rate_(normal.damping() * inverse_mass),
        edge_speed_(std::sqrt(2.0 * std::max(-energy_at_touch, 0.0) * inverse_mass)) {}

  /// [length/time].
  double of(const FollowedStart& start) const {
    const RelativeState& at = start.truth.relative;
    const double overlap = std::max(distance_ - norm(at.separation), 0.0);
    const double speed =
        norm(at.velocity) + std::abs(start.ahead) + swing_ * overlap + edge_speed_ + pull_;
    const double spring = swing_ * swing_ * (overlap + step_ * speed);
    return 2.0 *
           (std::abs(start.ahead) + step_ * (spring + damping_rate_ * speed) + pull_ + edge_speed_);
  }

 private:
  double step_;
  double distance_;
  double pull_;          // what the adhesion pulls in a step, [length/time]
  double swing_;         // w0
  double damping_rate_;  // 2 alpha
  double edge_speed_;    // of a pair that falls from rest into contact
};

}  // namespace cohesion::event_stepping
