// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drag/drag_closure.h"
#include "sphere.h"

/// The sphere and the gas of the tests of the drag closures, and what a closure gives for them.
namespace cohesion::drag {

inline constexpr double d = 1e-3, rho = 1.205, mu = 1.75e-5;  // [m], [kg/m3], [Pa s]

/// Slip in the voids [m/s] that has the superficial Reynolds number [1].
inline double slip_at(double void_fraction, double reynolds) {
  return reynolds * mu / (void_fraction * d * rho);
}

/// Drag per Stokes' drag 3 pi mu d U of the superficial slip U [1], from the force on one sphere.
inline double scaled_drag(PerSolidVolume closure, double void_fraction, double reynolds) {
  const double slip = slip_at(void_fraction, reynolds);
  const double coefficient = closure(void_fraction, slip, d, rho, mu) * sphere_volume(d / 2.0);
  return coefficient / (3.0 * pi * mu * d * void_fraction);
}

}  // namespace cohesion::drag
