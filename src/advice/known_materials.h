// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "advice/si_units.h"
#include "sphere.h"

/// Numbers that no material has: most often they are meant in another unit.
namespace cohesion::advice {

/// Of a Hamaker constant, [J]: hydrocarbons across water to metals across vacuum.
///
/// Source: J. N. Israelachvili, Intermolecular and Surface Forces, 3rd ed., section 13.
inline constexpr double least_hamaker_constant = 1e-21, largest_hamaker_constant = 1e-18;

/// What to say of a Hamaker constant [energy] that is above that of any material; empty: nothing.
inline std::string above_hamaker_constants(double constant, const SiUnits* units) {
  if (!units) return "";
  const double joules = constant * units->energy();
  if (joules <= (1.0 + 1e-9) * largest_hamaker_constant) return "";
  std::ostringstream text;
  text.precision(4);
  text << "the Hamaker constant A = " << constant;
  if (units->name == "si")
    text << " J";
  else
    text << " of 'units " << units->name << "' is " << joules << " J and";
  text << " is above that of any material (" << least_hamaker_constant << " to "
       << largest_hamaker_constant << " J): check its value and its unit; ";
  return text.str();
}

/// Of the energy of a surface, [J/m^2]: clean metals have up to 4, diamond 6.
///
/// Source: J. N. Israelachvili, Intermolecular and Surface Forces, 3rd ed., section 17.
inline constexpr double largest_surface_energy = 6.0;

/// What to say of an energy of a surface [energy/length^2] that is above that of any material;
/// empty: nothing.
inline std::string above_surface_energies(double energy, const SiUnits* units) {
  if (!units) return "";
  const double si = energy * units->energy() / (units->length * units->length);
  if (si <= (1.0 + 1e-9) * largest_surface_energy) return "";
  std::ostringstream text;
  text.precision(4);
  text << "the surface energy gamma = " << energy;
  if (units->name == "si")
    text << " J/m2";
  else
    text << " of 'units " << units->name << "' is " << si << " J/m2 and";
  text << " is above that of any material (up to " << largest_surface_energy
       << " J/m2): check its value and its unit; ";
  return text.str();
}

/// Of the density of a particle, [kg/m^3]: far below an aerogel's, far above that of any element.
/// Masses that are scaled for a longer time step are beyond.
inline constexpr double least_density = 0.1, largest_density = 1e5;
/// Of a density that a script gives for a solid, [kg/m^3].
inline constexpr double least_solid = 100.0, largest_solid = 3e4;

/// Whether no material gives a sphere of this radius [length] this mass [mass].
inline bool is_mass_of_no_material(double mass, double radius, const SiUnits& units) {
  const double density = units.density() * mass / sphere_volume(radius);
  return density < least_density || density > largest_density;
}

/// Whether a mass [mass] is beyond what a sphere of this radius [length] of any material has, and
/// is that of a sphere of diameter 1 of a solid: spheres have this diameter until a script sets
/// another one, which leaves their mass as it is.
inline bool is_mass_of_diameter_1(double mass, double radius, const SiUnits* units) {
  if (!units || !is_mass_of_no_material(mass, radius, *units)) return false;
  const double of_diameter_1 = units->density() * mass / sphere_volume(0.5);
  return of_diameter_1 >= least_solid && of_diameter_1 <= largest_solid;
}

/// Whether a mass [mass] is beyond what a sphere of this radius [length] of any material has, and
/// is that of a sphere of diameter 1 and density 1 in the units of the script: `create_atoms` makes
/// these, and a script that sets no density leaves their mass as it is.
inline bool is_mass_as_created(double mass, double radius, const SiUnits* units) {
  constexpr double rounding = 1e-12;
  const double created = sphere_volume(0.5);
  return units && is_mass_of_no_material(mass, radius, *units) &&
         std::abs(mass - created) <= rounding * created;
}

}  // namespace cohesion::advice
