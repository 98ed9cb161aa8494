// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_WALLS_FROM_SCRIPT_H
#define COHESION_WALLS_FROM_SCRIPT_H

#include <string>
#include <vector>

#include "contact_solver/wall.h"
#include "lammps.h"

namespace LAMMPS_NS {

/// Reads the walls of a fix and their motion:
/// `xplane lo hi | yplane lo hi | zplane lo hi | zcylinder R | region ID`, one or more, `region`
/// only of a fix that accepts regions, and at most one of `wiggle dim amplitude period | shear dim
/// v | translate dim v`. Stops LAMMPS, with `where` in front of the message, at what cannot be
/// right.
class WallsFromScript {
 public:
  static constexpr char keywords[] = "xplane, yplane, zplane, zcylinder, wiggle, shear, translate";
  static constexpr char keywords_with_region[] =
      "xplane, yplane, zplane, zcylinder, region, wiggle, shear, translate";

  enum class Regions { refused, accepted };

  WallsFromScript(LAMMPS* lmp, std::string where, Regions use = Regions::refused)
      : lmp_(lmp), where_(std::move(where)), accepts_regions_(use == Regions::accepted) {}

  /// Reads the keyword arg[0] with its values; returns the number of words that belong to it, 0
  /// when it is none of these.
  int read(int narg, char** arg);
  /// The same of a fix that has planes alone.
  int read_planes(int narg, char** arg);
  /// Checks the walls and their motion, after the last keyword.
  void finish();

  std::vector<cohesion::contact_solver::Wall> walls;
  std::vector<std::string> regions;  // their IDs
  cohesion::contact_solver::WallMotion motion;

 private:
  double number(const char* text) const;
  int read_cylinder(int narg, char** arg);
  void read_motion(char** words);
  void read_region(int narg, char** arg);
  void add_plane(int dimension, double side, const std::string& word, const char* text);

  LAMMPS* lmp_;
  std::string where_;
  bool accepts_regions_;
  char** motion_words_ = nullptr;
};

}  // namespace LAMMPS_NS

#endif
