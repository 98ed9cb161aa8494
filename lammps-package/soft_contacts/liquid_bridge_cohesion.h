// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_LIQUID_BRIDGE_COHESION_H
#define COHESION_LIQUID_BRIDGE_COHESION_H

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "comm.h"
#include "contact_solver/liquid_bridge_solver.h"
#include "liquid_bridge/range_of_validity.h"
#include "sampled_contact/sampled_bridge.h"
#include "soft_contacts/cohesion_law.h"

namespace LAMMPS_NS {

/// A liquid bridge as gran/liquidbridge and wall/gran/liquidbridge take it.
class LiquidBridgeCohesion : public CohesionLaw<cohesion::liquid_bridge::LiquidBridgeParameters> {
 public:
  static constexpr char STYLE[] = "gran/liquidbridge";
  static constexpr char ADHESION[] = "bridge", WITHOUT_ADHESION[] = "bridge 0 0";
  static constexpr int RESTART_LAYOUT = 6;

  using Solver = cohesion::contact_solver::LiquidBridgeSolver;
  using Sampled = cohesion::sampled_contact::SampledBridge;

  static std::vector<ContactKeyword<Parameters>> keywords() {
    return {{"bridge", "F_b h_r", [](Parameters& p, const double* v) { p.law = {v[0], v[1]}; }},
            {"capillary", "gamma theta V", [](Parameters& p, const double* v) {
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
  /// Warns, once, of a volume that is too large for the force.
  void require_short(LAMMPS* lmp, const std::string& where, const Parameters& p, double radius_i,
                     double radius_j) const {
    if (radius_i == 0.0 || radius_j == 0.0) return;  // no particles yet
    const double radius = std::min(radius_i, radius_j);
    try {
      cohesion::liquid_bridge::require_short(p.law, radius);
    } catch (const cohesion::InvalidParameter& bad) {
      stop(lmp, FLERR, where, ": ", bad.what(), units_of_lengths(lmp));
    }
    const std::string doubt = cohesion::liquid_bridge::doubt_of_volume(p.law, radius);
    if (doubt.empty()) return;
    const std::string text = where + ": " + doubt + units_of_lengths(lmp);
    if (warned_.insert(text).second && lmp->comm->me == 0) lmp->error->warning(FLERR, text);
  }

 private:
  mutable std::set<std::string> warned_;
};

}  // namespace LAMMPS_NS

#endif
