// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "drag/drag_law.h"
#include "drag/in_agglomerate.h"

/// The drag on spheres that are bound in an agglomerate, over any closure of equal spheres
/// (docs/openfoam-coupling/agglomerate_drag.md):
///
///   f = min(1, F_total(eps_h, Re_h) R_h/(N a F_total(eps, Re)))
///
/// is the factor on the closure's drag of each of its spheres. F_total(eps, Re) of the closure is
/// the force over 3 pi mu d U (stokes_scaled.h), U = eps |u - v| the superficial slip
/// [length/time]; Re = 2 rho U a/mu, Re_h = 2 rho U R_h/mu [1].
///
///   R_h = R_s phi_s^(c (R_s/(N a))^(1/2)),     c = 0.238,
///   R_s = (a^2 + 5/3 R_g^2)^(1/2),   phi_s = N a^3/R_s^3,
///   phi_h = phi R_h^3/(N a^3),  eps_h = 1 - phi_h
///
/// with N spheres of the radius a [length], R_g of gyration of their centres [length], and
/// phi = 1 - eps the solid fraction where the sphere is [1]. R_h is a fit to resolved flow through
/// 22 agglomerates, chains and dense balls of 2 to 135 spheres, within 4.5 %; among others the
/// whole law was found within 17 % (examples/agglomerate-drag). With F_total, not F_drag, f is that
/// of both forms of the model.
///
/// Limits: 1 for N = 1; R_h/(N a) in dilute gas without inertia; 1 where phi_h >= 1. Beyond the
/// closures' ranges their formulas are used as they are. Validity: spheres of one size.
///
/// Source: the sphere of the same drag that cluster simulations compare with (R. Beetstra, M. A.
/// van der Hoef, J. A. M. Kuipers, Comput. Fluids 35 (2006) 966); the rest is of this package.
namespace cohesion::drag {

/// What is done with the drag of bound particles.
struct AgglomerateLaw {
  std::string_view name;
  bool reduces;  ///< false: the closure's, as if they were single
};

inline constexpr std::array agglomerate_laws{
    AgglomerateLaw{"none", false},
    AgglomerateLaw{"equivalentSphere", true},
};

/// The law above.
struct EquivalentSphere {
  static constexpr double c = 0.238;  ///< [1]
  /// R_g^2 of a ball is 3/5 of the square of its radius.
  static constexpr double ball = 5.0 / 3.0;

  /// R_h; radius a [length]
  static double hydrodynamic_radius(const InAgglomerate& of, double radius) {
    const double gyration = of.gyration / radius;
    const double around = std::sqrt(1.0 + ball * gyration * gyration);
    const double inside = of.number / (around * around * around);
    return radius * around * std::pow(inside, c * std::sqrt(around / of.number));
  }

  /// phi_h, [1]
  static double taken_up(const InAgglomerate& of, double radius, double void_fraction) {
    const double ratio = hydrodynamic_radius(of, radius) / radius;
    return (1.0 - void_fraction) * ratio * ratio * ratio / of.number;
  }

  /// f, [1]; void_fraction eps, slip |u - v| [length/time] and radius a [length] of the sphere,
  /// density [mass/volume] and viscosity [mass/(length time)] of the gas.
  static double factor(const DragLaw& law, const InAgglomerate& of, double void_fraction,
                       double slip, double radius, double density, double viscosity) {
    if (!of.bound() || of.endless()) return 1.0;
    const double solid = taken_up(of, radius, void_fraction);
    if (solid >= 1.0) return 1.0;
    const auto total_per_superficial = [&](double eps, double r) {
      const double of_law =
          law.coefficient(eps, void_fraction * slip / eps, 2.0 * r, density, viscosity);
      return of_law / (eps * eps);
    };
    const double around = total_per_superficial(1.0 - solid, hydrodynamic_radius(of, radius));
    const double own = total_per_superficial(void_fraction, radius);
    return std::min(1.0, around / (of.number * own));
  }
};

}  // namespace cohesion::drag
