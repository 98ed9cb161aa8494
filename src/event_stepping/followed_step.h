// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "contact/tangential_spring.h"
#include "event_stepping/contact_memory.h"
#include "event_stepping/pair_motion.h"
#include "event_stepping/pair_step.h"

namespace cohesion::event_stepping {

/// Where a followed step begins.
struct FollowedStart {
  PairMotion truth;              ///< at the grid point
  Vector3 sliding{}, rolling{};  ///< stretch of both springs, [length]
  double ahead = 0.0;            ///< true radial velocity over the grid's, [length/time]
};

/// What a followed contact does from one grid point to the next, along the normal.
struct FollowedNormal {
  PairStep normal;
  PairMotion change;  ///< D, V and changes of the spins, of all
  /// What a rolling spring changes of the spins.
  PairSpins rolled() const { return {}; }
};
/// The same with friction.
struct FollowedSliding : FollowedNormal {
  contact::TangentialStep sliding;
  Vector3 sliding_rate;  ///< of the ends of the spring, [length/time]
};
/// The same with rolling friction.
struct FollowedRolling : FollowedSliding {
  contact::TangentialStep rolling;
  Vector3 rolling_rate;  ///< of the ends of the spring, [length/time]
  PairSpins turned;
  PairSpins rolled() const { return turned; }
};
/// What a contact that remembers so many numbers needs of these.
template <int SIZE>
using FollowedStep = std::conditional_t<
    (SIZE >= ContactMemory::with_rolling), FollowedRolling,
    std::conditional_t<(SIZE >= ContactMemory::with_friction), FollowedSliding, FollowedNormal>>;

}  // namespace cohesion::event_stepping
