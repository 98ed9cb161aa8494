// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "drag/size_mixture.h"

/// How gas and particles share the pressure gradient.
///
/// Form A: the gas takes the share eps of grad p, a particle -V_p grad p and its drag F_drag
/// (stokes_scaled.h); buoyancy is part of -V_p grad p.
///
///   d(eps rho u)/dt + ... = eps (rho g - grad p) - sum F_drag/V
///
/// Form B: the gas takes all of grad p, a particle the buoyancy -V_p rho g, and the drag is
/// F_drag/eps, the force of gas that flows steadily and uniformly between the particles.
///
///   d(eps rho u)/dt + ... = rho g - grad p - sum F_drag/(eps V)
///
/// In both the momentum of gas and particles together changes by their weight and the pressure at
/// the boundary alone. In a packed bed both have the pressure gradient rho g - n F_drag/eps.
///
/// Source: Y. Q. Feng, A. B. Yu, Ind. Eng. Chem. Res. 43 (2004) 8378; Z. Y. Zhou, S. B. Kuang, K.
/// W. Chu, A. B. Yu, J. Fluid Mech. 661 (2010) 482, sets II (A) and III (B).
namespace cohesion::drag {

struct ModelForm {
  std::string_view name;
  /// Drag of equal spheres over that of form A [1], at the void fraction eps in (0, 1].
  double (*drag_over_a)(double void_fraction);
  /// That of a sphere among others over that of equal ones with their Sauter mean, per volume [1].
  double (*mixed_drag)(const MixtureLaw&, double void_fraction, double d, const SizesAround&);
  /// Whether gas and particles share the pressure gradient. If not, all of grad p - rho g acts on
  /// the gas, and particles feel rho g in the place of grad p.
  bool shares_pressure;
};

inline constexpr std::array model_forms{
    ModelForm{"A", [](double) { return 1.0; }, &mixed_drag, true},
    ModelForm{"B", [](double void_fraction) { return 1.0 / void_fraction; }, &mixed_total, false},
};

}  // namespace cohesion::drag
