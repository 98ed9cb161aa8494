// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::void_fraction {

/// Void fraction of a cell. In a 2-D simulation the mesh may be of any thickness; the particles
/// live in a slab of `depth` (one diameter in the thesis), so the cell's volume counts
/// depth/thickness. solid_volume and cell_volume [length^3], depth_over_thickness [1], 1 in 3-D.
inline double void_fraction(double solid_volume, double cell_volume, double depth_over_thickness) {
  return 1.0 - solid_volume / (cell_volume * depth_over_thickness);
}

}  // namespace cohesion::void_fraction
