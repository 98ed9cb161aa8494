// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "constants.h"
#include "lattice_boltzmann/walls.h"
#include "validation.h"

namespace cohesion::lattice_boltzmann {

/// A cubic array of equal spheres, by the places in its cube.
struct CubicArray {
  const char* name;
  std::array<std::array<double, 3>, 4> places;
  int spheres;
  double densest;  ///< fraction of solid at which spheres touch, [1]
};

inline constexpr std::array cubic_arrays{
    CubicArray{"sc", {{{0.0, 0.0, 0.0}}}, 1, 0.52359877559829887},
    CubicArray{"bcc", {{{0.0, 0.0, 0.0}, {0.5, 0.5, 0.5}}}, 2, 0.68017476158781682},
    CubicArray{"fcc",
               {{{0.0, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.5, 0.0, 0.5}, {0.0, 0.5, 0.5}}},
               4,
               0.74048048969306104}};

/// Spheres in a periodic box; lengths in spacings.
struct Array {
  std::array<int, 3> nodes;
  std::vector<FixedSphere> spheres;
};

/// Sauter mean of the diameters, [spacing].
inline double sauter_mean(const Array& array) {
  double squares = 0.0, cubes = 0.0;
  for (const FixedSphere& s : array.spheres) {
    squares += s.radius * s.radius;
    cubes += s.radius * s.radius * s.radius;
  }
  return 2.0 * cubes / squares;
}

inline double volume(const Array& array) {
  return static_cast<double>(array.nodes[0]) * array.nodes[1] * array.nodes[2];
}

/// Of the spheres in the box, which must not overlap, [1].
inline double solid_fraction(const Array& array) {
  double cubes = 0.0;
  for (const FixedSphere& s : array.spheres) cubes += s.radius * s.radius * s.radius;
  return 4.0 / 3.0 * pi * cubes / volume(array);
}

/// One cube of an array with the fraction of solid `phi`, of spheres whose diameter is as near to
/// `diameter` as a whole number of nodes lets it. The array is a little off the nodes, for the
/// places of nodes among walls not to be all alike. Throws InvalidParameter unless 0 < phi <=
/// densest, to round-off, and the diameter is four spacings or more.
inline Array cubic_array(const CubicArray& kind, double phi, double diameter) {
  require(phi > 0.0 && phi <= kind.densest * (1.0 + 1e-5), "fraction of solid", phi,
          "must be above 0 and at most that of spheres that touch");
  require(std::isfinite(diameter) && diameter >= 4.0, "diameter in spacings", diameter,
          "must be 4 or more");
  const double over =
      std::cbrt(6.0 * std::min(phi, kind.densest) / (pi * kind.spheres));  // diameter over edge
  const int edge = static_cast<int>(std::lround(diameter / over));
  Array array{{edge, edge, edge}, {}};
  const std::array<double, 3> off{0.31, 0.17, 0.43};
  for (int s = 0; s < kind.spheres; s++) {
    FixedSphere sphere{{}, 0.5 * over * edge};
    for (int k = 0; k < 3; k++) sphere.centre[k] = kind.places[s][k] * edge + off[k];
    array.spheres.push_back(sphere);
  }
  return array;
}

}  // namespace cohesion::lattice_boltzmann
