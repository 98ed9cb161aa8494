// SPDX-License-Identifier: GPL-2.0-only
#include "input/walls_from_script.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "domain.h"
#include "error.h"
#include "input/law_from_script.h"
#include "utils.h"

using namespace LAMMPS_NS;
using cohesion::Vector3;
using cohesion::contact_solver::Wall;

static constexpr char AXES[] = "xyz";

static double& component(Vector3& a, int axis) { return axis == 0 ? a.x : axis == 1 ? a.y : a.z; }

double WallsFromScript::number(const char* text) const {
  return utils::numeric(FLERR, text, false, lmp_);
}

int WallsFromScript::read(int narg, char** arg) {
  const std::string word = arg[0];
  if (const int planes = read_planes(narg, arg)) return planes;
  if (word == "zcylinder") return read_cylinder(narg - 1, arg + 1);
  if (word == "region") {
    read_region(narg - 1, arg + 1);
    return 2;
  }
  if (word != "wiggle" && word != "shear" && word != "translate") return 0;
  const int moves = word == "wiggle" ? 3 : 2;
  if (narg <= moves)
    lmp_->error->all(FLERR, where_ + ": " + word +
                                (moves == 3 ? " takes a dimension, an amplitude and a period"
                                            : " takes a dimension and a speed"));
  if (motion_words_) lmp_->error->all(FLERR, where_ + ": one of wiggle, shear and translate only");
  motion_words_ = arg;
  return 1 + moves;
}

void WallsFromScript::finish() {
  if (walls.empty() && regions.empty())
    lmp_->error->all(
        FLERR,
        where_ + ": no wall; give 'xplane lo hi', 'yplane lo hi', 'zplane lo hi'" +
            (accepts_regions_ ? ", 'zcylinder radius' or 'region ID'" : " or 'zcylinder radius'"));
  if (motion_words_) read_motion(motion_words_);
  from_script(lmp_, where_, [this] {
    require_valid(motion);
    return 0;
  });
}

void WallsFromScript::read_region(int narg, char** arg) {
  if (!accepts_regions_)
    lmp_->error->all(FLERR,
                     where_ +
                         ": a region cannot be its wall; it accepts planes and zcylinder, and "
                         "particles that nothing moves make any other shape");
  if (narg < 1) lmp_->error->all(FLERR, where_ + ": region: specify the ID of a region");
  if (std::find(regions.begin(), regions.end(), arg[0]) != regions.end())
    lmp_->error->all(FLERR, where_ + ": region " + arg[0] + " twice; give each region once");
  regions.emplace_back(arg[0]);
}

void WallsFromScript::read_motion(char** words) {
  const std::string word = words[0], dim = words[1];
  const auto axis = std::string(AXES).find(dim);
  if (dim.size() != 1 || axis == std::string::npos)
    lmp_->error->all(FLERR,
                     where_ + ": " + word + " takes a dimension x, y or z, not '" + dim + "'");
  const auto is_cylinder = [](const Wall& wall) { return wall.shape == Wall::z_cylinder; };
  const auto cylinders = std::count_if(walls.begin(), walls.end(), is_cylinder);
  if (word == "shear" && !regions.empty())
    lmp_->error->all(FLERR, where_ +
                                ": shear moves a wall along itself, which the faces of a region do "
                                "not allow; use translate, or a fix of its own for the region");
  if (word == "wiggle") {
    component(motion.amplitude, axis) = number(words[2]);
    motion.period = number(words[3]);
  } else if (word == "shear" && cylinders > 0 && axis < 2) {
    motion.rim_speed = number(words[2]);
    if (cylinders < static_cast<int>(walls.size()))
      lmp_->error->all(
          FLERR, where_ + ": shear " + dim + " turns a zcylinder; give planes a fix of their own");
    return;
  } else {
    component(motion.velocity, axis) = number(words[2]);
  }
  for (const Wall& wall : walls) {
    if (is_cylinder(wall) && axis < 2)
      lmp_->error->all(FLERR,
                       where_ + ": " + word + " " + dim + ": a zcylinder moves along z only");
    if (word == "shear" && wall.shape == static_cast<Wall::Shape>(axis))
      lmp_->error->all(FLERR, where_ + ": shear " + dim + " is across a " + dim +
                                  "plane, not along it; use translate");
  }
}

int WallsFromScript::read_cylinder(int narg, char** arg) {
  if (narg < 1) lmp_->error->all(FLERR, where_ + ": zcylinder takes a radius");
  const double radius = number(arg[0]);
  if (!(std::isfinite(radius) && radius > 0.0))
    lmp_->error->all(FLERR, where_ + ": zcylinder radius " + arg[0] +
                                " must be a finite number greater than zero");
  if (lmp_->domain->periodicity[0] || lmp_->domain->periodicity[1])
    lmp_->error->all(FLERR, where_ +
                                ": no zcylinder in a periodic direction; use 'boundary f f' in x "
                                "and y");
  walls.push_back({Wall::z_cylinder, 1.0, radius});
  return 2;
}

int WallsFromScript::read_planes(int narg, char** arg) {
  const std::string word = arg[0];
  if (word != "xplane" && word != "yplane" && word != "zplane") return 0;
  if (narg < 3)
    lmp_->error->all(FLERR, where_ + ": " + word + " takes two positions, NULL for no wall");
  const int dimension = word[0] - 'x';
  if (lmp_->domain->periodicity[dimension])
    lmp_->error->all(FLERR,
                     where_ + ": no " + word + " in a periodic direction; use 'boundary f' there");
  const bool lower = strcmp(arg[1], "NULL") != 0, upper = strcmp(arg[2], "NULL") != 0;
  if (!lower && !upper)
    lmp_->error->all(FLERR, where_ + ": " + word + " NULL NULL is no wall; give a position");
  if (lower) add_plane(dimension, 1.0, word, arg[1]);
  if (upper) add_plane(dimension, -1.0, word, arg[2]);
  const auto count = walls.size();
  if (lower && upper && !(walls[count - 2].position < walls[count - 1].position))
    lmp_->error->all(FLERR, where_ + ": " + word + " " + arg[1] + " " + arg[2] +
                                ": the first position must be below the second");
  return 3;
}

void WallsFromScript::add_plane(int dimension, double side, const std::string& word,
                                const char* text) {
  const double position = number(text);
  if (!std::isfinite(position))
    lmp_->error->all(FLERR, where_ + ": " + word + " position " + text + " must be finite");
  walls.push_back({static_cast<Wall::Shape>(dimension), side, position});
}
