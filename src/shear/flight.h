// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion::shear {

/// How far each of two particles, `reach` apart at most [length], flies towards the other in
/// `time`, at most, [length]: the two together no more than twice this. None is faster than `own`
/// beyond the mean flow [length/time], which has this `rate` [1/time]. The flow moves one against
/// the other at rate times reach at most; each counts for half of that.
inline double longest_flight(double own, double rate, double reach, double time) {
  return time * (own + 0.5 * std::abs(rate) * reach);
}

}  // namespace cohesion::shear
