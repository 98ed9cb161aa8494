// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_PAIR_MEMBERS_H
#define COHESION_PAIR_MEMBERS_H

#include <algorithm>
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

/// The members of a hybrid style that act between types i and j; empty for any other style.
inline std::vector<PairMember> pair_members_between(const Force* force, int i, int j) {
  struct Hybrid : PairHybrid {
    static std::vector<int> members(PairHybrid* hybrid, int i, int j) {
      const int* const all = (hybrid->*&Hybrid::map)[i][j];
      return {all, all + (hybrid->*&Hybrid::nmap)[i][j]};
    }
  };
  auto* const hybrid = dynamic_cast<PairHybrid*>(force->pair);
  if (!hybrid) return {};
  const std::vector<PairMember> all = pair_members(force);
  std::vector<PairMember> between;
  for (int m : Hybrid::members(hybrid, std::min(i, j), std::max(i, j))) between.push_back(all[m]);
  return between;
}

}  // namespace LAMMPS_NS

#endif
