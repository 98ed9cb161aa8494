// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_COHESION_OVERLAY_H
#define COHESION_COHESION_OVERLAY_H

#include <cmath>
#include <string>

#include "atom.h"
#include "cohesion_model_base.h"
#include "cohesive_pairs.h"
#include "contact_models.h"
#include "contact_range.h"
#include "encounter.h"
#include "error.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "mesh_contact.h"
#include "scheme_setting.h"

namespace LIGGGHTS {
namespace ContactModels {

/// A cohesion laid over whatever contact model it is combined with, at overlap and across a gap.
/// `Attraction` says what is its own:
///
///   MODEL                          name in a script
///   Attraction(lmp, owner, wall)   wall: null for pairs
///   connect(registry)              reads the parameters
///   range()                        how far it must see (contact_range.h)
///   reach()                        gap from which on it does nothing, [length]
///   force(encounter)               attraction, [force]; called once per step and contact
///   binds(gap, history)            whether a pair is bound (cohesive_pairs.h)
template <class Attraction>
class CohesionOverlay : public CohesionModelBase, private Cohesion::CohesivePairs {
 public:
  CohesionOverlay(LAMMPS* lmp, IContactHistorySetup* owner, ContactModelBase* model)
      : CohesionModelBase(lmp, owner, model),
        CohesivePairs(lmp, owner, model->is_wall()),
        wall_(model->is_wall() ? static_cast<FixWallGran*>(owner) : nullptr),
        attraction_(lmp, owner, wall_) {}

  void registerSettings(Settings& settings) override {
    Cohesion::register_scheme(settings, name());
  }
  void postSettings(IContactHistorySetup*, ContactModelBase*) override {}

  void connectToProperties(PropertyRegistry& registry) override {
    if (!atom->sphere_flag)
      error->all(FLERR, (name() + ": needs spheres, use atom_style granular").c_str());
    if (force->cg_active()) error->cg(FLERR, name().c_str());
    attraction_.connect(registry);
    Cohesion::require_range(lmp, registry, wall_, name(), attraction_.range());
  }

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    attract(contact, contact.r, contact.en, on_i, on_j);
  }

  void surfacesClose(SurfacesCloseData& near, ForceData& on_i, ForceData& on_j) override {
    const double r = std::sqrt(near.rsq);
    if (r - near.radsum >= attraction_.reach()) return;
    const double inverse = 1.0 / r;
    const double normal[3] = {inverse * near.delta[0], inverse * near.delta[1],
                              inverse * near.delta[2]};
    if (attract(near, r, normal, on_i, on_j)) near.has_force_update = true;
  }

  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endSurfacesIntersect(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  bool binds(double gap, const double* history) const override {
    return attraction_.binds(gap, history);
  }

  static std::string name() { return std::string("cohesion model ") + Attraction::MODEL; }

  /// r: distance of i's centre from j's, or from the wall, of which radsum is then the radius of i.
  bool attract(const SurfacesCloseData& data, double r, const double* normal, ForceData& on_i,
               ForceData& on_j) {
    if (data.mesh &&
        !Cohesion::carries_contact(*data.fix_mesh, data.j, data.i, atom->x[data.i], data.radi))
      return false;
    const double attraction = attraction_.force({data, normal, r - data.radsum});
    for (int d = 0; d < 3; d++) {
      on_i.delta_F[d] -= attraction * normal[d];
      on_j.delta_F[d] += attraction * normal[d];  // of a wall the engine ignores it
    }
    return true;
  }

  FixWallGran* wall_;  // null for pairs
  Attraction attraction_;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
