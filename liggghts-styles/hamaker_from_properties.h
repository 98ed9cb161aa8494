// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_HAMAKER_FROM_PROPERTIES_H
#define COHESION_HAMAKER_FROM_PROPERTIES_H

#include <vector>

#include "hamaker/law.h"
#include "hamaker/small_gap.h"

class PropertyRegistry;
namespace LAMMPS_NS {
class LAMMPS;
class FixWallGran;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

/// The law of each pair of atom types, read from fix property/global hamakerConstant
/// (peratomtypepair), hamakerSurfaceCutoff and hamakerOuterCutoff (scalar).
/// A parameter that cannot be right stops the engine with the types and the values given.
class HamakerOfTypes {
 public:
  using Law = cohesion::hamaker::Law<cohesion::hamaker::SmallGap>;

  HamakerOfTypes(LAMMPS_NS::LAMMPS* lmp, PropertyRegistry& registry);

  const Law& of(int itype, int jtype) const { return laws_[(itype - 1) * types_ + jtype - 1]; }
  double outer_cutoff() const { return laws_.front().outer_cutoff(); }

 private:
  int types_;
  std::vector<Law> laws_;
};

/// Makes the engine look for partners up to a gap of `range`: the force at a gap beyond what the
/// engine looks at would be missing in silence. wall: the fix wall/gran this is for, or null.
void require_range(LAMMPS_NS::LAMMPS* lmp, PropertyRegistry& registry, LAMMPS_NS::FixWallGran* wall,
                   double range);

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
