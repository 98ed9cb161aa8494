// SPDX-License-Identifier: GPL-2.0-only
#include "fix_wall_hard_square_well.h"

#include <algorithm>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "largest_radii.h"
#include "memory.h"
#include "pair_hard_square_well.h"
#include "update.h"
#include "walls_from_script.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;

// A plane attracts twice as strongly as a sphere.
static constexpr double PLANE_OVER_SPHERE = 2.0;

FixWallHardSquareWell::FixWallHardSquareWell(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg),
      where_(std::string("fix ") + arg[0] + " wall/hard/square_well"),
      time_origin_(update->ntimestep),
      inside_(nullptr) {
  read(narg, arg);
  restart_peratom = restart_global = 1;
  create_attribute = 1;
  time_depend = !motion_.still();
  FixWallHardSquareWell::grow_arrays(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++) FixWallHardSquareWell::set_arrays(i);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixWallHardSquareWell::~FixWallHardSquareWell() {
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  memory->destroy(inside_);
}

void FixWallHardSquareWell::read(int narg, char** arg) {
  WallsFromScript from_words(lmp, where_);
  GivenKeywords given(lmp, where_);
  for (int at = 3; at < narg;) {
    const std::string word = arg[at];
    if (word == "well" && at + 1 < narg && strcmp(arg[at + 1], "off") == 0) {
      given.note(1, arg + at);
      contact_.well_given = true;
      at += 2;
    } else if (const int taken = read_hard_keyword(lmp, where_, at, narg, arg, contact_, given)) {
      at += taken;
    } else if (const int wall = from_words.read(narg - at, arg + at)) {
      at += wall;
    } else {
      error->all(FLERR, where_ + ": unknown keyword '" + word +
                            "'; valid ones: restitution, friction, well, " +
                            WallsFromScript::keywords);
    }
  }
  from_words.finish();
  require_valid(lmp, where_, contact_, given);
  walls_ = from_words.walls;
  motion_ = from_words.motion;
}

int FixWallHardSquareWell::setmask() { return 0; }

void FixWallHardSquareWell::init() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, where_ + " acts on spheres; use 'atom_style sphere'");
  if (!force->pair_match("hard/square_well", 1))
    error->all(FLERR, where_ + " goes with 'pair_style hard/square_well'; give it first");
  const std::vector<double> largest = largest_radii(lmp);
  for (const auto& wall : walls_) {
    if (wall.shape != cohesion::event_stepping::Wall::z_cylinder) continue;
    for (int type = 1; type <= atom->ntypes; type++)
      if (ratio(type) * largest[type] >= wall.position)
        error->all(FLERR,
                   where_ +
                       ": zcylinder radius {} must be above {}, the reach of particles "
                       "of type {}",
                   wall.position, ratio(type) * largest[type], type);
  }
}

bool FixWallHardSquareWell::acts_on(int i) const { return atom->mask[i] & groupbit; }

MovingWall FixWallHardSquareWell::over_step(int w) const {
  const double time = static_cast<double>(update->ntimestep - time_origin_) * update->dt;
  return {walls_[w], motion_.over(time, {update->dt, 0.0}), motion_.rim_speed};
}

const HardContact& FixWallHardSquareWell::pair_contact(int type) const {
  return dynamic_cast<PairHardSquareWell*>(force->pair_match("hard/square_well", 1))
      ->contact_of_types(type, type);
}

double FixWallHardSquareWell::ratio(int type) const {
  return contact_.well_given ? contact_.well.ratio_i : pair_contact(type).well.ratio_i;
}

Law FixWallHardSquareWell::law_of_type(int type) const {
  Law law = contact_.law();
  if (!contact_.well_given) law.depth = PLANE_OVER_SPHERE * pair_contact(type).well.depth;
  return law;
}

Surfaces FixWallHardSquareWell::surfaces_of(int i) const {
  const double radius = atom->radius[i];
  const int type = atom->type[i];
  return {radius, law_of_type(type).depth > 0.0 ? ratio(type) * radius : radius};
}

/* ---------------------------------------------------------------------- */

void FixWallHardSquareWell::grow_arrays(int nmax) {
  memory->grow(inside_, nmax, size(), "wall/hard/square_well:inside");
}

void FixWallHardSquareWell::copy_arrays(int i, int j, int) {
  std::copy_n(inside_[i], size(), inside_[j]);
}

void FixWallHardSquareWell::set_arrays(int i) { std::fill_n(inside_[i], size(), -1.0); }

int FixWallHardSquareWell::pack_exchange(int i, double* buf) {
  std::copy_n(inside_[i], size(), buf);
  return size();
}

int FixWallHardSquareWell::unpack_exchange(int i, double* buf) {
  std::copy_n(buf, size(), inside_[i]);
  return size();
}

/// Time origin of the motion, and how many walls there were.
void FixWallHardSquareWell::write_restart(FILE* fp) {
  if (comm->me != 0) return;
  const double values[] = {static_cast<double>(time_origin_), static_cast<double>(size())};
  const int bytes = sizeof(values);
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(values, sizeof(double), 2, fp);
}

void FixWallHardSquareWell::restart(char* buf) {
  double values[2];
  memcpy(values, buf, sizeof(values));
  if (values[1] != size())
    error->all(FLERR, where_ + ": other walls than in the restart file; give the fix another ID");
  time_origin_ = static_cast<bigint>(values[0]);
}

int FixWallHardSquareWell::pack_restart(int i, double* buf) {
  buf[0] = size_restart(i);
  return 1 + pack_exchange(i, buf + 1);
}

void FixWallHardSquareWell::unpack_restart(int i, int nth) {
  double* const values = atom->extra[i];
  int m = 0;
  for (int n = 0; n < nth; n++) m += static_cast<int>(values[m]);
  unpack_exchange(i, values + m + 1);
}

int FixWallHardSquareWell::maxsize_restart() { return size_restart(0); }
int FixWallHardSquareWell::size_restart(int) { return 1 + size(); }

double FixWallHardSquareWell::memory_usage() {
  return static_cast<double>(sizeof(double)) * size() * atom->nmax;
}
