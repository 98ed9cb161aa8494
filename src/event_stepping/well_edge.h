// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "event_stepping/well_pair.h"

namespace cohesion::event_stepping {

/// The edge of a square well alone, around a contact that is followed elsewhere: WellPair without
/// its core. The pair flies straight within the step. What the contact does in it counts as done at
/// the grid point: the impulse at the edge is exact where the well is wider than the way of a step,
/// so that no pair is in contact at the grid point and at the edge within the same step.
class WellEdge : public WellPair {
 public:
  static constexpr bool pushes_at_edge = true;

  WellEdge(const contact::LinearSpringDashpot& spring, const contact::Adhesion& well,
           double contact_distance, double step)
      : WellPair(spring, well, contact_distance, 0.0, step) {}

  /// The spring's energy is that of the style that follows the contact.
  double spring_energy(double /*overlap*/) const { return 0.0; }
};

}  // namespace cohesion::event_stepping
