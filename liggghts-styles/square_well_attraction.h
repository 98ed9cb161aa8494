// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_SQUARE_WELL_ATTRACTION_H
#define COHESION_SQUARE_WELL_ATTRACTION_H

#include <cmath>
#include <memory>
#include <string>

#include "cohesion_defaults.h"
#include "contact_range.h"
#include "contact_solver/contact_state.h"
#include "contact_solver/square_well_solver.h"
#include "encounter.h"
#include "lammps.h"
#include "normal_model_probe.h"
#include "square_well/parameters.h"
#include "square_well/sight.h"
#include "type_matrix.h"
#include "update.h"

namespace LAMMPS_NS {
class PairGran;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

struct LateWarning;

/// Of the cohesion model square_well: sampled_contact/sampled_well.h, the impulse at the edge
/// spread over the step. What it remembers of each contact goes with the engine's contact history
/// through exchange and restart.
class SquareWellAttraction : public CohesionDefaults {
 public:
  static constexpr const char* MODEL = "square_well";
  static constexpr bool BINDS_WHAT_ENTERED = true;
  using Solver = cohesion::contact_solver::SquareWellSolver;

  SquareWellAttraction(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* owner,
                       LAMMPS_NS::FixWallGran* wall);

  /// Reads fix property/global wellDepth (peratomtypepair) and wellRatio (peratomtype). A parameter
  /// that cannot be right stops the engine with the types and the values given.
  void connect(PropertyRegistry& registry, const NormalModelProbe&);

  ContactRange range() const;
  /// Stored states of wells remain active even when no well is left.
  bool is_active() const { return is_active_; }
  /// Known to be outside and still there: most of the pairs that it has to see.
  bool is_out_of_reach(const ContactModels::SurfacesCloseData& near, bool update_all) const {
    return !update_all && was(outside, near) &&
           near.rsq > bounds(near).outside * square_of_radii(near);
  }
  /// Known to be inside and still there, and too slow to fly out of sight, of which step() warns.
  /// Marks such a contact as one to be remembered, as step() does.
  bool is_idle(const ContactModels::SurfacesCloseData& near) const {
    return near.rsq < bounds(near).inside * square_of_radii(near) && is_idle_in_contact(near);
  }
  bool is_idle_in_contact(const ContactModels::SurfacesCloseData& d) const {
    if (!was(inside, d)) return false;
    const double speed[3] = {d.v_j[0] - d.v_i[0], d.v_j[1] - d.v_i[1], d.v_j[2] - d.v_i[2]};
    if (!cohesion::square_well::stays_in_sight(
            speed[0] * speed[0] + speed[1] * speed[1] + speed[2] * speed[2], lmp_->update->dt,
            MARGIN, square_of_radii(d)))
      return false;
    remember(d, true);
    return true;
  }

  /// While the pair is in its well.
  bool binds(int itype, int jtype, double ri, double rj, double gap, const double* history) const;
  /// rj infinite: beside a wall.
  cohesion::contact::Adhesion adhesion(int itype, int jtype, double ri, double rj) const {
    return cohesion::square_well::adhesion_of(wells_.of(itype, jtype).well, ri,
                                              std::isfinite(rj) ? rj : 0.0);
  }

  double force(const Encounter& encounter);
  double energy(int itype, int jtype, double, double, double, bool inside) const {
    return inside ? -wells_.of(itype, jtype).well.depth : 0.0;
  }

 private:
  // What is remembered of a contact; the last beside walls alone, for contacts with meshes.
  enum { STATE, IMPULSE, LAST_STEP };
  // STATE; the engine gives a new contact zeros. What others pushed across the edge is `pushed_in`
  // while it is outside all the same, `pushed_out` while it is inside.
  static constexpr double unknown = 0.0, outside = 1.0, inside = 2.0, pushed_in = 3.0,
                          pushed_out = 4.0;
  static bool is_inside(double state) { return state == inside || state == pushed_out; }

  struct Well {
    cohesion::square_well::SquareWellParameters well;
    cohesion::square_well::EdgeBounds bounds;
  };

  /// Whether a step begins with the pair there, and with no impulse that has to be taken back.
  bool was(double state, const ContactModels::SurfacesCloseData& d) const {
    const double* const history = d.contact_history + offset_;
    return history[STATE] == state && history[IMPULSE] == 0.0 &&
           !(d.is_wall && (d.mesh || !d.computeflag || !d.shearupdate));
  }
  const cohesion::square_well::EdgeBounds& bounds(const ContactModels::SurfacesCloseData& d) const {
    return wells_.of(d.itype, d.jtype).bounds;
  }
  static double square_of_radii(const ContactModels::SurfacesCloseData& d) {
    return d.radsum * d.radsum;
  }

  void step(const Encounter& encounter, double* history);
  void warn_if_out_of_sight(const Encounter& encounter);
  bool was_inside(const Encounter& encounter, double* history, double width) const;
  static double approach(const Encounter& encounter);
  static cohesion::contact_solver::StaggeredMotion point(const Encounter& encounter);
  double inverse_mass(int particle) const;

  LAMMPS_NS::LAMMPS* lmp_;
  LAMMPS_NS::PairGran* pair_;     // null for walls
  LAMMPS_NS::FixWallGran* wall_;  // null for pairs
  int offset_;                    // of what is remembered in the history of a contact
  TypeMatrix<Well> wells_;
  double largest_ratio_ = 1.0;
  bool is_active_ = false;
  bool connected_ = false;
  std::shared_ptr<LateWarning> too_far_;  // a pair flies too far in a step; null: there is no well
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
