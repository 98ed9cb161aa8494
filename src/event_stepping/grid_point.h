// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "event_stepping/normal_motion.h"

namespace cohesion::event_stepping {

/// A pair along its normal at a grid point, as engines know it when they ask for forces: positions
/// there, velocities of the half step before. Beside a wall `distance` is from the wall.
struct GridPoint {
  double distance;  ///< of the centres, [length]
  double radial;    ///< rate of it along the normal of this grid point, [length/time]
  double sideways;  ///< speed across the normal, 0 beside a wall, [length/time]

  /// Whether a pair of which nothing is remembered stands nearer than `edge` [length], and has not
  /// fallen in: then it was outside a `step` [time] before.
  bool stands_within(double edge, double step) const {
    return distance < edge && std::hypot(distance - step * radial, step * sideways) < edge;
  }
};

/// What OnePassContact remembers of a pair from one grid point to the next; of two passes and of
/// sampled contacts it is ContactMemory.
struct GridMemory {
  /// `beyond`: outside the range, known by the grid. `lasting`: in contact all through the last
  /// step. `entered`, `left`: inside or outside after a step with an event. `within`: inside
  /// without contact or force, known by the grid. Of elastic pairs, too, `begun`: in contact all
  /// through the last step, which was followed; `parted`: outside, with work to settle. Engines
  /// keep the numbers.
  enum Phase { beyond, lasting, entered, left, within, begun, parted };
  Phase phase = beyond;
  /// After an event: true radial velocity over the grid's; in_contact(): the grid's at the last
  /// grid point, [length/time].
  double ahead = 0.0;
  double force = 0.0;  ///< of the last step, on j away from i, [force]
  /// Of elastic pairs: the work of these forces since the pair came into the range, less the energy
  /// that it had when a run began; while `lasting`, with what its spring stores, [energy].
  double work = 0.0;
  /// Whether nothing is remembered of it: no step of it was computed before this one.
  bool is_new = false;

  bool inside() const { return phase != beyond && phase != left && phase != parted; }
  /// Whether it was in contact all through the last step.
  bool in_contact() const { return phase == lasting || phase == begun; }
  /// Whether what the grid shows at a grid point is all that there is to know.
  bool known_by_grid() const { return phase == beyond || phase == within; }
};

/// What a contact that lasts does, [force].
struct LastingForce {
  double force;      ///< on j away from i, all of the contact
  double repulsion;  ///< the part of spring and dashpot
};

/// What a contact does from one grid point to the next.
struct GridStep {
  double force = 0.0;      ///< on j away from i, mean over the step, all of the contact, [force]
  double repulsion = 0.0;  ///< the part of spring and dashpot: on average, [force]
  NormalRecord normal{};
};

}  // namespace cohesion::event_stepping
