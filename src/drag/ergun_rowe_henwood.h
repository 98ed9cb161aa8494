// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drag/ergun_wen_yu.h"

namespace cohesion::drag {

/// Ergun's packed bed below a void fraction of 0.8, from there the drag on each particle as a
/// single sphere's, corrected for its neighbours:
///
///   F_total = eps^-4.7 F_0(U),   F_0 = 1/2 C_D rho pi/4 d^2 U^2,   U = eps |u - v|
///
/// with C_D of P. N. Rowe and G. A. Henwood, which is the formula of Schiller and Naumann. So it is
/// ErgunWenYu with the exponent 4.7, and has its limits, jump and validity. The correction is read
/// as one of F_total, as in ErgunWenYu; only then do suspensions settle as they do, at
/// eps^4.7 of a single sphere's speed.
///
/// Source: B. P. B. Hoomans, J. A. M. Kuipers, W. J. Briels, W. P. M. van Swaaij, Chem. Eng. Sci.
/// 51 (1996) 99.
struct ErgunRoweHenwood {
  static constexpr const char* name = "ergunRoweHenwood";
  static constexpr Validity validity = ErgunWenYu::validity;
  static constexpr double exponent = 4.7;
  static constexpr auto with_exponent = &ErgunWenYu::with_exponent;

  /// beta/(1 - eps) as in SyamlalOBrien::per_solid_volume.
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double viscosity) {
    return with_exponent(exponent, void_fraction, slip, diameter, density, viscosity);
  }
};

}  // namespace cohesion::drag
