// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "drag/single_sphere.h"
#include "drag/stokes_scaled.h"
#include "drag/validity.h"

namespace cohesion::drag {

/// Drag of Tenneti, Garg and Subramaniam, from simulations of flow through fixed random arrays of
/// equal spheres by an immersed boundary method.
///
///   F_total = C_D Re/24/eps^3 + 5.81 phi/eps^3 + 0.48 phi^(1/3)/eps^4
///             + phi^3 Re (0.95 + 0.61 phi^3/eps^2),   phi = 1 - eps
///
/// with C_D of Schiller and Naumann, who jump by 0.4 % at Re = 1000.
///
/// Limits: eps -> 1 is Schiller and Naumann's single sphere, reached with phi^(1/3). Without
/// inertia 7 % below Carman and Kozeny's 180 phi^2 mu U/(eps^3 d^2) at phi = 0.5, 8 % at 0.6: this
/// says that the formula is F_total; as F_drag it would be 87 % above at 0.5. With inertia, Re from
/// 100 to 300 and phi from 0.1 to 0.5, 19 to 36 % below Beetstra. Continuous below Re = 1000.
///
/// Other codes. waLBerla (DragForceCorrelations.h) and pfmFOAM (Tenneti.C) have the formula above
/// times eps, as F_drag; waLBerla with 1 + 0.15 Re^0.687 for C_D Re/24 at any Re. OpenFOAM
/// (Tenneti.C) has C_D Re/24/eps as the single sphere's part of F_drag, where the formula leaves
/// C_D Re/24/eps^2; so its drag is lower, by 5 % at phi = 0.1, Re -> 0, by 22 % at phi = 0.5,
/// Re = 100.
///
/// Validity: simulated for phi from 0.1 to 0.5, Re from 0.01 to 300. The paper itself was not at
/// hand; the formula is that of these codes.
///
/// Source: S. Tenneti, R. Garg, S. Subramaniam, Int. J. Multiphase Flow 37 (2011) 1072.
struct Tenneti {
  static constexpr const char* name = "tenneti";
  static constexpr Validity validity{0.5, 0.9, 300.0};
  static constexpr const char* no_exponent = fitted_dependence;

  /// beta/(1 - eps) as in SyamlalOBrien::per_solid_volume.
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double viscosity) {
    const double phi = 1.0 - void_fraction, square = void_fraction * void_fraction;
    const double cube = square * void_fraction, solid_cube = phi * phi * phi;
    const double reynolds = superficial_reynolds(void_fraction, slip, diameter, density, viscosity);
    const double still = 5.81 * phi / cube + 0.48 * std::cbrt(phi) / (square * square);
    const double inertia = solid_cube * reynolds * (0.95 + 0.61 * solid_cube / square);
    return from_total(schiller_naumann(reynolds) / cube + still + inertia, void_fraction, diameter,
                      viscosity);
  }
};

}  // namespace cohesion::drag
