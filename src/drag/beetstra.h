// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "drag/stokes_scaled.h"
#include "drag/validity.h"

namespace cohesion::drag {

/// Drag of Beetstra, van der Hoef and Kuipers, from lattice-Boltzmann simulations of fixed random
/// arrays of equal spheres.
///
///   F_drag = 10 phi/eps^2 + eps^2 (1 + 1.5 sqrt(phi))
///            + 0.413 Re/(24 eps^2) (1/eps + 3 eps phi + 8.4 Re^-0.343)
///              / (1 + 10^(3 phi) Re^-(1 + 4 phi)/2),   phi = 1 - eps
///
/// Evaluated with numerator and denominator times powers of Re, so that Re = 0 divides by nothing:
///   Re (... + 8.4 Re^-0.343)/(1 + 10^(3 phi) Re^-q)
///     = (Re (...) + 8.4 Re^0.657) Re^q/(Re^q + 10^(3 phi)),   q = (1 + 4 phi)/2.
///
/// Limits without inertia: Stokes' drag of a single sphere; Carman and Kozeny's
/// 180 phi^2 mu U/(eps^3 d^2) in a dense bed, plus 1 % at phi = 0.6. With inertia the
/// single sphere is missed: the force is 16 % above Schiller and Naumann's at Re = 100, 68 % at
/// 1000. Continuous.
///
/// Validity: simulated for phi from 0.1 to 0.6, Re up to 1000.
///
/// Source: R. Beetstra, M. A. van der Hoef, J. A. M. Kuipers, AIChE J. 53 (2007) 489; M. A. van der
/// Hoef et al., Adv. Chem. Eng. 31 (2006) 65, eq. 19.
struct Beetstra {
  static constexpr const char* name = "beetstra";
  static constexpr Validity validity{0.4, 0.9, 1000.0};
  static constexpr const char* no_exponent = fitted_dependence;

  /// beta/(1 - eps) as in SyamlalOBrien::per_solid_volume.
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double viscosity) {
    const double phi = 1.0 - void_fraction, square = void_fraction * void_fraction;
    const double reynolds = superficial_reynolds(void_fraction, slip, diameter, density, viscosity);
    const double power = std::pow(reynolds, 0.5 + 2.0 * phi);
    const double inertia = 0.413 / (24.0 * square) *
                           (reynolds * (1.0 / void_fraction + 3.0 * void_fraction * phi) +
                            8.4 * std::pow(reynolds, 0.657)) *
                           power / (power + std::pow(10.0, 3.0 * phi));
    const double still = drag_without_inertia(void_fraction);
    return from_drag(still + inertia, void_fraction, diameter, viscosity);
  }
};

}  // namespace cohesion::drag
