// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "void_fraction/divided_volume.h"
#include "void_fraction/particle_centre.h"
#include "void_fraction/sphere_overlap.h"

/// The table of void-fraction kernels: the one place that knows them all.
/// To add one: its header beside this file, its row in `kernels`, its test, its row in
/// docs/openfoam-coupling/void_fraction.md.
///
/// A kernel says which share of a sphere's volume a cell gets. What the shares of all cells lack of
/// 1, or have too much, is not the kernel's: who adds them up scales them to 1, so that the sphere
/// keeps its volume beside walls too, and where a point lies on a face of two cells.
namespace cohesion::void_fraction {

struct Kernel {
  std::string_view name;
  double reach;  ///< from the centre to the last cell that may get a share, in radii [1]
  double (*share)(const Sphere&, const Cell&);
};

inline constexpr std::array kernels{
    Kernel{ParticleCentre::name, ParticleCentre::reach, &ParticleCentre::share},
    Kernel{DividedVolume::name, DividedVolume::reach, &DividedVolume::share},
    Kernel{SphereOverlap::name, SphereOverlap::reach, &SphereOverlap::share},
};

}  // namespace cohesion::void_fraction
