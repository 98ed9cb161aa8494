// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Drag with one coefficient C_d whatever the Reynolds number: of bubbles, and for trials.
///
///   F_total = C_d rho/2 pi d^2/4 U^2,   U = eps |u - v|,
///
/// so that beta/(1 - eps) = 3/4 C_d rho eps^3 |u - v|/d. A sphere alone has U = |u - v|. Among
/// others U is the slip against the volume flow of the mixture, and F_total carries the weight less
/// buoyancy of the sphere, (rho_s - rho) V g, at any void fraction (stokes_scaled.h). Spheres
/// without circulation then keep the rise of a single one, v, against that flow: fed with the
/// superficial velocity u_0 into a liquid that has none, they rise with u_0 + v and fill the share
/// u_0/(u_0 + v), which is what Davidson and Harrison state for bubbles in fluidised beds.
///
/// The drag goes with the square of the slip and has no Stokes' limit: without slip the coefficient
/// is 0. The coupling lets it follow the slip in each step of the particles
/// (src/liquid/sphere_in_liquid.h).
namespace cohesion::drag {

/// beta/(1 - eps), [mass/(volume time)], with C_d = coefficient [1]; the rest as in
/// SyamlalOBrien::per_solid_volume.
inline double with_coefficient(double coefficient, double void_fraction, double slip,
                               double diameter, double density) {
  return 0.75 * coefficient * density * void_fraction * void_fraction * void_fraction * slip /
         diameter;
}

/// C_d as the user gives it: per C_d = 1.
struct ConstantCd {
  static constexpr const char* name = "constantCd";
  static constexpr const char* no_exponent = "it has a coefficient instead, dragCoefficient";

  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double /*viscosity*/) {
    return with_coefficient(1.0, void_fraction, slip, diameter, density);
  }
};

/// Bubbles of gas in a fluidised bed, C_d = 4/(3 0.711^2) (1 - rho_b/rho_e) = 2.64 (1 -
/// rho_b/rho_e), by which one alone rises with 0.711 sqrt(g d): R. M. Davies and G. I. Taylor,
/// Proc. R. Soc. A 200 (1950) 375, as J. F. Davidson and D. Harrison, Fluidised Particles (1963),
/// have it for bubbles among fine particles; d is the diameter of the sphere of their volume. M. A.
/// van der Hoef et al., Adv. Chem. Eng. 31 (2006), chapter V, use it for discrete bubbles.
struct DavidsonTaylor {
  static constexpr const char* name = "davidsonTaylor";
  static constexpr const char* no_exponent =
      "its bubbles rise against the volume flow of the mixture with one velocity";
  static constexpr double rise = 0.711;  ///< v/sqrt(g d) [1]
  static constexpr double coefficient = 4.0 / (3.0 * rise * rise);

  /// As of a bubble without mass.
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double /*viscosity*/) {
    return with_coefficient(coefficient, void_fraction, slip, diameter, density);
  }

  /// Drag of a bubble over that of one without mass, [1], above 0 of one that rises.
  static double share(double bubble_density, double density) {
    return 1.0 - bubble_density / density;
  }
};

}  // namespace cohesion::drag
