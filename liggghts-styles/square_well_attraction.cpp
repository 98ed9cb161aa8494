// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "atom.h"
#include "contact_memory.h"
#include "contact_models.h"
#include "fix_contact_advice.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "hidden_fix.h"
#include "mesh_contact.h"
#include "pair_gran.h"
#include "property_readers.h"
#include "sampled_contact/sampled_well.h"
#include "square_well_attraction.h"
#include "vector3.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

constexpr const char* model_name = "cohesion model square_well";
constexpr const char* depth_property = "wellDepth";
constexpr const char* ratio_property = "wellRatio";

constexpr const char* too_far =
    "cohesion model square_well: a pair leaves its well by more than 0.01 of the radii in one "
    "step, "
    "beyond which it is not seen, and may keep its D: use a smaller time step";

}  // namespace

SquareWellAttraction::SquareWellAttraction(LAMMPS* lmp, IContactHistorySetup* owner,
                                           FixWallGran* wall)
    : lmp_(lmp), pair_(wall ? nullptr : static_cast<PairGran*>(owner)), wall_(wall) {
  // "0": the same seen from the other particle.
  offset_ = owner->add_history_value("wellState", "0");
  owner->add_history_value("wellImpulse", "0");
  if (wall) owner->add_history_value("wellLastStep", "0");
}

void SquareWellAttraction::connect(PropertyRegistry& registry, const NormalModelProbe&) {
  double** depth = type_pair_property<depth_property>(registry, model_name);
  const double* ratio = type_property<ratio_property>(registry, model_name);
  const int types = registry.max_type();
  // A restart file may remember wells, and an impulse that is under way.
  if (!connected_) is_active_ = remembers(lmp_, pair_, wall_, offset_ + STATE);
  connected_ = true;
  wells_.fill(
      lmp_, MODEL, types,
      [&](int i, int j) {
        const cohesion::square_well::SquareWellParameters well{depth[i][j], ratio[i], ratio[j]};
        is_active_ = is_active_ || well.depth > 0.0;
        cohesion::square_well::require_valid(well);
        return Well{well, cohesion::square_well::edge_bounds(well, wall_)};
      },
      [&](int i, int j) {
        return shown(depth_property, depth[i][j]) + ", " + shown(ratio_property, ratio[i]) +
               " and " + shown(ratio_property, ratio[j]);
      });
  if (is_active_) too_far_ = hidden_fix<FixContactAdvice>(lmp_).late_warning(too_far);
  largest_ratio_ = *std::max_element(ratio + 1, ratio + types + 1);
}

ContactRange SquareWellAttraction::range() const {
  ContactRange range;
  if (!is_active_) return range;  // the engine looks as far as it does without
  range.ratio = largest_ratio_ - 1.0;
  range.margin = MARGIN;
  range.source = "the width (wellRatio - 1) r of the well";
  return range;
}

bool SquareWellAttraction::binds(int itype, int jtype, double ri, double rj, double gap,
                                 const double* history) const {
  if (!is_active_) return gap < cohesion::square_well::width(wells_.of(itype, jtype).well, ri, rj);
  return history && is_inside(history[offset_ + STATE]);
}

double SquareWellAttraction::force(const Encounter& e) {
  double* const history = e.data.contact_history + offset_;
  if (e.data.computeflag) step(e, history);
  // A step that is computed again, as each run does with the last one, repeats its force.
  return -history[IMPULSE] / lmp_->update->dt;
}

void SquareWellAttraction::step(const Encounter& e, double* history) {
  const auto& d = e.data;
  const cohesion::square_well::SquareWellParameters& well = wells_.of(d.itype, d.jtype).well;
  const double width = cohesion::square_well::width(well, d.radi, d.is_wall ? 0.0 : d.radj);
  bool within = was_inside(e, history, width);
  if (d.shearupdate) {
    const double b = inverse_mass(d.i) + (d.is_wall ? 0.0 : inverse_mass(d.j));
    history[IMPULSE] = well.depth > 0.0 && b > 0.0
                           ? cohesion::sampled_contact::sampled_edge_impulse(
                                 well.depth, width, b, e.gap, approach(e), within)
                           : 0.0;
  }
  // One that is held at the edge turns round.
  if (within && e.gap < width && well.depth > 0.0) warn_if_out_of_sight(e);
  const bool nearer = e.gap < width;
  history[STATE] = within ? (nearer ? inside : pushed_out) : (nearer ? pushed_in : outside);
  if (d.mesh) history[LAST_STEP] = static_cast<double>(lmp_->update->ntimestep);
  // One that is outside all the same is remembered, not to be found there as if it stood there.
  remember(d, within || nearer || history[IMPULSE] != 0.0);
}

/// Warns of a pair that could be beyond what the engine shows when the next step finds it.
void SquareWellAttraction::warn_if_out_of_sight(const Encounter& e) {
  using namespace cohesion::square_well;
  const double seen = sight(largest_ratio_, MARGIN, e.data.radsum);
  if (flies_out_of_sight(e.gap, approach(e), lmp_->update->dt, seen)) too_far_->due = true;
}

bool SquareWellAttraction::was_inside(const Encounter& e, double* history, double width) const {
  const auto& d = e.data;
  // Before the first step of a run nothing has moved.
  const auto stands = [&] {
    return point(e).stands_within(d.radsum + width, d.shearupdate ? lmp_->update->dt : 0.0);
  };
  const double state = history[STATE];
  if (!d.shearupdate) {
    const bool displaced = e.gap < width ? state == outside : state == inside;
    return state == unknown || displaced ? stands() : is_inside(state);
  }
  const double last_step = static_cast<double>(lmp_->update->ntimestep - 1);
  if (d.mesh && history[LAST_STEP] != last_step) {
    const double* const before = history_before(*d.fix_mesh, d.j, d.i, lmp_->atom->x[d.i], d.radi,
                                                offset_ + LAST_STEP, last_step);
    if (before && before[offset_ + STATE] != unknown) return is_inside(before[offset_ + STATE]);
    return state == unknown && stands();
  }
  return state == unknown ? stands() : is_inside(state);
}

/// Speed along the normal at which the two come nearer.
double SquareWellAttraction::approach(const Encounter& e) { return -point(e).rate; }

cohesion::contact_solver::StaggeredMotion SquareWellAttraction::point(const Encounter& e) {
  const cohesion::Vector3 n = cohesion::vector(e.normal);
  const cohesion::Vector3 w = cohesion::vector(e.data.v_i) - cohesion::vector(e.data.v_j);
  const double radial = dot(w, n);
  return {e.data.radsum + e.gap, radial, e.data.is_wall ? 0.0 : norm(w - radial * n)};
}

/// Of the particle, or of the body that it belongs to; 0: it does not move.
double SquareWellAttraction::inverse_mass(int particle) const {
  double mass = lmp_->atom->rmass[particle];
  if (wall_) {
    if (wall_->fix_rigid() && wall_->body(particle) >= 0)
      mass = wall_->masstotal(wall_->body(particle));
  } else {
    if (lmp_->atom->mask[particle] & pair_->freeze_group_bit()) return 0.0;
    if (pair_->fr_pair() && pair_->mr_pair()[particle] > 0.0) mass = pair_->mr_pair()[particle];
  }
  return 1.0 / mass;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
