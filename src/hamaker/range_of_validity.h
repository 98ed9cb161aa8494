// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <variant>

#include "hamaker/forms.h"
#include "hamaker/parameters.h"
#include "sphere.h"

namespace cohesion::hamaker {

/// Throws InvalidParameter where a cut-off is so large, beside the particles, that the form means
/// something else there (Form::largest_surface_cutoff, largest_outer_cutoff). g: of the smallest
/// two particles, or the smallest one and a wall. A law that is off has any.
inline void require_far_below_radius(const Form& form, const HamakerParameters& p,
                                     const PairGeometry& g) {
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

/// Up to which asperities may strengthen the force of contact, over that of smooth surfaces, [1]:
/// as far as the form of small gaps is let be too strong.
inline constexpr double largest_gain_of_asperities = 1.1;

/// Throws InvalidParameter where asperities are so flat that cap and body are felt as two bodies
/// (asperity.h): the attraction would be up to twice that of smooth surfaces. g: of the smallest
/// two particles, or the smallest one and a wall, whose asperities do most.
inline void require_weakened_by_asperities(const Form& form, const HamakerParameters& p,
                                           const PairGeometry& g) {
  if (p.hamaker_constant == 0.0 || p.asperity_radius == 0.0) return;
  const auto force_of_contact = [&](double radius, double height) {
    const HamakerParameters of_unit_constant{1.0, p.surface_cutoff, p.outer_cutoff, radius, height};
    return std::visit([&](const auto& l) { return l.adhesion_force(g); },
                      form.law(of_unit_constant, radius > 0.0));
  };
  const double gain =
      force_of_contact(p.asperity_radius, p.asperity_height) / force_of_contact(0.0, 0.0);
  std::ostringstream remedy;
  remedy << "too low for its radius of " << p.asperity_radius << ": the force of contact would be "
         << gain
         << " of that of smooth surfaces, since cap and body are both felt in full; take a larger "
            "rms, a smaller wavelength, or smooth surfaces";
  require(gain <= largest_gain_of_asperities, "asperity height", height_of_asperity(p),
          remedy.str());
}

}  // namespace cohesion::hamaker
