// SPDX-License-Identifier: GPL-2.0-only
#include "unturned_spheres.h"

#include <mpi.h>

#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "mobile_particles.h"

using namespace LAMMPS_NS;

bool LAMMPS_NS::warn_of_unturned(LAMMPS* lmp, const MobileParticles& mobile,
                                 const std::vector<bool>& rubs) {
  const Atom* const atom = lmp->atom;
  bigint mine = 0, all = 0;
  int my_groups = 0, groups = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!rubs[atom->type[i]] || !mobile.is_not_turned(atom->mask[i])) continue;
    mine++;
    my_groups |= atom->mask[i];
  }
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, lmp->world);
  MPI_Allreduce(&my_groups, &groups, 1, MPI_INT, MPI_BOR, lmp->world);
  if (all == 0) return false;
  const Modify* const modify = lmp->modify;
  const Fix* const mover =
      *std::find_if(modify->fix, modify->fix + modify->nfix, [groups](const Fix* fix) {
        return MobileParticles::integrates(fix) && (fix->groupbit & groups);
      });
  if (lmp->comm->me == 0)
    lmp->error->warning(FLERR,
                        "friction acts on {} particles that fix {} {} moves and does not turn: "
                        "their spins stay as they are, and they slide where spheres roll; use "
                        "'fix nve/sphere'",
                        all, mover->id, mover->style);
  return true;
}
