// SPDX-License-Identifier: GPL-2.0-or-later
// Cohesion model `hamaker` of pair_style gran and fix wall/gran. The law is hamaker/law.h with
// the form of small gaps; here its parameters come from fix property/global and its force goes to
// the particles.

#ifdef COHESION_MODEL
COHESION_MODEL(COHESION_HAMAKER, hamaker, 20)
#else

#ifndef COHESION_MODEL_HAMAKER_H_
#define COHESION_MODEL_HAMAKER_H_

#include <cmath>
#include <memory>

#include "atom.h"
#include "cohesion_model_base.h"
#include "contact_models.h"
#include "error.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "hamaker_from_properties.h"
#include "sphere.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class CohesionModel<COHESION_HAMAKER> : public CohesionModelBase {
 public:
  CohesionModel(LAMMPS* lmp, IContactHistorySetup* owner, ContactModelBase* model)
      : CohesionModelBase(lmp, owner, model),
        wall_(model->is_wall() ? static_cast<FixWallGran*>(owner) : nullptr) {}

  void registerSettings(Settings&) override {}
  void postSettings(IContactHistorySetup*, ContactModelBase*) override {}

  void connectToProperties(PropertyRegistry& registry) override {
    if (!atom->sphere_flag)
      error->all(FLERR, "cohesion model hamaker: needs spheres, use atom_style granular");
    if (force->cg_active()) error->cg(FLERR, "cohesion model hamaker");
    laws_ = std::make_unique<Cohesion::HamakerOfTypes>(lmp, registry);
    Cohesion::require_range(lmp, registry, wall_, laws_->outer_cutoff());
  }

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    attract(contact, contact.r, contact.en, on_i, on_j);
  }

  void surfacesClose(SurfacesCloseData& near, ForceData& on_i, ForceData& on_j) override {
    const double r = std::sqrt(near.rsq);
    if (r - near.radsum >= laws_->outer_cutoff()) return;
    const double normal[3] = {near.delta[0] / r, near.delta[1] / r, near.delta[2] / r};
    attract(near, r, normal, on_i, on_j);
    near.has_force_update = true;
  }

  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endSurfacesIntersect(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  /// normal: from j, or the wall, to i. r: distance of i's centre from j's, or from the wall, of
  /// which radsum is then the radius of i.
  void attract(const SurfacesCloseData& data, double r, const double* normal, ForceData& on_i,
               ForceData& on_j) const {
    const cohesion::PairGeometry geometry = data.is_wall
                                                ? cohesion::sphere_and_plane(data.radi)
                                                : cohesion::two_spheres(data.radi, data.radj);
    const double attraction = laws_->of(data.itype, data.jtype).force(r - data.radsum, geometry);
    for (int d = 0; d < 3; d++) {
      on_i.delta_F[d] -= attraction * normal[d];
      on_j.delta_F[d] += attraction * normal[d];  // of a wall the engine ignores it
    }
  }

  FixWallGran* wall_;  // null for pairs
  std::unique_ptr<Cohesion::HamakerOfTypes> laws_;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
