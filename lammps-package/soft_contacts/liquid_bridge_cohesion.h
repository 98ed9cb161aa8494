// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_LIQUID_BRIDGE_COHESION_H
#define COHESION_LIQUID_BRIDGE_COHESION_H

#include <string>
#include <vector>

#include "contact_solver/liquid_bridge_solver.h"
#include "liquid_bridge/parameters.h"
#include "sampled_contact/sampled_bridge.h"
#include "soft_contacts/cohesion_law.h"

namespace LAMMPS_NS {

/// A liquid bridge as gran/liquidbridge and wall/gran/liquidbridge take it.
class LiquidBridgeCohesion : public CohesionLaw<cohesion::liquid_bridge::LiquidBridgeParameters> {
 public:
  static constexpr char STYLE[] = "gran/liquidbridge";
  static constexpr char ADHESION[] = "bridge", WITHOUT_ADHESION[] = "bridge 0 0";
  static constexpr int RESTART_LAYOUT = 5;

  using Solver = cohesion::contact_solver::LiquidBridgeSolver;
  using Sampled = cohesion::sampled_contact::SampledBridge;

  static std::vector<ContactKeyword<Parameters>> keywords() {
    return {{"bridge", 2, [](Parameters& p, const double* v) { p.law = {v[0], v[1]}; }},
            {"capillary", 3, [](Parameters& p, const double* v) {
               p.law = cohesion::liquid_bridge::capillary(v[0], v[1], v[2]);
             }}};
  }
  static void require_valid(LAMMPS* lmp, const std::string& where, const Parameters& p,
                            const SpecifiedKeywords& given) {
    if (given.has("bridge") && given.has("capillary"))
      lmp->error->all(FLERR, where +
                                 ": a bridge is given either by its force ('bridge') or by its "
                                 "liquid ('capillary'), not both");
    CohesionLaw::require_valid(lmp, where, p, given);
  }
};

}  // namespace LAMMPS_NS

#endif
