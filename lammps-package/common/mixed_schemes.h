// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_MIXED_SCHEMES_H
#define COHESION_MIXED_SCHEMES_H

#include <string>

namespace LAMMPS_NS {

/// Warning of a wall whose contacts are integrated by another scheme than those of the pair style.
/// wall_is_exact: the wall has scheme exact, the pair style scheme sampled; else the reverse.
/// by_default: what the scheme is without the keyword.
inline std::string mixed_schemes(const std::string& wall, const std::string& pairs,
                                 bool wall_is_exact, const std::string& by_default) {
  const std::string exact = "'scheme exact'", sampled = "'scheme sampled'";
  return wall + " has " + (wall_is_exact ? exact : sampled) + ", and " + pairs + " has " +
         (wall_is_exact ? sampled : exact) +
         ": a particle sticks to the wall and to another particle by different criteria, since "
         "that of scheme sampled depends on the time step; give both the same scheme (" +
         by_default + ")";
}

}  // namespace LAMMPS_NS

#endif
