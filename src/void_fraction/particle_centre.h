// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "void_fraction/cell.h"

namespace cohesion::void_fraction {

/// The cell that holds a particle's centre gets all of its volume. Exact in the solid volume, noisy
/// when cells are not much larger than particles.
///
/// Source: M. Weber, thesis, chapter 6.
struct ParticleCentre {
  static constexpr const char* name = "particleCentre";
  static constexpr double reach = 0.0;

  /// Share of the sphere's volume that is the cell's [1].
  static double share(const Sphere& sphere, const Cell& cell) {
    return cell.contains(sphere.centre) ? 1.0 : 0.0;
  }
};

}  // namespace cohesion::void_fraction
