// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>

#include "hamaker/forms.h"
#include "hamaker/parameters.h"
#include "sphere.h"

namespace cohesion::hamaker {

/// Throws InvalidParameter where a cut-off is so large, beside the particles, that the form means
/// something else there (Form::largest_surface_cutoff, largest_outer_cutoff). g: of the smallest
/// two particles, or the smallest one and a wall. A law that is off has any.
inline void require_far_below_radius(const Form& form, const Parameters& p, const PairGeometry& g) {
  if (p.hamaker_constant == 0.0) return;
  const auto require_below = [&](const char* name, double value, double share) {
    std::ostringstream remedy;
    remedy << "must not be above " << share * g.reduced_radius << ", " << share
           << " of the reduced radius of the smallest two that meet: the attraction is one of gaps "
              "far "
              "below the radius (form "
           << form.name << ")";
    // The limit to the last digit is still the limit.
    require(value <= (1.0 + 1e-6) * share * g.reduced_radius, name, value, remedy.str());
  };
  require_below("surface cut-off H_cut", p.surface_cutoff, form.largest_surface_cutoff);
  require_below("outer cut-off H_out", p.outer_cutoff, form.largest_outer_cutoff);
}

}  // namespace cohesion::hamaker
