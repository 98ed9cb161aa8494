// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_SHEAR_COMPATIBILITY_H
#define COHESION_SHEAR_COMPATIBILITY_H

#include <string>

namespace LAMMPS_NS {

/// Stops with the reason when another fix would lose particles of a sheared box or move them
/// wrongly, and warns of fixes that may. `where` names the fix that shears, `me`.
void require_compatible_fixes(class LAMMPS*, const class Fix* me, const std::string& where);

}  // namespace LAMMPS_NS

#endif
