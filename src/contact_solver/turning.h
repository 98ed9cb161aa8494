// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>

#include "contact/adhesion.h"
#include "validation.h"

namespace cohesion::contact_solver {

/// Largest range of an adhesion over the distance of the centres at touch, [1]: see
/// require_turns_as_touching.
inline constexpr double largest_range_over_distance = 1.0 / 30.0;

/// Throws InvalidParameter at an adhesion of so wide a range that scheme exact turns pairs wrongly
/// in it. The motion along the normal has a closed form where what pulls is constant, and so the
/// centrifugal acceleration, L^2/(D + h)^3 at a gap h, is taken at touch, h = 0: there it is
/// (1 + h/D)^3 times as large, of which a tenth is let pass.
inline void require_turns_as_touching(const contact::Adhesion& adhesion, double contact_distance) {
  if (adhesion.force == 0.0) return;
  const double largest = largest_range_over_distance * contact_distance;
  std::ostringstream remedy;
  remedy << "must not be above " << largest
         << ", a thirtieth of the distance of the smallest two that meet: scheme exact turns pairs "
            "as if they touched; use 'scheme sampled', a smaller H_cut or, where it was scaled for "
            "a soft spring, a stiffer one";
  // The limit to the last digit is still the limit.
  require(adhesion.cutoff <= (1.0 + 1e-6) * largest, "surface cut-off H_cut of the contact",
          adhesion.cutoff, remedy.str());
}

}  // namespace cohesion::contact_solver
