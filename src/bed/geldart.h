// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::bed {

/// Groups of powders by how a gas fluidises them: A expands before it bubbles, B bubbles from the
/// minimum fluidisation on, D spouts and its bubbles are slower than the gas between the particles.
enum class GeldartGroup : char { A = 'A', B = 'B', D = 'D' };

/// Geldart's lines between the groups, for air at ambient conditions. density_difference: particle
/// less gas [kg/m^3]; diameter: surface-volume (Sauter) mean [m]. The numbers carry SI units:
///   A | B   density_difference diameter   = 0.225 kg/m^2   (225 g/cm^3 um)
///   B | D   density_difference diameter^2 = 1e-3 kg/m      (1e6 g/cm^3 um^2)
/// A powder on a line is of the coarser group. The lines cross at a diameter of 4.4 mm and 51
/// kg/m^3; beyond that, light and large, it is D. Group C, cohesive, has no such line: what keeps
/// it from being fluidised is the ratio of attraction to weight (the Bond number), not size and
/// density. Source: D. Geldart, Types of gas fluidization, Powder Technology 7 (1973) 285.
inline constexpr GeldartGroup geldart_group(double density_difference, double diameter) {
  if (density_difference * diameter * diameter >= 1e-3) return GeldartGroup::D;
  return density_difference * diameter < 0.225 ? GeldartGroup::A : GeldartGroup::B;
}

}  // namespace cohesion::bed
