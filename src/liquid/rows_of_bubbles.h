// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "drag/gas_on_particle.h"
#include "liquid/liquid_on_particle.h"

/// What becomes of the rows of bubbles that merge or break between two exchanges with the solver:
/// sums over the bubbles are kept, of what is yet to be charged, of the pressure's force, of added
/// mass and lift; drag goes with the diameter, b, and with its square, q.
namespace cohesion::liquid {

/// Of two bubbles of these volumes [length^3]: that of the first becomes that of both.
inline void merge_rows(drag::GasOnParticle& into, const drag::GasOnParticle& gone,
                       double volume_into, double volume_gone) {
  const double share = volume_gone / (volume_into + volume_gone);
  const auto cube = [](double a) { return a * a * a; };
  const double joint = std::cbrt(cube(into.drag_coefficient) + cube(gone.drag_coefficient));
  // The cubes of what marks a particle that has been given a row are 0.
  into.drag_coefficient = std::max({joint, into.drag_coefficient, gone.drag_coefficient});
  for (int k = 0; k < 3; k++) {
    into.velocity[k] += share * (gone.velocity[k] - into.velocity[k]);
    into.pressure_gradient[k] += share * (gone.pressure_gradient[k] - into.pressure_gradient[k]);
    into.drag_impulse[k] += gone.drag_impulse[k];
  }
}

inline void merge_rows(LiquidOnParticle& into, const LiquidOnParticle& gone) {
  const double mass = into.added_mass + gone.added_mass;
  const double share = mass > 0.0 ? gone.added_mass / mass : 0.5;
  into.added_mass = mass;
  into.drag_per_slip = std::cbrt(
      std::pow(std::pow(into.drag_per_slip, 1.5) + std::pow(gone.drag_per_slip, 1.5), 2.0));
  for (int k = 0; k < 3; k++) {
    into.acceleration[k] += share * (gone.acceleration[k] - into.acceleration[k]);
    into.lift[k] += gone.lift[k];
  }
}

/// Of a bubble that has the volume `volume` [length^3] after a nozzle blew `more` of it into it:
/// the pressure's force stays. All else is per bubble.
inline void spread_row(drag::GasOnParticle& row, double volume, double more) {
  for (double& gradient : row.pressure_gradient) gradient *= (volume - more) / volume;
}

/// Of one of two halves.
inline void halve_row(drag::GasOnParticle& whole) {
  whole.drag_coefficient *= std::cbrt(0.5);
  for (double& impulse : whole.drag_impulse) impulse *= 0.5;
}

inline void halve_row(LiquidOnParticle& whole) {
  whole.added_mass *= 0.5;
  whole.drag_per_slip *= std::cbrt(0.25);
  for (double& lift : whole.lift) lift *= 0.5;
}

}  // namespace cohesion::liquid
