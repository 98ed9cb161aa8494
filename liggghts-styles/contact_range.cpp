// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_range.h"

#include <mpi.h>

#include <sstream>

#include "common/message.h"
#include "common/plausible_sizes.h"
#include "fix_wall_gran.h"
#include "neighbor.h"
#include "property_registry.h"

namespace LIGGGHTS {
namespace Cohesion {

void require_range(LAMMPS* lmp, PropertyRegistry& registry, FixWallGran* wall,
                   const std::string& model, const ContactRange& range) {
  const double most = 2.0 * registry.max_radius();
  require_time_step(lmp, model);
  require_plausible_spheres(lmp, model);
  require_plausible_range(lmp, model, most * (1.0 + range.ratio) + range.gap);

  // The engine looks for pairs up to (f - 1)(r_i + r_j) and for walls up to (f - 1) r: the wall
  // seen by the smallest particle asks for most. The last factor keeps rounding from cutting the
  // last bit of the range off.
  lmp->neighbor->register_contact_dist_factor(
      1.0 + (range.gap / registry.min_radius() + range.ratio + range.margin) * (1.0 + 1e-6));

  // The list of particles near a primitive wall holds those within the skin when it was made, and
  // serves until a particle has moved half the skin.
  const double widest = range.gap + range.ratio * registry.max_radius();
  if (!wall || wall->is_mesh_wall() || widest <= 0.5 * lmp->neighbor->skin) return;
  LAMMPS_NS::stop(lmp, FLERR, model, ", fix wall/gran ", wall->id, ": ", range.source, " = ",
                  widest, " exceeds half the neighbor skin of ", lmp->neighbor->skin,
                  ", beyond which a primitive wall may miss particles; use 'neighbor ",
                  2.0 * widest, " bin' or more");
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
