// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_WALL_COURSE_IN_RESTART_H
#define COHESION_WALL_COURSE_IN_RESTART_H

#include <algorithm>
#include <string>
#include <vector>

#include "contact_solver/wall.h"
#include "error.h"
#include "lammps.h"

// What restart files hold of the motion of walls: how far it has come, and where the script had the
// walls at first.

namespace LAMMPS_NS {

using Walls = std::vector<cohesion::contact_solver::Wall>;

static constexpr int NUMBERS_OF_A_PLACE = 3;

inline int size_of_course(const Walls& walls) {
  return cohesion::contact_solver::WallCourse::NUMBERS +
         NUMBERS_OF_A_PLACE * static_cast<int>(walls.size());
}

inline void append_course(std::vector<double>& values,
                          const cohesion::contact_solver::WallCourse& course, const Walls& walls) {
  const auto numbers = course.numbers();
  values.insert(values.end(), numbers.begin(), numbers.end());
  for (const auto& wall : walls)
    values.insert(values.end(), {static_cast<double>(wall.shape), wall.side, wall.position});
}

/// The course of a script's walls when it goes on from what append_course() wrote of as many walls.
/// Stops LAMMPS, with `where` in front of the message, where these had other places.
inline cohesion::contact_solver::WallCourse continued_course(
    LAMMPS* lmp, const std::string& where, cohesion::contact_solver::WallCourse course,
    const Walls& walls, const double* values) {
  using cohesion::contact_solver::WallCourse;
  const double* place = values + WallCourse::NUMBERS;
  for (const auto& wall : walls) {
    if (place[0] != static_cast<double>(wall.shape) || place[1] != wall.side ||
        place[2] != wall.position)
      lmp->error->all(
          FLERR,
          where +
              ": its restart file has this wall at {}, the script at {}. A wall goes on "
              "from where its motion has led it: write the positions as in the script "
              "of the first run, or give the fix another ID for walls elsewhere",
          place[2], wall.position);
    place += NUMBERS_OF_A_PLACE;
  }
  WallCourse::Numbers numbers;
  std::copy_n(values, numbers.size(), numbers.begin());
  course.continue_from(numbers);
  return course;
}

}  // namespace LAMMPS_NS

#endif
