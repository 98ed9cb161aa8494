// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "drag/stokes_scaled.h"
#include "drag/validity.h"

namespace cohesion::drag {

/// Drag of Hill, Koch and Ladd, from lattice-Boltzmann simulations of fixed random arrays.
///
///   F_total = F_0(phi) + F_3(phi) Re/2,   phi = 1 - eps
///   F_0 = (1 + 3 sqrt(phi/2) + 135/64 phi ln phi + 17.14 phi)
///         / (1 + 0.681 phi - 8.48 phi^2 + 8.16 phi^3)          phi <  0.4
///       = 10 phi/(1 - phi)^3                                   phi >= 0.4
///   F_3 = 0.0673 + 0.212 phi + 0.0232/(1 - phi)^5
///
/// Re is that of the diameter; the half makes it that of the radius, which the source uses.
///
/// Limits without inertia: Stokes' drag of a single sphere; the expansion for dilute arrays of
/// Kim and Russel, 1 + 3 sqrt(phi/2) + 135/64 phi ln phi + 16.456 phi; Carman and Kozeny's
/// 180 phi^2 mu U/(eps^3 d^2) in a packed bed. F_0 falls by 3.8 % where its branches meet. With
/// inertia the single sphere is missed: at Re = 100 the force is 21 % above Schiller and Naumann's,
/// at Re = 200 50 %.
///
/// Printing errors that are about. Van der Hoef et al., Adv. Chem. Eng. 31 (2006) 65, eq. 47, have
/// 135/64 phi without its logarithm; the original has it. Other codes have 16.14 for 17.14, which
/// misses the dilute expansion: 17.14 - 0.681 = 16.459.
///
/// Validity: random arrays up to phi = 0.64, Re of the radius to 100.
///
/// Source: R. J. Hill, D. L. Koch, A. J. C. Ladd, J. Fluid Mech. 448 (2001) 213 and 243; D. L.
/// Koch, R. J. Hill, Annu. Rev. Fluid Mech. 33 (2001) 619.
struct HillKochLadd {
  static constexpr const char* name = "hillKochLadd";
  static constexpr Validity validity{0.36, 1.0, 200.0};
  static constexpr const char* no_exponent = fitted_dependence;

  /// Scaled total force without inertia, F_0 [1], at the solid fraction phi [1], zero included.
  static double without_inertia(double phi) {
    const double eps = 1.0 - phi;
    if (phi >= 0.4) return 10.0 * phi / (eps * eps * eps);
    const double logarithm = phi > 0.0 ? phi * std::log(phi) : 0.0;
    return (1.0 + 3.0 * std::sqrt(0.5 * phi) + 135.0 / 64.0 * logarithm + 17.14 * phi) /
           (1.0 + phi * (0.681 + phi * (-8.48 + phi * 8.16)));
  }

  /// beta/(1 - eps) as in SyamlalOBrien::per_solid_volume.
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double viscosity) {
    const double phi = 1.0 - void_fraction;
    const double reynolds = superficial_reynolds(void_fraction, slip, diameter, density, viscosity);
    const double inertia = 0.0673 + 0.212 * phi + 0.0232 * std::pow(void_fraction, -5.0);
    return from_total(without_inertia(phi) + 0.5 * inertia * reynolds, void_fraction, diameter,
                      viscosity);
  }
};

}  // namespace cohesion::drag
