// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_PAIR_MEMBERS_H
#define COHESION_PAIR_MEMBERS_H

#include <string>
#include <vector>

#include "force.h"
#include "pair_hybrid.h"

namespace LAMMPS_NS {

struct PairMember {
  std::string style;
  Pair* pair;
};

/// The members of a hybrid style, which the engine keeps to its own classes; any other style by
/// itself; none where there is no pair style.
inline std::vector<PairMember> pair_members(const Force* force) {
  struct Hybrid : PairHybrid {
    static std::vector<PairMember> members(PairHybrid* hybrid) {
      std::vector<PairMember> all;
      for (int m = 0; m < hybrid->*&Hybrid::nstyles; m++)
        all.push_back({(hybrid->*&Hybrid::keywords)[m], (hybrid->*&Hybrid::styles)[m]});
      return all;
    }
  };
  if (!force->pair) return {};
  if (auto* const hybrid = dynamic_cast<PairHybrid*>(force->pair)) return Hybrid::members(hybrid);
  return {{force->pair_style, force->pair}};
}

}  // namespace LAMMPS_NS

#endif
