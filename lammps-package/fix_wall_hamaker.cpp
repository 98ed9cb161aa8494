// SPDX-License-Identifier: GPL-2.0-only
#include "fix_wall_hamaker.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "law_from_script.h"

using namespace LAMMPS_NS;
using namespace FixConst;

static cohesion::hamaker::SmallGap read_law(LAMMPS* lmp, int narg, char** arg) {
  if (narg < 9)
    lmp->error->all(FLERR,
                    "fix wall/hamaker takes 'A H_cut H_out' and at least one plane, 'xplane "
                    "lo hi', 'yplane lo hi' or 'zplane lo hi', NULL for no wall on a side");
  return hamaker_from_script(
      lmp, std::string("fix ") + arg[0] + " wall/hamaker",
      {utils::numeric(FLERR, arg[3], false, lmp), utils::numeric(FLERR, arg[4], false, lmp),
       utils::numeric(FLERR, arg[5], false, lmp)});
}

FixWallHamaker::FixWallHamaker(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg), law(read_law(lammps, narg, arg)), summed(false) {
  read_planes(narg, arg);
  std::fill_n(mine, 4, 0.0);
  scalar_flag = vector_flag = 1;
  size_vector = 3;
  extscalar = extvector = 1;
  global_freq = 1;
  energy_global_flag = 1;
  virial_global_flag = virial_peratom_flag = 1;
}

void FixWallHamaker::read_planes(int narg, char** arg) {
  for (int iarg = 6; iarg < narg; iarg += 3) {
    const std::string word = arg[iarg];
    const int dimension = word == "xplane" ? 0 : word == "yplane" ? 1 : word == "zplane" ? 2 : -1;
    if (dimension < 0)
      error->all(FLERR, "fix wall/hamaker: unknown keyword '" + word +
                            "'; valid ones: xplane, yplane, zplane");
    if (iarg + 2 >= narg)
      error->all(FLERR, "fix wall/hamaker: " + word + " takes two positions, NULL for no wall");
    if (domain->periodicity[dimension])
      error->all(FLERR, "fix wall/hamaker: no " + word +
                            " in a periodic direction; use 'boundary f' there");
    add_plane(dimension, 1, word, arg[iarg + 1]);
    add_plane(dimension, -1, word, arg[iarg + 2]);
    if (strcmp(arg[iarg + 1], "NULL") == 0 && strcmp(arg[iarg + 2], "NULL") == 0)
      error->all(FLERR, "fix wall/hamaker: " + word + " NULL NULL is no wall; give a position");
    const auto count = planes.size();
    if (strcmp(arg[iarg + 1], "NULL") != 0 && strcmp(arg[iarg + 2], "NULL") != 0 &&
        !(planes[count - 2].position < planes[count - 1].position))
      error->all(FLERR, "fix wall/hamaker: " + word + " " + arg[iarg + 1] + " " + arg[iarg + 2] +
                            ": the first position must be below the second");
  }
}

void FixWallHamaker::add_plane(int dimension, int side, const std::string& word, char* text) {
  if (strcmp(text, "NULL") == 0) return;
  const double position = utils::numeric(FLERR, text, false, lmp);
  if (!std::isfinite(position))
    error->all(FLERR, "fix wall/hamaker: " + word + " position " + text + " must be finite");
  planes.push_back({dimension, side, position});
}

int FixWallHamaker::setmask() { return POST_FORCE | MIN_POST_FORCE; }

void FixWallHamaker::init() {
  if (!atom->radius_flag)
    error->all(FLERR,
               "fix wall/hamaker acts on spheres and needs an atom style with radii, for "
               "instance 'atom_style sphere'");
}

void FixWallHamaker::setup(int vflag) { post_force(vflag); }
void FixWallHamaker::min_setup(int vflag) { post_force(vflag); }
void FixWallHamaker::min_post_force(int vflag) { post_force(vflag); }

void FixWallHamaker::post_force(int vflag) {
  v_init(vflag);
  std::fill_n(mine, 4, 0.0);
  summed = false;
  for (const Plane& plane : planes) {
    const int d = plane.dimension;
    for (int i = 0; i < atom->nlocal; i++) {
      if (!(atom->mask[i] & groupbit)) continue;
      const double distance = plane.side * (atom->x[i][d] - plane.position);
      const double gap = distance - atom->radius[i];
      if (gap >= law.outer_cutoff() || distance < 0.0) continue;
      // For a plane the reduced radius is the radius of the sphere.
      const double pull = plane.side * law.force(gap, atom->radius[i]);
      atom->f[i][d] -= pull;
      mine[0] += law.energy(gap, atom->radius[i]);
      mine[1 + d] += pull;
      if (evflag) v_tally(d, i, -pull * atom->x[i][d]);
    }
  }
}

void FixWallHamaker::sum() {
  if (!summed) MPI_Allreduce(mine, total, 4, MPI_DOUBLE, MPI_SUM, world);
  summed = true;
}

/// Energy of all particles with the walls.
double FixWallHamaker::compute_scalar() {
  sum();
  return total[0];
}

/// Force on the walls.
double FixWallHamaker::compute_vector(int n) {
  sum();
  return total[1 + n];
}
