// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_SHEAR_COMPANIONS_H
#define COHESION_SHEAR_COMPANIONS_H

#include <string>

namespace LAMMPS_NS {

/// Stops when another fix would lose particles of a sheared box or move them wrongly, with the
/// reason; warns of those that may. `where` names the fix that shears, `me`.
void refuse_companions(class LAMMPS*, const class Fix* me, const std::string& where);

}  // namespace LAMMPS_NS

#endif
