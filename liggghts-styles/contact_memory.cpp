// SPDX-License-Identifier: GPL-2.0-or-later
#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <string>

#include "atom.h"
#include "contact_memory.h"
#include "fix_contact_history_mesh.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "lammps.h"
#include "modify.h"
#include "pair_gran.h"

using namespace LAMMPS_NS;

namespace LIGGGHTS {
namespace Cohesion {

namespace {

bool any(FixContactHistory* contacts, int particles, int place) {
  for (int i = 0; contacts && i < particles; i++)
    for (int k = 0; k < contacts->n_partner(i); k++)
      if (contacts->contacthistory(i, k)[place] != 0.0) return true;
  return false;
}

bool any_of_meshes(FixWallGran& wall, int particles, int place) {
  for (int mesh = 0; mesh < wall.n_meshes(); mesh++)
    if (any(wall.mesh_list()[mesh]->contactHistory(), particles, place)) return true;
  return false;
}

/// The engine keeps these with the particles, under a name made of the wall's.
bool any_of_primitive(LAMMPS* lmp, const FixWallGran& wall, int particles, int place) {
  const Fix* const contacts = lmp->modify->find_fix_id((std::string("history_") + wall.id).c_str());
  for (int i = 0; contacts && i < particles; i++)
    if (contacts->array_atom[i][place] != 0.0) return true;
  return false;
}

}  // namespace

bool remembers(LAMMPS* lmp, PairGran* pair, FixWallGran* wall, int place) {
  const int particles = lmp->atom->nlocal;
  const int here = !wall                  ? any(pair->get_fix_history(), particles, place)
                   : wall->is_mesh_wall() ? any_of_meshes(*wall, particles, place)
                                          : any_of_primitive(lmp, *wall, particles, place);
  int anywhere = 0;
  MPI_Allreduce(&here, &anywhere, 1, MPI_INT, MPI_MAX, lmp->world);
  return anywhere != 0;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
