// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector3.h"

namespace cohesion::square_well {

/// Whether a pair inside the well will be captured when it next comes to the edge, if nothing else
/// meets it before. It flies straight, so its normal speed u there is given by what is conserved:
/// u^2 = w^2 - (r x w)^2/edge^2, to be compared as in escapes(). A pair that has come in by an
/// approach never is; a collision or a third particle makes it so.
///
/// r from i to j [length], w = v_i - v_j [speed], edge [length], depth and b as for the impulses.
///
/// Source: derived here, from energy and angular momentum at the edge (square_well/impulses.h).
inline bool will_be_captured(const Vector3& r, const Vector3& w, double edge, double depth,
                             double b) {
  const Vector3 turning = (1.0 / edge) * cross(r, w);
  return dot(w, w) - dot(turning, turning) <= 2.0 * depth * b;
}

}  // namespace cohesion::square_well
