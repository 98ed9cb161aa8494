// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_REGISTER_STYLES_H
#define COHESION_REGISTER_STYLES_H

namespace LAMMPS_NS {
class LAMMPS;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

/// Names the fixes and computes of this package to an engine that has just been made, or cleared.
/// The launcher and the preloaded library do so by themselves.
void register_styles(LAMMPS_NS::LAMMPS* lmp);

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
