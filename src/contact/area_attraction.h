// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "constants.h"
#include "contact/hertz_spring_dashpot.h"
#include "contact/law_point.h"
#include "validation.h"

/// The attraction of LIGGGHTS' cohesion models sjkr and sjkr2: an energy density times the area of
/// contact. Any consistent set of units.
namespace cohesion::contact {

/// The area of contact over pi R* x at overlaps x small next to the radii. sjkr: the circle in
/// which the spheres, or sphere and wall, intersect. sjkr2: twice as large between spheres.
///
///   sjkr, spheres   pi/4 ((R_i + R_j)^2 - r^2) (r^2 - (R_i - R_j)^2)/r^2 -> 2 pi R* x
///   sjkr, wall      pi (R^2 - r^2)                                      -> 2 pi R x
///   sjkr2, spheres  2 pi (2 R*) x
///   sjkr2, wall     2 pi R x
///
/// Source: LIGGGHTS 3.8, cohesion_model_sjkr.h and cohesion_model_sjkr2.h.
enum class ContactArea { circle, doubled };
inline constexpr double area_factor(ContactArea area) {
  return area == ContactArea::circle ? 2.0 : 4.0;
}

/// Slope b [force/length] of the attraction F = b x of an energy density k [energy/length^3]; R*
/// [length], R at a wall. Throws InvalidParameter where k < 0.
inline double attraction_slope(double energy_density, ContactArea area, double reduced_radius) {
  require_non_negative("cohesion energy density k", energy_density);
  return area_factor(area) * pi * reduced_radius * energy_density;
}

/// Hertz's contact, c x^(3/2) with its dashpot, less the attraction b x:
///
///   F = c x^(3/2) - b x     U = (2/5) c x^(5/2) - b x^2/2
///
/// The attraction vanishes at touch, so that it has a largest net value and no work on the way in:
///
///   x_p = (2 b/(3 c))^2     pull-off force -F(x_p) = 4 b^3/(27 c^2)
///
/// Source: derived here.
class HertzWithAreaAttraction {
 public:
  /// slope [force/length]: b. Throws InvalidParameter where b < 0.
  HertzWithAreaAttraction(const HertzSpringDashpot& hertz, double slope)
      : hertz_(hertz), slope_(slope) {
    require_non_negative("slope of the attraction", slope);
  }

  /// x_p [length]: where the net attraction is largest.
  double overlap_at_pull_off() const {
    const double root = 2.0 * slope_ / (3.0 * hertz_.coefficient());
    return root * root;
  }
  /// The largest net attraction, [force].
  double pull_off_force() const { return slope_ * overlap_at_pull_off() / 3.0; }
  /// The overlap at which a pair rests, (b/c)^2 [length].
  double resting_overlap() const { return 2.25 * overlap_at_pull_off(); }
  /// Energy that separates a pair at rest, b x^2/10 at that overlap, [energy].
  double well_energy() const { return 0.1 * slope_ * resting_overlap() * resting_overlap(); }

  const HertzSpringDashpot& hertz() const { return hertz_; }
  double reduced_mass() const { return hertz_.reduced_mass(); }
  bool is_damped() const { return hertz_.is_damped(); }
  static constexpr double lowest_overlap() { return 0.0; }
  static constexpr double friction_load() { return 0.0; }

  /// At an overlap x >= 0 [length].
  LawPoint at(double x) const {
    LawPoint p = hertz_.at(x);
    p.force -= slope_ * x;
    p.stiffness -= slope_;
    p.energy -= 0.5 * slope_ * x * x;
    return p;
  }

 private:
  HertzSpringDashpot hertz_;
  double slope_;
};

/// The energy density k [energy/length^3] that has this pull-off force in Hertz's contact.
inline double energy_density_of_pull_off(double force, const HertzSpringDashpot& hertz,
                                         ContactArea area, double reduced_radius) {
  require_non_negative("pull-off force", force);
  const double c = hertz.coefficient();
  return std::cbrt(6.75 * c * c * force) / (area_factor(area) * pi * reduced_radius);
}

}  // namespace cohesion::contact
