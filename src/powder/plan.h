// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "powder/sizes.h"
#include "validation.h"

/// Steps and cells of a run. Any consistent set of units.
namespace cohesion::powder {

/// The settled bed.
struct Bed {
  double area;           ///< of the cross-section, [length^2]
  double height;         ///< [length]
  double void_fraction;  ///< [1]
};

/// Throws InvalidParameter unless area and height are positive and the void fraction is one.
inline void require_valid(const Bed& bed) {
  require_positive("area of the bed", bed.area);
  require_positive("height of the bed", bed.height);
  require(bed.void_fraction > 0.0 && bed.void_fraction < 1.0, "void fraction of the bed",
          bed.void_fraction, "must lie between 0 and 1");
}

/// How far from the axis the corners of a column of `sides` plane sides are whose cross-section is
/// that of a cylinder of this radius, [length].
inline double corners_of_equal_area(double radius, int sides) {
  const double angle = 2.0 * pi / sides;
  return radius * std::sqrt(angle / std::sin(angle));
}

/// How many spheres a bed has, [1].
inline double number_of_grains(const Bed& bed, const PowderSizes& sizes) {
  require_valid(bed);
  return (1.0 - bed.void_fraction) * bed.area * bed.height * sizes.number_per_solid_volume();
}

/// Mass of the bed, [mass]; density of the grains [mass/volume].
inline double mass_of(const Bed& bed, double density) {
  require_valid(bed);
  return (1.0 - bed.void_fraction) * bed.area * bed.height * density;
}

/// What the solid of a height weighs in the gas, by area, [force/length^2]: the pressure that the
/// lowest grains bear, and the pressure drop of the fluidised bed. weight: of a volume of solid,
/// (rho_p - rho) g [force/volume].
inline double pressure_of(double height, double void_fraction, double weight) {
  return (1.0 - void_fraction) * weight * height;
}

/// The largest number of two digits that is not above a positive one.
inline double two_digits_below(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::floor(value / unit * (1.0 + 1e-12)) * unit;
}

/// Steps of a contact that scheme exact is given in LAMMPS: the bed of the examples is the same at
/// a quarter and an eighth of it. In LIGGGHTS, where others' forces are those of the step before,
/// it warns of fewer than ten.
inline constexpr double steps_per_contact = 8.0, steps_per_contact_liggghts = 10.0;
/// Edge of a cell over the largest diameter, for a kernel that spreads spheres over cells.
inline constexpr double cell_over_diameter = 3.0;
/// Courant number of the gas at twice the minimum fluidisation.
inline constexpr double courant = 0.5;
/// Gas step over the time in which a grain falls through a cell, at most.
inline constexpr double falls_per_step = 0.1;

/// The longest gas step, [time]: for a gas that passes cells of this edge [length] between the
/// grains at `velocity` [length/time], and a tenth of the time in which a grain falls through one.
inline double longest_gas_step(double cell, double velocity, double gravity) {
  return std::min(courant * cell / velocity, falls_per_step * std::sqrt(2.0 * cell / gravity));
}

/// Steps of a run, [time].
struct TimeSteps {
  double particle, gas;
};

/// No longer than these, [time]: a whole number of gas steps is the interval of a run's outputs, so
/// that the run ends when it should, and a whole number of particle steps is a gas step.
inline TimeSteps steps_within(double interval, double longest_particle_step,
                              double longest_gas_step) {
  constexpr double rounding = 1e-12;
  const double gas = std::min(longest_gas_step, interval);
  const double particle = std::min(longest_particle_step, gas);
  const double of_gas = std::floor(gas / particle * (1.0 + rounding));
  const double of_interval = std::ceil(interval / (of_gas * particle) * (1.0 - rounding));
  const double step = interval / of_interval;
  return {step / of_gas, step};
}

}  // namespace cohesion::powder
