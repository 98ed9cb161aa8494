// SPDX-License-Identifier: GPL-2.0-only
#include "input/hard_contact_from_script.h"

#include "input/law_from_script.h"
#include "utils.h"

using namespace LAMMPS_NS;

int LAMMPS_NS::read_hard_keyword(LAMMPS* lmp, const std::string& where, int at, int narg,
                                 char** arg, HardContact& c, SpecifiedKeywords& given) {
  const std::string word = arg[at];
  const bool well = word == "well";
  if (!well && word != "restitution" && word != "friction") return 0;
  if (at + 1 + well >= narg)
    lmp->error->all(FLERR, where + ": " + word +
                               (well ? " takes a depth and a ratio r_out/r" : " takes a number"));
  given.note(1 + well, arg + at);
  const auto number = [&](int n) { return utils::numeric(FLERR, arg[at + n], false, lmp); };
  if (word == "restitution") {
    c.restitution = number(1);
  } else if (word == "friction") {
    c.friction = number(1);
  } else {
    c.well = cohesion::square_well::well(number(1), number(2));
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
