// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

/// Drag of one sphere in an unbounded gas over Stokes' drag, C_D Re/24 [1], against
/// Re = rho d |u - v|/mu >= 0 [1]. In this form nothing is divided by Re.
namespace cohesion::drag {

/// C_D = 24/Re (1 + 0.15 Re^0.687) below Re = 1000, 0.44 from there; it jumps by 0.4 % in between.
/// L. Schiller, A. Naumann, Z. VDI 77 (1933) 318. P. N. Rowe and G. A. Henwood, Trans. Inst. Chem.
/// Eng. 39 (1961) 43, is cited for the same formula.
inline double schiller_naumann(double reynolds) {
  return reynolds < 1000.0 ? 1.0 + 0.15 * std::pow(reynolds, 0.687) : 0.44 / 24.0 * reynolds;
}

/// C_D = (0.63 + 4.8/sqrt(Re))^2, J. M. Dalla Valle, Micromeritics (1948). Its Stokes limit is
/// 0.96.
inline double dalla_valle(double reynolds) {
  const double root = 0.63 * std::sqrt(reynolds) + 4.8;
  return root * root / 24.0;
}

}  // namespace cohesion::drag
