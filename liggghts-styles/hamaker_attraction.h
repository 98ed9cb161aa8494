// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_HAMAKER_ATTRACTION_H
#define COHESION_HAMAKER_ATTRACTION_H

#include "contact_range.h"
#include "encounter.h"
#include "hamaker/law.h"
#include "hamaker/small_gap.h"
#include "sphere.h"
#include "table_of_types.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Of the cohesion model hamaker: hamaker/law.h with the form of small gaps.
class HamakerAttraction {
 public:
  static constexpr const char* MODEL = "hamaker";

  HamakerAttraction(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup*, LAMMPS_NS::FixWallGran*)
      : lmp_(lmp) {}

  /// Reads fix property/global hamakerConstant (peratomtypepair), hamakerSurfaceCutoff and
  /// hamakerOuterCutoff (scalar). A parameter that cannot be right stops the engine with the types
  /// and the values given.
  void connect(PropertyRegistry& registry);

  ContactRange range() const;
  double reach() const { return outer_cutoff_; }

  bool binds(double gap, const double*) const { return gap < outer_cutoff_; }

  double force(const Encounter& e) const {
    const auto& d = e.data;
    const cohesion::PairGeometry geometry =
        d.is_wall ? cohesion::sphere_and_plane(d.radi) : cohesion::two_spheres(d.radi, d.radj);
    return laws_.of(d.itype, d.jtype).force(e.gap, geometry);
  }

 private:
  using Law = cohesion::hamaker::Law<cohesion::hamaker::SmallGap>;

  LAMMPS_NS::LAMMPS* lmp_;
  TableOfTypes<Law> laws_;
  double outer_cutoff_ = 0.0;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
