// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_CONTACT_RANGE_H
#define COHESION_CONTACT_RANGE_H

#include <string>

class PropertyRegistry;
namespace LAMMPS_NS {
class LAMMPS;
class FixWallGran;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

/// How far beyond its range a model sees that must meet a pair there, over the sum of the radii, or
/// the radius beside a wall: none must come nearer, or part, by more in a step. Every pair that the
/// engine shows costs: of a dense gas a tenth takes half as long again.
constexpr double MARGIN = 0.01;
/// Of scheme exact: the energy account of a pair that has left its range closes in the steps after
/// it, up to three where other contacts act on the two particles.
constexpr double EXACT_MARGIN = 3.0 * MARGIN;

/// How far a cohesion acts and must see: up to a gap `gap` + `ratio` r, r being the sum of the
/// radii, or the radius beside a wall.
struct ContactRange {
  double gap = 0.0;     ///< [length]
  double ratio = 0.0;   ///< [1]
  double margin = 0.0;  ///< added to ratio: beyond the range, where it must still see
  std::string source;   ///< what a message calls the range
};

/// Makes the engine look for partners as far as `range`: what it does not look at would be missing
/// in silence. wall: the fix wall/gran this is for, or null; model: who asks.
void require_range(LAMMPS_NS::LAMMPS* lmp, PropertyRegistry& registry, LAMMPS_NS::FixWallGran* wall,
                   const std::string& model, const ContactRange& range);

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
