// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

// What gas_coupling_engine.h says to LIGGGHTS in other words than to LAMMPS.

/// The styles are linked to the test.
inline std::vector<std::string> load_styles() { return {}; }

/// For spheres that exert no forces on each other.
inline std::vector<std::string> no_contacts() {
  std::vector<std::string> lines{"communicate single vel yes"};
  for (const std::string name : {"kn", "kt", "gamman", "gammat"})
    lines.push_back("fix " + name + " all property/global " + name + " peratomtypepair 2 0 0 0 0");
  lines.insert(lines.end(),
               {"pair_style gran model hooke/stiffness tangential off", "pair_coeff * *"});
  return lines;
}
