// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector3.h"

namespace cohesion::contact_solver {

/// Position and velocity of particle j relative to particle i (of the foot of the normal relative
/// to the particle's centre, at a wall).
struct RelativeState {
  Vector3 separation;
  Vector3 velocity;
};

}  // namespace cohesion::contact_solver
