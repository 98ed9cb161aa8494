// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::drag {

/// Where a closure was fitted. There is no lower end of the Reynolds number: closures
/// have their Stokes limit there, but for those of one coefficient.
struct Validity {
  double lowest_void_fraction, highest_void_fraction;  ///< [1]
  double highest_reynolds;                             ///< of stokes_scaled.h, [1]

  constexpr bool contains(double void_fraction, double reynolds) const {
    return void_fraction >= lowest_void_fraction && void_fraction <= highest_void_fraction &&
           reynolds <= highest_reynolds;
  }
};

}  // namespace cohesion::drag
