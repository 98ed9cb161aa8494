// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "constants.h"

/// Geometry that several laws share.
namespace cohesion {

/// Volume of a sphere, [length^3].
inline constexpr double sphere_volume(double radius) {
  return 4.0 / 3.0 * pi * radius * radius * radius;
}

/// Reduced radius R* = r_i r_j / (r_i + r_j) of two spheres, [length]. A plane is a sphere of
/// infinite radius: R* of sphere and plane is the radius of the sphere.
inline constexpr double reduced_radius(double radius_i, double radius_j) {
  return radius_i * radius_j / (radius_i + radius_j);
}

/// Two spheres, or a sphere and a plane, as a law between their surfaces sees them: what stays
/// finite and exact when one radius becomes infinite.
struct PairGeometry {
  double reduced_radius;            ///< R* = r_i r_j/(r_i + r_j), [length]
  double inverse_contact_distance;  ///< 1/(r_i + r_j), [1/length]; 0 beside a plane
};

inline constexpr PairGeometry two_spheres(double radius_i, double radius_j) {
  return {reduced_radius(radius_i, radius_j), 1.0 / (radius_i + radius_j)};
}

inline constexpr PairGeometry sphere_and_plane(double radius) { return {radius, 0.0}; }

/// Reduced mass mu = m_i m_j / (m_i + m_j) of two particles, [mass]. A wall has infinite mass: mu
/// of particle and wall is the mass of the particle.
inline constexpr double reduced_mass(double mass_i, double mass_j) {
  return mass_i * mass_j / (mass_i + mass_j);
}

}  // namespace cohesion
