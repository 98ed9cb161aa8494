// SPDX-License-Identifier: GPL-2.0-only
#include "outputs/compute_gran_stress.h"

#include <algorithm>

#include "comm.h"
#include "contact_step/fix_contact_step.h"
#include "contact_step/soft_contact_style.h"
#include "engine/pair_members.h"
#include "error.h"
#include "soft_contacts/cohesion_laws.h"

using namespace LAMMPS_NS;

ComputeGranStress::ComputeGranStress(LAMMPS* lammps, int narg, char** arg)
    : ComputeFluxTotals(lammps, narg, arg, cohesion::contact_solver::FluxParts::parts),
      step(FixContactStep::of(lammps)) {
  reader = step->add_flux_reader();
  before = step->flux();
}

/// Totals that stay 0 beside other pairs would be taken for a stress of 0.
void ComputeGranStress::init() {
  const std::vector<PairMember> members = pair_members(force);
  const auto known = [](const PairMember& member) {
    return dynamic_cast<const SoftContactStyle*>(member.pair) != nullptr;
  };
  if (members.empty()) return;
  if (std::none_of(members.begin(), members.end(), known))
    error->all(FLERR, "compute {} gran/stress does not know what pair_style {} carries; it sums {}",
               id, force->pair_style, cohesive_pair_styles());
  for (const PairMember& member : members)
    if (!known(member) && comm->me == 0)
      error->warning(FLERR,
                     "compute {} gran/stress leaves pair_style {} out: it does not know what that "
                     "carries",
                     id, member.style);
}

const cohesion::MomentumFlux* ComputeGranStress::totals() {
  since = step->flux();
  for (std::size_t part = 0; part < since.of.size(); part++)
    for (std::size_t k = 0; k < since.of[part].size(); k++) since.of[part][k] -= before.of[part][k];
  return since.of.data();
}
