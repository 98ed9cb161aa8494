// SPDX-License-Identifier: GPL-2.0-or-later
#include "liquid_bridge_attraction.h"

#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "common/message.h"
#include "contact_models.h"
#include "error.h"
#include "fix_mesh_surface.h"
#include "liquid_bridge/range_of_validity.h"
#include "mesh_contact.h"
#include "property_readers.h"
#include "sampled_contact/sampled_bridge.h"
#include "smallest_radii.h"
#include "update.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

constexpr const char* model_name = "cohesion model liquid_bridge";
constexpr const char* force_property = "bridgeForce";
constexpr const char* gap_property = "bridgeRuptureGap";
constexpr const char* tension_property = "bridgeSurfaceTension";
constexpr const char* angle_property = "bridgeContactAngle";
constexpr const char* volume_property = "bridgeVolume";

}  // namespace

LiquidBridgeAttraction::LiquidBridgeAttraction(LAMMPS* lmp, IContactHistorySetup* owner,
                                               FixWallGran* wall)
    : lmp_(lmp), is_wall_(wall != nullptr) {
  // "0": the same seen from the other particle.
  offset_ = owner->add_history_value("bridged", "0");
  if (wall) owner->add_history_value("bridgeLastStep", "0");
}

void LiquidBridgeAttraction::connect(PropertyRegistry& registry, const NormalModelProbe&) {
  is_active_ = false;
  widest_gap_ = 0.0;
  smallest_radii_ = smallest_radii(lmp_);
  if (is_liquid_)
    fill_with_liquid(registry);
  else
    fill(registry);
}

void LiquidBridgeAttraction::fill(PropertyRegistry& registry) {
  double** force = type_pair_property<force_property>(registry, model_name);
  double** gap = type_pair_property<gap_property>(registry, model_name);
  laws_.fill(
      lmp_, MODEL, registry.max_type(),
      [&](int i, int j) {
        const cohesion::liquid_bridge::LiquidBridgeParameters law{force[i][j], gap[i][j]};
        require_valid(law);
        return added(law, i, j);
      },
      [&](int i, int j) {
        return shown(force_property, force[i][j]) + ", " + shown(gap_property, gap[i][j]);
      });
}

void LiquidBridgeAttraction::fill_with_liquid(PropertyRegistry& registry) {
  double** tension = type_pair_property<tension_property>(registry, model_name);
  double** angle = type_pair_property<angle_property>(registry, model_name);
  double** volume = type_pair_property<volume_property>(registry, model_name);
  laws_.fill(
      lmp_, MODEL, registry.max_type(),
      [&](int i, int j) {
        return added(cohesion::liquid_bridge::capillary(tension[i][j], angle[i][j], volume[i][j]),
                     i, j);
      },
      [&](int i, int j) {
        return shown(tension_property, tension[i][j]) + ", " + shown(angle_property, angle[i][j]) +
               ", " + shown(volume_property, volume[i][j]);
      });
}

cohesion::liquid_bridge::LiquidBridgeParameters LiquidBridgeAttraction::added(
    const cohesion::liquid_bridge::LiquidBridgeParameters& law, int itype, int jtype) {
  if (!law.attracts()) return law;
  require_short(law, itype, jtype);
  is_active_ = true;
  widest_gap_ = std::max(widest_gap_, law.rupture_gap);
  return law;
}

/// The type of a wall may have no particles.
void LiquidBridgeAttraction::require_short(
    const cohesion::liquid_bridge::LiquidBridgeParameters& law, int itype, int jtype) {
  const double ri = smallest_radii_[itype], rj = smallest_radii_[jtype];
  if (is_wall_ ? !std::isfinite(ri) : !std::isfinite(std::max(ri, rj))) return;
  const double radius = is_wall_ ? ri : std::min(ri, rj);
  cohesion::liquid_bridge::require_short(law, radius);
  const std::string doubt = cohesion::liquid_bridge::doubt_of_volume(law, radius);
  if (doubt.empty() || !warned_.insert(doubt).second || lmp_->comm->me != 0) return;
  const std::string text = LAMMPS_NS::message("cohesion model ", MODEL, ", atom types ", itype,
                                              " and ", jtype, ": ", doubt);
  lmp_->error->warning(FLERR, text.c_str());
}

ContactRange LiquidBridgeAttraction::range() const {
  ContactRange range;
  if (!is_active_) return range;  // the engine looks as far as it does without
  range.gap = widest_gap_;
  range.margin = MARGIN;
  range.source = is_liquid_ ? "the rupture gap by bridgeVolume" : gap_property;
  return range;
}

double LiquidBridgeAttraction::force(const Encounter& e) {
  const auto& d = e.data;
  const auto bridge = adhesion_of(laws_.of(d.itype, d.jtype), d.radi, d.is_wall ? 0.0 : d.radj);
  const bool bridged = bridge.force > 0.0 && cohesion::sampled_contact::sampled_bridge(
                                                 bridge.cutoff, e.gap, was_bridged(e));
  if (d.computeflag) {
    double* const history = d.contact_history + offset_;
    history[BRIDGED] = bridged;
    if (d.mesh) history[LAST_STEP] = static_cast<double>(lmp_->update->ntimestep);
    remember(d, bridged);
  }
  return bridged ? bridge.pull().at(e.gap) : 0.0;
}

/// A step that is computed again, as each run does with the last one, finds the same.
bool LiquidBridgeAttraction::was_bridged(const Encounter& e) const {
  const auto& d = e.data;
  const double* const history = d.contact_history + offset_;
  const double last_step = static_cast<double>(lmp_->update->ntimestep - 1);
  if (!d.mesh || !d.shearupdate || history[LAST_STEP] == last_step) return history[BRIDGED] != 0.0;
  const double* const before = history_before(*d.fix_mesh, d.j, d.i, lmp_->atom->x[d.i], d.radi,
                                              offset_ + LAST_STEP, last_step);
  return before && before[offset_ + BRIDGED] != 0.0;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
