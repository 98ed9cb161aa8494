// SPDX-License-Identifier: GPL-2.0-only
#include "fix_wall_hard_square_well.h"

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
      time_origin_(update->ntimestep) {
  read(narg, arg);
  restart_global = 1;
  time_depend = !motion_.still();
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

HardWall FixWallHardSquareWell::wall(int w, double when) const {
  const double time = static_cast<double>(update->ntimestep - time_origin_) * update->dt;
  HardWall wall;
  wall.moving = {walls_[w], motion_.over(time, {update->dt, 0.0}), motion_.rim_speed, when};
  wall.groups = groupbit;
  wall.moves = !motion_.still();
  wall.of_kind.resize(atom->ntypes + 1);
  for (int type = 1; type <= atom->ntypes; type++)
    wall.of_kind[type] = {law_of_type(type), ratio(type)};
  return wall;
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

/* ---------------------------------------------------------------------- */

/// Time origin of the motion, and how many walls there were.
void FixWallHardSquareWell::write_restart(FILE* fp) {
  if (comm->me != 0) return;
  const double values[] = {static_cast<double>(time_origin_), static_cast<double>(walls_.size())};
  const int bytes = sizeof(values);
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(values, sizeof(double), 2, fp);
}

void FixWallHardSquareWell::restart(char* buf) {
  double values[2];
  memcpy(values, buf, sizeof(values));
  if (values[1] != static_cast<double>(walls_.size()))
    error->all(FLERR, where_ + ": other walls than in the restart file; give the fix another ID");
  time_origin_ = static_cast<bigint>(values[0]);
}
