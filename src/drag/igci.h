// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

/// The drag of two fluids in cells that are too coarse for the clusters in them, over that of the
/// closure of Wen and Yu at the mean values there. Igci, Pannala, Benyahia and Sundaresan, of
/// simulations of a fine powder (75 um, 1500 kg/m3, in air) as two fluids in fine cells:
///
///   beta/beta_closure = 1 - h(phi) G(phi) s/(s + 0.4),   s = (g Delta/v_t^2)^1.6
///
/// Symbols: phi solid fraction [1]; Delta size of the cell [length]; v_t terminal speed of a grain
/// of Stokes [length/time], g gravity [length/time^2]. h and G are given piece by piece.
///
/// Limits: 1 for fine cells, for few particles and from phi = 0.59 on, where h has its root. h is
/// continuous to 0.002, as far as its printed digits go, G to 0.007.
///
/// Validity: three dimensions, phi <= 0.59. Of Wen and Yu's drag; others differ from it without
/// clusters, too. The paper was not at hand: form and coefficients are those of MFiX
/// (SUBGRID_TYPE = IGCI).
///
/// Source: Y. Igci, S. Pannala, S. Benyahia, S. Sundaresan, Ind. Eng. Chem. Res. 51 (2012) 2094.
namespace cohesion::drag {

struct Igci {
  static double h(double phi) {
    if (phi < 0.0012) return 2.7 * std::pow(phi, 0.234);
    if (phi < 0.014) return 0.963 - 0.019 * std::pow(phi, -0.455);
    if (phi < 0.25) return 0.868 * std::exp(-0.38 * phi) - 0.176 * std::exp(-119.2 * phi);
    if (phi < 0.455) return -4.59e-5 * std::exp(19.75 * phi) + 0.852 * std::exp(-0.268 * phi);
    if (phi <= 0.59)
      return (phi - 0.59) * (162.0 + phi * (-1054.0 + phi * (2203.0 - 1501.0 * phi)));
    return 0.0;
  }

  static double G(double phi) {
    return phi < 0.18 ? std::pow(phi, 0.24) * (1.48 + std::exp(-18.0 * phi)) : 1.0;
  }

  /// Drag over the closure's, [1]; phi >= 0, filter_over_length Delta g/v_t^2 > 0
  static double factor(double phi, double filter_over_length) {
    const double s = std::pow(filter_over_length, 1.6);
    return 1.0 - h(phi) * G(phi) * s / (s + 0.4);
  }
};

/// Stokes' terminal speed of a grain in a gas of viscosity mu, (rho_s - rho) g d^2/(18 mu),
/// [length/time]
inline double stokes_terminal_speed(double diameter, double density, double gas_density,
                                    double viscosity, double gravity) {
  return (density - gas_density) * gravity * diameter * diameter / (18.0 * viscosity);
}

/// Delta g/v_t^2 [1] of a filter Delta [length]
inline double filter_over_fall(double filter, double terminal_speed, double gravity) {
  return filter * gravity / (terminal_speed * terminal_speed);
}

}  // namespace cohesion::drag
