// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

// What gas_coupling_engine.h says to LAMMPS in other words than to LIGGGHTS.

inline std::vector<std::string> load_styles() {
  return {std::string("plugin load ") + std::getenv("COHESION_PLUGIN")};
}

/// For spheres that exert no forces on each other.
inline std::vector<std::string> no_contacts() {
  return {"pair_style hamaker cutoff 4e-10 1e-7", "pair_coeff * * hamaker 0"};
}
