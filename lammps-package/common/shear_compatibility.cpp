// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/shear_compatibility.h"

#include <string>

#include "comm.h"
#include "common/engine_api.h"
#include "common/message.h"
#include "modify.h"

using namespace LAMMPS_NS;

namespace {

struct Incompatible {
  const char* style;
  const char* reason;
};

constexpr Incompatible incompatible[] = {
    {"momentum",
     "takes away momentum that the profile has by right; "
     "this fix removes it at the start, and shear conserves it"},
    {"freeze", "holds particles whose images move"},
    {"move", "leads particles on paths that the images do not follow"},
    {"viscous", "drags towards rest, while every image of a particle has another velocity"},
    // Of LIGGGHTS only.
    {"multisphere", "does not change the velocity of a body that leaves through a sheared face"},
    {"mesh/surface",
     "keeps its triangles on the ranks by the corners of their parts of the box; "
     "a tilted box has none"},
    {"couple/", "brings forces of a gas that does not know of the tilted box"},
};

bool begins_with(const std::string& style, const char* start) { return style.rfind(start, 0) == 0; }

}  // namespace

void LAMMPS_NS::require_compatible_fixes(LAMMPS* lmp, const Fix* me, const std::string& where) {
  bool before_me = true;
  for (int i = 0; i < lmp->modify->nfix; i++) {
    const Fix* const fix = lmp->modify->fix[i];
    if (fix == me) {
      before_me = false;
      continue;
    }
    const std::string style = fix->style, other = message("fix ", fix->id, " ", style);
    if (begins_with(style, "deform") || engine_api::changes_box(fix))
      stop(lmp, FLERR, where, ": ", other, " changes the box too; only one can");
    if (fix->rigid_flag)
      stop(lmp, FLERR, where, ": ", other,
           " does not change the velocity of a body that leaves through a sheared face");
    if (begins_with(style, "nvt") && style.find("sllod") == std::string::npos)
      stop(lmp, FLERR, where, ": ", other, " takes the mean flow for heat; use nvt/sllod");
    if (begins_with(style, "NEIGH_HISTORY") && !before_me)
      stop(
          lmp, FLERR, where,
          " stands before the pair_style, whose memory of contacts must be stored before particles "
          "change rank; give pair_style first");
    for (const Incompatible& row : incompatible)
      if (begins_with(style, row.style)) stop(lmp, FLERR, where, ": ", other, " ", row.reason);
    if ((begins_with(style, "temp/") || begins_with(style, "langevin")) && lmp->comm->me == 0)
      lmp->error->warning(FLERR, message(where, ": ", other,
                                         " takes the mean flow for heat, unless 'fix_modify temp' "
                                         "gives it a compute temp/deform")
                                     .c_str());
  }
}
