// SPDX-License-Identifier: GPL-2.0-only
// What a script says of fix bubbles.
#include "atom.h"
#include "bubbles/fix_bubbles.h"
#include "common/message.h"
#include "common/specified_keywords.h"
#include "domain.h"
#include "input/law_from_script.h"
#include "update.h"
#include "utils.h"

using namespace LAMMPS_NS;

FixBubbles::FixBubbles(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg),
      where(std::string("fix ") + id + " bubbles"),
      last_step(update->ntimestep) {
  if (narg < 4) stop(lmp, FLERR, where, " takes 'N', every so many steps, and keywords");
  nevery = utils::inumeric(FLERR, arg[3], false, lmp);
  if (nevery < 1) stop(lmp, FLERR, where, ": N is ", nevery, "; it must be 1 or more");
  read_keywords(narg, arg);
  if (!atom->tag_enable || !atom->radius_flag || !atom->rmass_flag)
    stop(lmp, FLERR, where, " needs spheres with IDs, for instance 'atom_style sphere'");
  if (domain->triclinic) stop(lmp, FLERR, where, " needs a box that is not tilted");
  force_reneighbor = 1;
  next_reneighbor = update->ntimestep + nevery;
  vector_flag = 1;
  size_vector = 9;
  extvector = 1;
  global_freq = 1;
  restart_global = 1;
}

int FixBubbles::read_nozzles(int at, int narg, char** arg) {
  constexpr int values = 8;
  if (at + values >= narg)
    stop(
        lmp, FLERR, where,
        ": 'nozzles' takes 'NX NY x y z spacing Q d': their numbers along x and y,"
        " where the middle of them is, how far apart they are, the volume flow of all, the diameter"
        " of the bubbles");
  double value[values];
  for (int k = 0; k < values; k++)
    value[k] = k < 2 ? utils::inumeric(FLERR, arg[at + 1 + k], false, lmp)
                     : utils::numeric(FLERR, arg[at + 1 + k], false, lmp);
  nozzles = from_script(lmp, where, [&] {
    cohesion::require_positive("diameter of the bubbles", value[7]);
    return cohesion::bubbles::Nozzles(static_cast<int>(value[0]), static_cast<int>(value[1]),
                                      {value[2], value[3], value[4]}, value[5], value[6],
                                      cohesion::sphere_volume(0.5 * value[7]));
  });
  return values;
}

void FixBubbles::read_keywords(int narg, char** arg) {
  SpecifiedKeywords given(lmp, where);
  double grown = 0.0;  // diameter; 0: none grow
  const auto number = [&](int at) {
    if (at >= narg) stop(lmp, FLERR, where, ": keyword '", arg[at - 1], "' takes a value");
    return utils::numeric(FLERR, arg[at], false, lmp);
  };
  const auto positive = [&](int at) {
    const double value = number(at);
    if (!(value > 0.0))
      stop(lmp, FLERR, where, ": ", arg[at - 1], " ", value, "; it must be greater than zero");
    return value;
  };
  for (int i = 4; i < narg;) {
    const std::string word = arg[i];
    int values = 1;
    if (word == "nozzles") {
      values = read_nozzles(i, narg, arg);
    } else if (word == "density") {
      rules.density = positive(i + 1);
    } else if (word == "velocity") {
      rules.velocity.z = number(i + 1);
    } else if (word == "type") {
      type = static_cast<int>(number(i + 1));
    } else if (word == "grow") {
      grown = positive(i + 1);
    } else if (word == "top") {
      rules.top = number(i + 1);
    } else if (word == "merge") {
      rules.merge_up_to = positive(i + 1);
    } else if (word == "break") {
      values = 2;
      rules.break_above = positive(i + 1);
      rules.rest = number(i + 2);
      if (rules.rest < 0.0)
        stop(lmp, FLERR, where, ": break rests ", rules.rest, "; not below zero");
    } else {
      stop(lmp, FLERR, where, ": unknown keyword '", word,
           "'; it takes nozzles, density, velocity, type, grow, top, merge and break");
    }
    given.note(values, arg + i);
    i += 1 + values;
  }
  if (nozzles && !(rules.density > 0.0))
    stop(lmp, FLERR, where, ": nozzles need the 'density' of their bubbles, greater than zero");
  if (grown > 0.0) {
    if (!nozzles) stop(lmp, FLERR, where, ": 'grow' is of the bubbles of nozzles; there are none");
    from_script(lmp, where, [&] {
      nozzles->grow_up_to(cohesion::sphere_volume(0.5 * grown));
      return 0;
    });
  }
  if (type < 1 || type > atom->ntypes)
    stop(lmp, FLERR, where, ": type ", type, "; the box has types 1 to ", atom->ntypes);
}
