// SPDX-License-Identifier: GPL-2.0-only
#include "shear_companions.h"

#include <cstring>

#include "comm.h"
#include "error.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

using namespace LAMMPS_NS;

namespace {

struct Refused {
  const char* style;
  const char* reason;
};

constexpr Refused refused[] = {
    {"^momentum",
     "takes away momentum that the profile has by right; this fix removes it at the "
     "start, and shear conserves it"},
    {"^freeze", "holds particles whose images move"},
    {"^move", "leads particles on paths that the images do not follow"},
    {"^viscous", "drags towards rest, while every image of a particle has another velocity"},
};

}  // namespace

void LAMMPS_NS::refuse_companions(LAMMPS* lmp, const Fix* me, const std::string& where) {
  bool before_me = true;
  for (int i = 0; i < lmp->modify->nfix; i++) {
    const Fix* const fix = lmp->modify->fix[i];
    if (fix == me) {
      before_me = false;
      continue;
    }
    const std::string other = std::string("fix ") + fix->id + " " + fix->style;
    if (utils::strmatch(fix->style, "^deform") ||
        (fix->box_change & (Fix::BOX_CHANGE_SIZE | Fix::BOX_CHANGE_SHAPE)))
      lmp->error->all(FLERR, where + ": " + other + " changes the box too; only one can");
    if (fix->rigid_flag)
      lmp->error->all(FLERR, where + ": " + other +
                                 " does not change the velocity of a body that "
                                 "leaves through a sheared face");
    if (utils::strmatch(fix->style, "^nvt") && !strstr(fix->style, "sllod"))
      lmp->error->all(FLERR, where + ": " + other + " takes the mean flow for heat; use nvt/sllod");
    if (utils::strmatch(fix->style, "^NEIGH_HISTORY") && !before_me)
      lmp->error->all(FLERR, where +
                                 " stands before the pair_style, whose memory of contacts must be "
                                 "stored before particles change rank; give pair_style first");
    for (const Refused& r : refused)
      if (utils::strmatch(fix->style, r.style))
        lmp->error->all(FLERR, where + ": " + other + " " + r.reason);
    if ((utils::strmatch(fix->style, "^temp/") || utils::strmatch(fix->style, "^langevin")) &&
        lmp->comm->me == 0)
      lmp->error->warning(FLERR, where + ": " + other +
                                     " takes the mean flow for heat, unless "
                                     "'fix_modify temp' gives it a compute "
                                     "temp/deform");
  }
}
