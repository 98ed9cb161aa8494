// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_CONTACT_FROM_SCRIPT_H
#define COHESION_HARD_CONTACT_FROM_SCRIPT_H

#include <string>

#include "common/specified_keywords.h"
#include "hard_sphere/hard_contact_parameters.h"
#include "lammps.h"

namespace LAMMPS_NS {

/// The impacts of two materials as a script gives them.
struct HardContact : cohesion::hard_sphere::HardContactParameters {
  bool has_well = false;  ///< the script gives a well, or `well off`
};

/// Reads one keyword of `restitution e [friction mu] [well D ratio]` at arg[at]; returns the number
/// of words that belong to it, 0 when it is none of these.
int read_hard_keyword(LAMMPS*, const std::string& where, int at, int narg, char** arg, HardContact&,
                      SpecifiedKeywords&);

/// Stops LAMMPS when a parameter is out of its bounds, or restitution is not given.
void require_valid(LAMMPS*, const std::string& where, const HardContact&, const SpecifiedKeywords&);

}  // namespace LAMMPS_NS

#endif
