// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "constants.h"

namespace cohesion::kinetic_theory {

/// Viscosity and conductivity of a gas of grains, of Gidaspow:
///
///   mu_s    = rho d sqrt(pi theta) [ (10/96)/((1 + e) g_0) + phi/6 + (1 + e) phi^2 g_0/15
///                                    + (4/5) (1 + e) phi^2 g_0/pi ]
///   kappa_s = rho d sqrt(pi theta) [ (25/64)/((1 + e) g_0) + (15/16) phi + (9/16) (1 + e) phi^2
///   g_0
///                                    + 2 (1 + e) phi^2 g_0/pi ]
///
/// Symbols: rho density of the material [mass/length^3]; d diameter [length]; phi solid fraction,
/// g_0 radial function at contact, e restitution [1]; theta = <v'.v'>/3 [length^2/time^2], the flux
/// of whose 3/2 kappa_s carries down its slope. With e = 1 mu_s is that of enskog.h.
///
/// Source: D. Gidaspow, Multiphase Flow and Fluidization, Academic Press 1994, ch. 9; M. A. van der
/// Hoef et al., Adv. Chem. Eng. 31 (2006) 65, eqs. 79, 80.
struct Gidaspow {
  double density;      ///< rho, [mass/length^3]
  double diameter;     ///< d, [length]
  double restitution;  ///< e, [1]

  /// mu_s, [mass/(length time)]
  double viscosity(double phi, double radial, double theta) const {
    const double rebound = 1.0 + restitution, contacts = rebound * phi * phi * radial;
    return unit(theta) *
           (10.0 / 96.0 / (rebound * radial) + phi / 6.0 + contacts / 15.0 + 0.8 * contacts / pi);
  }

  /// kappa_s, [mass/(length time)]
  double conductivity(double phi, double radial, double theta) const {
    const double rebound = 1.0 + restitution, contacts = rebound * phi * phi * radial;
    return unit(theta) * (25.0 / 64.0 / (rebound * radial) + 15.0 / 16.0 * phi +
                          9.0 / 16.0 * contacts + 2.0 * contacts / pi);
  }

 private:
  double unit(double theta) const { return density * diameter * std::sqrt(pi * theta); }
};

}  // namespace cohesion::kinetic_theory
