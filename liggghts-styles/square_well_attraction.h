// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_SQUARE_WELL_ATTRACTION_H
#define COHESION_SQUARE_WELL_ATTRACTION_H

#include <cmath>

#include "contact_book.h"
#include "contact_range.h"
#include "encounter.h"
#include "normal_model_probe.h"
#include "square_well/parameters.h"
#include "table_of_types.h"

namespace LAMMPS_NS {
class PairGran;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

/// Of the cohesion model square_well: event_stepping/sampled_well.h, the impulse at the edge spread
/// over the step. What it remembers of each contact goes with the engine's contact history through
/// exchange and restart.
class SquareWellAttraction : public AttractionEnergy {
 public:
  static constexpr const char* MODEL = "square_well";

  SquareWellAttraction(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* owner,
                       LAMMPS_NS::FixWallGran* wall);

  void registerSettings(Settings&) {}

  /// Reads fix property/global wellDepth (peratomtypepair) and wellRatio (peratomtype). A parameter
  /// that cannot be right stops the engine with the types and the values given.
  void connect(PropertyRegistry& registry, const NormalModelProbe&);

  ContactRange range() const;
  /// What is remembered of wells before has to be followed even when there is none any more.
  bool acts() const { return acts_; }
  /// Known to be outside and still there: most of the pairs that it has to see.
  bool rests(const ContactModels::SurfacesCloseData& near, bool watched) const;

  /// While the pair is in its well.
  bool binds(int itype, int jtype, double ri, double rj, double gap, const double* history) const;
  /// rj infinite: beside a wall.
  cohesion::contact::Adhesion adhesion(int itype, int jtype, double ri, double rj) const {
    return cohesion::square_well::adhesion_of(wells_.of(itype, jtype), ri,
                                              std::isfinite(rj) ? rj : 0.0);
  }

  double force(const Encounter& encounter);
  double energy(int itype, int jtype, double, double, double, bool inside) const override {
    return inside ? -wells_.of(itype, jtype).depth : 0.0;
  }

 private:
  void step(const Encounter& encounter, double* history);
  void look_ahead(const Encounter& encounter);
  bool was_inside(const Encounter& encounter, double* history, double width) const;
  double approach(const Encounter& encounter) const;
  double inverse_mass(int particle) const;

  LAMMPS_NS::LAMMPS* lmp_;
  LAMMPS_NS::PairGran* pair_;     // null for walls
  LAMMPS_NS::FixWallGran* wall_;  // null for pairs
  int offset_;                    // of what is remembered in the history of a contact
  TableOfTypes<cohesion::square_well::Parameters> wells_;
  double largest_ratio_ = 1.0;
  bool acts_ = false;
  bool connected_ = false;
  bool warned_ = false;  // that a pair flies too far in a step
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
