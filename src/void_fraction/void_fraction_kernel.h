// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "void_fraction/cell.h"
#include "void_fraction/divided_volume.h"
#include "void_fraction/sphere_overlap.h"

/// The table of void-fraction kernels: the one place that knows them all. How to add one:
/// docs/contributing.md.
///
/// A kernel says which share of a sphere's volume a cell gets, from the sphere and that cell alone.
/// A cell that has no point within `reach` of the centre gets none, and one that has all of those
/// gets all: of such cells the kernel may not be asked. What the shares of all cells lack of 1, or
/// have too much, is not the kernel's: who adds them up scales them to 1, so that the sphere keeps
/// its volume beside walls too, and where a point lies on a face of two cells.
namespace cohesion::void_fraction {

/// The cell that holds a particle's centre gets all of its volume. Exact in the solid volume, noisy
/// when cells are not much larger than particles.
///
/// Source: M. Weber, thesis, chapter 6.
struct ParticleCentre {
  static constexpr const char* name = "particleCentre";
  static constexpr double reach = 0.0;

  /// Share of the sphere's volume that is in the cell [1].
  static double share(const Sphere& sphere, const Cell& cell) {
    return cell.contains(sphere.centre) ? 1.0 : 0.0;
  }
};

struct Kernel {
  std::string_view name;
  /// From the centre to the farthest point by which a cell may get a share, in radii [1]; 0: all
  /// goes to the cell of the centre.
  double reach;
  double (*share)(const Sphere&, const Cell&);
};

inline constexpr std::array kernels{
    Kernel{ParticleCentre::name, ParticleCentre::reach, &ParticleCentre::share},
    Kernel{DividedVolume::name, DividedVolume::reach, &DividedVolume::share},
    Kernel{SphereOverlap::name, SphereOverlap::reach, &SphereOverlap::share},
};

}  // namespace cohesion::void_fraction
