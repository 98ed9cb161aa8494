// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_CONTACT_FROM_SCRIPT_H
#define COHESION_HARD_CONTACT_FROM_SCRIPT_H

#include <string>

#include "given_keywords.h"
#include "hard_sphere/contact_parameters.h"
#include "lammps.h"

namespace LAMMPS_NS {

/// What a script says about the impacts of two materials.
struct HardContact : cohesion::hard_sphere::ContactParameters {
  bool well_given = false;  ///< a well, or none, in so many words
};

/// Reads one keyword of `restitution e [friction mu] [well D ratio]` at arg[at]; gives the number
/// of words it took, 0 when it is none of these.
int read_hard_keyword(LAMMPS*, const std::string& where, int at, int narg, char** arg, HardContact&,
                      GivenKeywords&);

/// Stops LAMMPS when the contact cannot be right.
void require_valid(LAMMPS*, const std::string& where, const HardContact&, const GivenKeywords&);

}  // namespace LAMMPS_NS

#endif
