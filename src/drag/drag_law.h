// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

#include "drag/drag_closure.h"
#include "sphere.h"
#include "validation.h"

namespace cohesion::drag {

/// A closure as the user wants it: times a factor, and with another exponent of the void fraction
/// where the closure has one.
class DragLaw {
 public:
  /// factor [1] > 0; exponent n [1] > 0 of closures of the type eps^-n; coefficient C_d [1] > 0 of
  /// those that take one. Throws InvalidParameter when any is out of bounds, when the closure has
  /// none to choose, and when it has no coefficient without.
  explicit DragLaw(const Closure& closure, double factor = 1.0,
                   std::optional<double> exponent = std::nullopt,
                   std::optional<double> coefficient = std::nullopt)
      : closure_(closure), factor_(factor) {
    require_positive("dragFactor", factor);
    set_coefficient(coefficient);
    if (!exponent) return;
    if (!closure.with_exponent) refuse_exponent(closure, *exponent);
    require_positive("dragExponent", *exponent);
    exponent_ = *exponent;
  }

  const Closure& closure() const { return closure_; }

  /// Drag over that of the other members, [1], of spheres of a density in a fluid of another
  /// [mass/volume]. Throws InvalidParameter where the closure has none for these.
  double of_densities(double sphere_density, double density) const {
    if (!closure_.of_densities) return 1.0;
    const double share = closure_.of_densities(sphere_density, density);
    require(share > 0.0, "density of a sphere", sphere_density,
            "drag '" + std::string(closure_.name) +
                "' is of bubbles, lighter than the fluid around them, and that has " +
                std::to_string(density) + "; take constantCd for others");
    return share;
  }

  /// beta/(1 - eps), [mass/(volume time)]; arguments as in SyamlalOBrien::per_solid_volume.
  double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                          double viscosity) const {
    return factor_ * (exponent_ > 0.0 ? closure_.with_exponent(exponent_, void_fraction, slip,
                                                               diameter, density, viscosity)
                                      : closure_.per_solid_volume(void_fraction, slip, diameter,
                                                                  density, viscosity));
  }

  /// b of the drag b (u - v) on a sphere among spheres of other sizes, [force time/length]: `mixed`
  /// of size_mixture.h, `sauter` mean of those around [length].
  double coefficient_among(double mixed, double sauter, double void_fraction, double slip,
                           double diameter, double density, double viscosity) const {
    return mixed * sphere_volume(0.5 * diameter) *
           per_solid_volume(void_fraction, slip, sauter, density, viscosity);
  }

  /// b of the drag b (u - v) on a sphere among equal ones, [force time/length].
  double coefficient(double void_fraction, double slip, double diameter, double density,
                     double viscosity) const {
    return sphere_volume(0.5 * diameter) *
           per_solid_volume(void_fraction, slip, diameter, density, viscosity);
  }

 private:
  void set_coefficient(std::optional<double> coefficient) {
    const std::string name(closure_.name);
    if (!closure_.takes_coefficient) {
      require(!coefficient, "dragCoefficient", coefficient.value_or(0.0),
              "drag '" + name + "' has its own; remove the entry, or take drag constantCd");
      return;
    }
    require(coefficient.has_value(), "dragCoefficient", 0.0,
            "drag '" + name + "' needs it, the C_d of a sphere, greater than zero");
    require_positive("dragCoefficient", *coefficient);
    factor_ *= *coefficient;
  }

  [[noreturn]] static void refuse_exponent(const Closure& closure, double exponent) {
    std::string with;
    for (const Closure& row : closures)
      if (row.with_exponent) with += (with.empty() ? "" : ", ") + std::string(row.name);
    require(false, "dragExponent", exponent,
            "drag '" + std::string(closure.name) + "' has no exponent to choose, as " +
                std::string(closure.no_exponent) + "; remove the entry, or take one of " + with);
    std::abort();
  }

  Closure closure_;
  double factor_;
  // 0: the closure's own. Of an optional GCC 12 at -O1 says, wrongly, that it is not initialised.
  double exponent_ = 0.0;
};

}  // namespace cohesion::drag
