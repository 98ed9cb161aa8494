// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "advice/contact_numbers.h"
#include "sphere.h"

namespace cohesion::advice {

/// Two spheres of the thesis' bed (1 mm, 2650 kg/m3, e = 0.9487, A = 5e-19 J, H_cut = 4e-10 m,
/// H_out = 1e-7 m) that meet at 0.1 m/s, at the thesis' time step.
inline PairParameters thesis_pair() {
  const double mass = 2650.0 * sphere_volume(0.5e-3);
  const double a_r_over_6 = 5e-19 * 0.25e-3 / 6.0;
  return {0.5e-3,
          0.5e-3,
          mass,
          mass,
          800.0,
          0.79e-3,
          {a_r_over_6 / (4e-10 * 4e-10), 4e-10, a_r_over_6 * (1.0 / 4e-10 - 1.0 / 1e-7)},
          0.1,
          2.25e-5,
          9.81};
}

}  // namespace cohesion::advice
