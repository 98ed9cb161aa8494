// SPDX-License-Identifier: GPL-2.0-only
#include "bound_pairs.h"

#include "cohesion_laws.h"
#include "message.h"
#include "pair_members.h"

using namespace LAMMPS_NS;

std::vector<const BoundPairs*> LAMMPS_NS::bound_pairs(LAMMPS* lmp, const std::string& where) {
  std::vector<const BoundPairs*> sources;
  for (const PairMember& member : pair_members(lmp->force))
    if (const auto* source = dynamic_cast<const BoundPairs*>(member.pair))
      sources.push_back(source);
  if (sources.empty())
    stop(lmp, FLERR, where, ": no pair_style says which pairs are bound; use ",
         cohesive_pair_styles(), ", hamaker or hard/square_well");
  return sources;
}
