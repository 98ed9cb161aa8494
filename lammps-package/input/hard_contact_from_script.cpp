// SPDX-License-Identifier: GPL-2.0-only
#include "input/hard_contact_from_script.h"

#include "input/keyword_values.h"
#include "input/law_from_script.h"

using namespace LAMMPS_NS;

int LAMMPS_NS::read_hard_keyword(LAMMPS* lmp, const std::string& where, int at, int narg,
                                 char** arg, HardContact& c, SpecifiedKeywords& given) {
  const std::string word = arg[at];
  const bool well = word == "well";
  if (!well && word != "restitution" && word != "friction") return 0;
  double number[2] = {0.0, 0.0};
  const char* const usage = well ? "D ratio" : word == "friction" ? "mu" : "e";
  read_values(lmp, where, usage, 0, at, narg, arg, number);
  given.note(1 + well, arg + at);
  if (word == "restitution") {
    c.restitution = number[0];
  } else if (word == "friction") {
    c.friction = number[0];
  } else {
    c.well = cohesion::square_well::well(number[0], number[1]);
    c.has_well = true;
  }
  return 2 + well;
}

void LAMMPS_NS::require_valid(LAMMPS* lmp, const std::string& where, const HardContact& c,
                              const SpecifiedKeywords& given) {
  if (!given.has("restitution")) lmp->error->all(FLERR, where + ": give 'restitution e'");
  from_script(lmp, where, [&] {
    cohesion::hard_sphere::require_valid(c);
    return 0;
  });
}
