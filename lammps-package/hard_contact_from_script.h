// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_CONTACT_FROM_SCRIPT_H
#define COHESION_HARD_CONTACT_FROM_SCRIPT_H

#include <string>

#include "hard_sphere/impact.h"
#include "lammps.h"
#include "square_well/parameters.h"

namespace LAMMPS_NS {

/// What a script says about the impacts of two materials.
struct HardContact {
  double restitution = 1.0;
  double friction = 0.0;
  cohesion::square_well::Parameters well;
  bool well_given = false;  ///< a well, or none, in so many words

  cohesion::hard_sphere::Law law() const { return {restitution, friction, well.depth}; }
};

/// Reads one keyword of `restitution e [friction mu] [well D ratio]` at arg[at]; gives the number
/// of words it took, 0 when it is none of these.
int read_hard_keyword(LAMMPS*, const std::string& where, int at, int narg, char** arg, HardContact&,
                      bool& has_restitution);

/// Stops LAMMPS when the contact cannot be right.
void require_valid(LAMMPS*, const std::string& where, const HardContact&, bool has_restitution);

/// Unlike materials: geometric means of restitution and friction; the well as square_well::mixed.
HardContact mixed(const HardContact&, const HardContact&);

}  // namespace LAMMPS_NS

#endif
