// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_HAMAKER_ATTRACTION_H
#define COHESION_HAMAKER_ATTRACTION_H

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "advice/known_materials.h"
#include "cohesion_defaults.h"
#include "common/plausible_sizes.h"
#include "contact/adhesion.h"
#include "contact/stiffness_scaling.h"
#include "contact_range.h"
#include "contact_solver/contact_solver.h"
#include "encounter.h"
#include "hamaker/law.h"
#include "hamaker/small_gap.h"
#include "normal_model_probe.h"
#include "settings.h"
#include "sphere.h"
#include "type_materials.h"
#include "type_matrix.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Of the cohesion model hamaker: hamaker/law.h with the form of small gaps.
class HamakerAttraction : public CohesionDefaults {
 public:
  static constexpr const char* MODEL = "hamaker";
  static constexpr bool BINDS_WHAT_ENTERED = false;
  using Solver = cohesion::contact_solver::ContactSolver;

  HamakerAttraction(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup*, LAMMPS_NS::FixWallGran* wall)
      : lmp_(lmp), is_wall_(wall != nullptr), materials_(lmp, MODEL, wall != nullptr) {}

  /// Keywords of the material.
  void registerSettings(Settings& settings) { materials_.registerSettings(settings, true); }

  /// Reads fix property/global hamakerConstant (peratomtypepair), hamakerSurfaceCutoff and
  /// hamakerOuterCutoff (scalar), and the material when the adhesion is to be scaled; what was done
  /// is printed. A parameter that cannot be right stops the engine with the types and the values
  /// given.
  void connect(PropertyRegistry& registry, const NormalModelProbe& normal);

  /// Stops the engine where scheme exact would turn pairs wrongly (contact_solver/turning.h).
  void require_turns_as_touching() const;

  ContactRange range() const;
  bool is_active() const { return is_active_; }
  bool is_out_of_reach(const ContactModels::SurfacesCloseData& near, bool) const {
    // Where rounding could decide, force() does.
    const double reach = near.radsum + outer_cutoff_;
    return near.rsq > reach * reach * (1.0 + 1e-12);
  }

  bool binds(int itype, int jtype, double, double, double gap, const double*) const {
    return gap < outer_cutoff_ && attracts(itype, jtype);
  }
  /// rj infinite: beside a wall.
  cohesion::contact::Adhesion adhesion(int itype, int jtype, double ri, double rj) const {
    return cohesion::contact::adhesion_with_tail(laws_.of(itype, jtype),
                                                 geometry(!std::isfinite(rj), ri, rj));
  }

  /// Given where material_stiffness or material_modulus is on.
  cohesion::contact::Material material(int itype, int jtype) const {
    return materials_.of(itype, jtype);
  }
  static std::string_view material_words(const NormalModelProbe& normal) {
    return normal.material_words();
  }
  std::string doubt(int itype, int jtype) const {
    return cohesion::advice::above_hamaker_constants(constants_.of(itype, jtype),
                                                     LAMMPS_NS::si_units(lmp_));
  }

  double energy(int itype, int jtype, double ri, double rj, double gap, bool) const {
    return laws_.of(itype, jtype).energy(gap, geometry(!std::isfinite(rj), ri, rj));
  }

  double force(const Encounter& e) const {
    const auto& d = e.data;
    return laws_.of(d.itype, d.jtype).force(e.gap, geometry(d.is_wall, d.radi, d.radj));
  }

 private:
  using Law = cohesion::hamaker::HamakerLaw<cohesion::hamaker::SmallGap>;

  /// Any particles of these types.
  bool attracts(int itype, int jtype) const {
    return laws_.of(itype, jtype).adhesion_force(cohesion::two_spheres(1.0, 1.0)) > 0.0;
  }
  static cohesion::PairGeometry geometry(bool is_wall, double ri, double rj) {
    return is_wall ? cohesion::sphere_and_plane(ri) : cohesion::two_spheres(ri, rj);
  }

  LAMMPS_NS::LAMMPS* lmp_;
  bool is_wall_;
  std::vector<double> smallest_radii_;  // by type
  TypeMatrix<Law> laws_;
  TypeMatrix<double> constants_;  // as given
  TypeMaterials materials_;
  double outer_cutoff_ = 0.0;
  bool is_active_ = false;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
