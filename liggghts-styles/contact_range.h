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

/// How far beyond its range a sampled model sees that must meet a pair there, over the sum of the
/// radii, or the radius beside a wall: no pair may part by more in a step. Every pair that the
/// engine shows costs: of a dense gas a tenth takes half as long again.
constexpr double MARGIN = 0.01;
/// Time levels at which scheme exact still has to see a pair that has left its range after level n.
/// Level n+1 corrects its velocity by the stored offset and its energy account by what is known. If
/// other contacts act on the two particles, their forces of that step are known at n+2, and the
/// work f_(n+1) b_(n+2) that the last force exchanges with them at n+3 (energy_account.h).
constexpr int LEVELS_TO_CLOSE = 3;
/// Of scheme exact, so that the account closes at up to MARGIN a step: at n+3 the pair is less than
/// three steps of flight beyond its range. At up to EXACT_MARGIN a step a pair is seen at a level
/// before it comes into range, and at n+1 after it has left: its motion is right, and only the
/// corrections of n+2 and n+3 may be missing. Beyond this a pair that comes nearer is warned of.
constexpr double EXACT_MARGIN = LEVELS_TO_CLOSE * MARGIN;

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
