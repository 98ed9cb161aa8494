// SPDX-License-Identifier: GPL-2.0-only
#include "common/bound_pairs.h"

#include "common/message.h"
#include "engine/pair_members.h"
#include "soft_contacts/cohesion_laws.h"

using namespace LAMMPS_NS;

std::vector<const BoundPairs*> LAMMPS_NS::bound_pairs(LAMMPS* lmp, const std::string& where) {
  std::vector<const BoundPairs*> sources;
  for (const PairMember& member : pair_members(lmp->force))
    if (const auto* source = dynamic_cast<const BoundPairs*>(member.pair))
      sources.push_back(source);
  if (sources.empty())
    stop(lmp, FLERR, where, ": no pair_style says which pairs are bound; use ",
         cohesive_pair_styles(), ", hamaker or hard/squarewell");
  return sources;
}
