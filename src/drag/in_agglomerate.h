// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::drag {

/// A particle's agglomerate. Nothing but doubles, in this order: engines keep it as a row of
/// per-particle numbers.
struct InAgglomerate {
  double id;        ///< of the agglomerate; of a single sphere 0
  double number;    ///< N, [1]; of a single sphere 1, of one that was not looked at 0
  double gyration;  ///< R_g, [length]; below 0: it is bound to its own periodic image

  bool bound() const { return number > 1.0; }
  bool endless() const { return bound() && gyration < 0.0; }
};
static_assert(sizeof(InAgglomerate) == 3 * sizeof(double));

}  // namespace cohesion::drag
