// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_LIQUID_BRIDGE_ATTRACTION_H
#define COHESION_LIQUID_BRIDGE_ATTRACTION_H

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "cohesion_defaults.h"
#include "contact_range.h"
#include "contact_solver/liquid_bridge_solver.h"
#include "encounter.h"
#include "lammps.h"
#include "liquid_bridge/parameters.h"
#include "normal_model_probe.h"
#include "type_matrix.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Of the cohesion model liquid_bridge (liquid_bridge/parameters.h). Whether a contact has its
/// bridge goes with the engine's contact history through exchange and restart.
class LiquidBridgeAttraction : public CohesionDefaults {
 public:
  static constexpr const char* MODEL = "liquid_bridge";
  static constexpr bool BINDS_WHAT_ENTERED = true;
  using Solver = cohesion::contact_solver::LiquidBridgeSolver;

  LiquidBridgeAttraction(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* owner,
                         LAMMPS_NS::FixWallGran* wall);

  /// Keyword capillary.
  void registerSettings(Settings& settings) { settings.registerOnOff("capillary", is_liquid_); }

  /// Reads fix property/global (peratomtypepair) bridgeForce and bridgeRuptureGap, with capillary
  /// bridgeSurfaceTension, bridgeContactAngle and bridgeVolume. A parameter that cannot be right
  /// stops the engine with the types and the values given.
  void connect(PropertyRegistry& registry, const NormalModelProbe&);

  ContactRange range() const;
  bool is_active() const { return is_active_; }
  /// Most of the pairs that it has to see: apart, and without a bridge. One with a triangle of a
  /// mesh may have it from another.
  bool is_out_of_reach(const ContactModels::SurfacesCloseData& near, bool) const {
    return !near.mesh && near.contact_history[offset_ + BRIDGED] == 0.0;
  }

  /// While the pair has its bridge.
  bool binds(int, int, double, double, double gap, const double* history) const {
    return is_active_ ? history && history[offset_ + BRIDGED] != 0.0 : gap < 0.0;
  }
  /// rj infinite: beside a wall.
  cohesion::contact::Adhesion adhesion(int itype, int jtype, double ri, double rj) const {
    return adhesion_of(laws_.of(itype, jtype), ri, std::isfinite(rj) ? rj : 0.0);
  }

  double force(const Encounter& encounter);
  /// Zero at touch.
  double energy(int itype, int jtype, double ri, double rj, double gap, bool bridged) const {
    return bridged ? adhesion(itype, jtype, ri, rj).pull().work(gap) : 0.0;
  }

 private:
  // What is remembered of a contact; the last beside walls alone, for contacts with meshes.
  enum { BRIDGED, LAST_STEP };

  bool was_bridged(const Encounter& encounter) const;
  void fill(PropertyRegistry& registry);
  void fill_with_liquid(PropertyRegistry& registry);
  cohesion::liquid_bridge::LiquidBridgeParameters added(
      const cohesion::liquid_bridge::LiquidBridgeParameters& law, int itype, int jtype);
  void require_short(const cohesion::liquid_bridge::LiquidBridgeParameters& law, int itype,
                     int jtype);

  LAMMPS_NS::LAMMPS* lmp_;
  bool is_wall_;
  std::vector<double> smallest_radii_;  // by type
  std::set<std::string> warned_;
  int offset_;  // of what is remembered in the history of a contact
  TypeMatrix<cohesion::liquid_bridge::LiquidBridgeParameters> laws_;
  double widest_gap_ = 0.0;
  bool is_active_ = false;
  bool is_liquid_ = false;  // keyword capillary
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
