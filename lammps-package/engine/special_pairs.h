// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_SPECIAL_PAIRS_H
#define COHESION_SPECIAL_PAIRS_H

#include <string>

#include "lammps.h"

namespace LAMMPS_NS {

/// The factors of special_bonds for the pairs of this style: of bonded particles, and of those two
/// and three bonds apart, at 1 to 3. Those of a hybrid style's pair_modify, where it has them.
const double* special_factors(const LAMMPS*, const class Pair*);

/// Stops at a factor between 0 and 1: a contact is there or not. With `by_list` also where the
/// list of neighbours of the run has other pairs than those of factor 1. `where` stands in front of
/// the message.
void require_whole_special_factors(const LAMMPS*, const Pair*, const std::string& where,
                                   bool by_list);

}  // namespace LAMMPS_NS

#endif
