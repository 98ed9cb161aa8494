// SPDX-License-Identifier: GPL-2.0-only
#include "hard_spheres/fix_wall_hard_square_well.h"

#include <cstring>

#include "atom.h"
#include "comm.h"
#include "engine/largest_radii.h"
#include "engine/particles_at_walls.h"
#include "error.h"
#include "force.h"
#include "hard_spheres/pair_hard_square_well.h"
#include "input/restart_format.h"
#include "input/wall_course_in_restart.h"
#include "input/walls_from_script.h"
#include "memory.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;

// The well of a plane is twice as deep as that of a sphere.
static constexpr double PLANE_OVER_SPHERE = 2.0;
// Relative overlap with a wall that causes a warning, over the diameter: larger than the rounding
// of a data file.
static constexpr double OVERLAP = 5e-7;

FixWallHardSquareWell::FixWallHardSquareWell(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg),
      message_prefix_(std::string("fix ") + arg[0] + " wall/hard/squarewell"),
      warned_(false) {
  read(narg, arg);
  restart_global = 1;
}

void FixWallHardSquareWell::read(int narg, char** arg) {
  WallsFromScript script_walls(lmp, message_prefix_);
  SpecifiedKeywords specified(lmp, message_prefix_);
  for (int at = 3; at < narg;) {
    const std::string word = arg[at];
    if (word == "well" && at + 1 < narg && strcmp(arg[at + 1], "off") == 0) {
      specified.note(1, arg + at);
      contact_.has_well = true;
      at += 2;
    } else if (const int words =
                   read_hard_keyword(lmp, message_prefix_, at, narg, arg, contact_, specified)) {
      at += words;
    } else if (const int wall = script_walls.read(narg - at, arg + at)) {
      at += wall;
    } else {
      error->all(FLERR, message_prefix_ + ": unknown keyword '" + word +
                            "'; valid ones: restitution, friction, well, " +
                            WallsFromScript::keywords);
    }
  }
  script_walls.finish();
  require_valid(lmp, message_prefix_, contact_, specified);
  walls_ = script_walls.walls;
  motion_ = script_walls.motion;
  course_ = cohesion::contact_solver::WallCourse(motion_);
}

int FixWallHardSquareWell::setmask() { return motion_.still() ? 0 : FixConst::INITIAL_INTEGRATE; }

void FixWallHardSquareWell::initial_integrate(int) { course_.begin_step(update->dt); }

void FixWallHardSquareWell::init() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, message_prefix_ + " acts on spheres; use 'atom_style sphere'");
  if (!PairHardSquareWell::in_use(force))
    error->all(FLERR, message_prefix_ + " goes with 'pair_style hard/squarewell'; give it first");
  const std::vector<double> largest = largest_radii(lmp);
  for (const auto& wall : walls_) {
    if (wall.shape != cohesion::contact_solver::Wall::z_cylinder) continue;
    for (int type = 1; type <= atom->ntypes; type++)
      if (ratio(type) * largest[type] >= wall.position)
        error->all(FLERR,
                   message_prefix_ +
                       ": zcylinder radius {} must be above {}, the reach of particles "
                       "of type {}",
                   wall.position, ratio(type) * largest[type], type);
  }
  const WallsAtStart start{walls_, course_.over({update->dt, 0.0}), groupbit, OVERLAP,
                           "it collides with the wall at once where it approaches it"};
  warned_ = warned_ ||
            warn_of_particles_at_walls(lmp, message_prefix_, start, [](int, int) { return true; });
}

HardWall FixWallHardSquareWell::wall(int w, double when) const {
  HardWall wall;
  wall.motion = {walls_[w], course_.over({update->dt, 0.0}), motion_.rim_speed, when};
  wall.group_bits = groupbit;
  wall.moves = !motion_.still();
  wall.by_material.resize(atom->ntypes + 1);
  for (int type = 1; type <= atom->ntypes; type++)
    wall.by_material[type] = {impact_law(type), ratio(type)};
  return wall;
}

const HardContact& FixWallHardSquareWell::pair_contact(int type) const {
  return PairHardSquareWell::in_use(force)->contact(type, type);
}

double FixWallHardSquareWell::ratio(int type) const {
  return contact_.has_well ? contact_.well.ratio_i : pair_contact(type).well.ratio_i;
}

ImpactLaw FixWallHardSquareWell::impact_law(int type) const {
  ImpactLaw law = contact_.law();
  if (!contact_.has_well) law.depth = PLANE_OVER_SPHERE * pair_contact(type).well.depth;
  return law;
}

/* ---------------------------------------------------------------------- */

// Entries of a restart file: its layout, the number of walls, and their motion.
static constexpr int LAYOUT = 1, COURSE = 2;

void FixWallHardSquareWell::write_restart(FILE* fp) {
  if (comm->me != 0) return;
  std::vector<double> values{RESTART_MARK + LAYOUT, static_cast<double>(walls_.size())};
  append_course(values, course_, walls_);
  const int bytes = static_cast<int>(values.size() * sizeof(double));
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(values.data(), sizeof(double), values.size(), fp);
}

void FixWallHardSquareWell::restart(char* buf) {
  const auto* values = reinterpret_cast<const double*>(buf);
  require_layout(lmp, values[0], message_prefix_, LAYOUT);
  if (values[1] != static_cast<double>(walls_.size()))
    error->all(FLERR,
               message_prefix_ + ": other walls than in the restart file; give the fix another ID");
  course_ = continued_course(lmp, message_prefix_, course_, walls_, values + COURSE);
}
