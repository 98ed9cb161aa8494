// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion::shear {

/// Upper bound of the distance that each of two particles flies towards the other in `time` [time],
/// [length]: the gap between them shrinks by no more than twice this. Neither is faster than `own`
/// [length/time] relative to the mean flow, whose rate is `rate` [1/time], and they are no farther
/// than `reach` [length] apart: the flow moves one against the other at rate times reach or less,
/// of which each counts for half.
inline double longest_flight(double own, double rate, double reach, double time) {
  return time * (own + 0.5 * std::abs(rate) * reach);
}

}  // namespace cohesion::shear
