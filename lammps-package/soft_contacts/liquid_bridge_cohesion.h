// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_LIQUID_BRIDGE_COHESION_H
#define COHESION_LIQUID_BRIDGE_COHESION_H

#include "cohesion_law.h"
#include "event_stepping/bridge_pair.h"
#include "event_stepping/sampled_bridge.h"
#include "liquid_bridge/parameters.h"

namespace LAMMPS_NS {

/// A liquid bridge as gran/liquid_bridge and wall/gran/liquid_bridge take it.
class LiquidBridgeCohesion : public CohesionLaw<cohesion::liquid_bridge::Parameters> {
 public:
  static constexpr char STYLE[] = "gran/liquid_bridge";
  static constexpr int RESTART_LAYOUT = 1;
  static constexpr bool FORMS_AT_TOUCH = true;

  using EventPair = cohesion::event_stepping::BridgePair;
  using EventWall = cohesion::event_stepping::BridgePlane;
  using Sampled = cohesion::event_stepping::SampledBridge;

  static std::vector<ContactKeyword<Parameters>> keywords() {
    return {{"bridge", 2, [](Parameters& p, const double* v) { p.law = {v[0], v[1]}; }}};
  }
};

}  // namespace LAMMPS_NS

#endif
