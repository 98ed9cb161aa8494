// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_CONTACT_MEMORY_H
#define COHESION_CONTACT_MEMORY_H

namespace LAMMPS_NS {
class FixWallGran;
class LAMMPS;
class PairGran;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

/// Whether the history of any contact, on any rank, has something other than 0 at `place`: when a
/// model is connected for the first time, what a restart file has brought. Of the pairs when wall
/// is null.
bool remembers(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PairGran* pair, LAMMPS_NS::FixWallGran* wall,
               int place);

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
