// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "drag/stokes_scaled.h"
#include "drag/validity.h"

namespace cohesion::drag {

/// Drag of Tang, Peters, Kuipers, Kriebitzsch and van der Hoef, from simulations of flow through
/// fixed arrays of equal spheres by an immersed boundary method.
///
///   F_drag = 10 phi/eps^2 + eps^2 (1 + 1.5 sqrt(phi))
///            + Re [0.11 phi (1 + phi) - 0.00456/eps^4 + (0.169 eps + 0.0644/eps^4) Re^-0.343],
///   phi = 1 - eps, up to Re = 1000; from there F_drag(1000) Re/1000, the same drag coefficient.
///
/// Evaluated with Re^0.657 for Re Re^-0.343, so that Re = 0 divides by nothing. The part above 1000
/// is none of the source: the formula itself, whose coefficient of Re is negative below eps = 0.48
/// and above 0.94, gives a force that falls with the slip from Re = 7300 at eps = 0.36, and drives
/// the particle against the slip from 12,800.
///
/// Limits without inertia are Beetstra's, the first two terms being the same: Stokes' drag of a
/// single sphere; Carman and Kozeny's 180 phi^2 mu U/(eps^3 d^2) in a dense bed, plus 1 % at
/// phi = 0.6. With inertia the single sphere is 18 % above Schiller and Naumann's at Re = 100, and
/// theirs within 1 % at 1000. Continuous.
///
/// Other codes: waLBerla (DragForceCorrelations.h, which calls it eq. 21 of the paper) and pfmFOAM
/// (Tang.C) have the formula as it is here, as F_drag, at any Re.
///
/// Validity: simulated for phi from 0.1 to 0.6, Re from 50 to 1000; below, between these and the
/// limit without inertia. The paper itself was not at hand; the formula is that of these codes.
///
/// Source: Y. Tang, E. A. J. F. Peters, J. A. M. Kuipers, S. H. L. Kriebitzsch, M. A. van der Hoef,
/// AIChE J. 61 (2015) 688.
struct Tang {
  static constexpr const char* name = "tang";
  static constexpr Validity validity{0.4, 0.9, 1000.0};
  static constexpr const char* no_exponent = fitted_dependence;

  /// beta/(1 - eps) as in SyamlalOBrien::per_solid_volume.
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double viscosity) {
    const double phi = 1.0 - void_fraction, square = void_fraction * void_fraction;
    const double fourth = square * square;
    const double reynolds = superficial_reynolds(void_fraction, slip, diameter, density, viscosity);
    const double fitted = std::min(reynolds, validity.highest_reynolds);
    const double still = drag_without_inertia(void_fraction);
    const double inertia = fitted * (0.11 * phi * (1.0 + phi) - 0.00456 / fourth) +
                           (0.169 * void_fraction + 0.0644 / fourth) * std::pow(fitted, 0.657);
    const double beyond = std::max(1.0, reynolds / validity.highest_reynolds);
    return from_drag((still + inertia) * beyond, void_fraction, diameter, viscosity);
  }
};

}  // namespace cohesion::drag
