// SPDX-License-Identifier: GPL-2.0-or-later
#include <mpi.h>
// The engine's headers want mpi.h before them.
#include "common/message.h"
#include "fix_wall_gran.h"
#include "liggghts_api.h"
#include "primitive_wall.h"

namespace LAMMPS_NS {
namespace engine_api {

void BoxFix::init() {
  refuse_walls();
  warn_of_unseen_gaps();
  domain->deform_flag = domain->deform_vremap = 1;
  domain->deform_groupbit = groupbit;
  atom->avec->init();  // keeps a copy of these
  clear_rates();
}

/// The engine makes walls in tilted boxes only where a flag allows them.
void BoxFix::refuse_walls() const {
  for (int n = 0; n < modify->nfix; n++) {
    const auto wall = dynamic_cast<FixWallGran*>(modify->fix[n]);
    if (!wall || !wall->primitiveWall()) continue;
    // From somewhere in the box, towards the wall.
    double place[3], towards[3] = {};
    for (int k = 0; k < 3; k++)
      place[k] = domain->boxlo[k] + (0.37 + 0.11 * k) * (domain->boxhi[k] - domain->boxlo[k]);
    wall->primitiveWall()->resolveContact(place, 0.0, towards);
    if (towards[0] != 0.0 || towards[1] != 0.0)
      stop(lmp, FLERR, "fix ", id, " ", style, ": fix ", wall->id,
           " wall/gran is no wall of all images; only a zplane is, in a box that is not periodic "
           "along z");
  }
}

/// `neigh_modify` puts its factor in the place of what fixes and models have asked for.
void BoxFix::warn_of_unseen_gaps() const {
  if (comm->me != 0 || neighbor->contactDistanceFactor >= SEEN_APART) return;
  error->warning(FLERR,
                 message("fix ", id, " ", style, ": with contact_distance_factor ",
                         neighbor->contactDistanceFactor,
                         " a contact that ends keeps its friction until lists are made new; use "
                         "'neigh_modify contact_distance_factor ",
                         SEEN_APART, "' or more")
                     .c_str());
}

}  // namespace engine_api
}  // namespace LAMMPS_NS
