// SPDX-License-Identifier: GPL-2.0-or-later
#include "hamaker_attraction.h"

#include <mpi.h>
// The engine's header of properties wants mpi.h before it.
#include <cmath>
#include <vector>

#include "common/message.h"
#include "contact_solver/turning.h"
#include "global_properties.h"
#include "hamaker/range_of_validity.h"
#include "property_registry.h"
#include "smallest_radii.h"
#include "word_settings.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

constexpr const char* asked_for_by = "cohesion model hamaker";
constexpr const char* constant_property = "hamakerConstant";
constexpr const char* surface_property = "hamakerSurfaceCutoff";
constexpr const char* outer_property = "hamakerOuterCutoff";

MatrixProperty* make_constant(PropertyRegistry& registry, const char* caller, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, constant_property, caller);
}
ScalarProperty* make_surface_cutoff(PropertyRegistry& registry, const char* caller, bool) {
  return MODEL_PARAMS::createScalarProperty(registry, surface_property, caller);
}
ScalarProperty* make_outer_cutoff(PropertyRegistry& registry, const char* caller, bool) {
  return MODEL_PARAMS::createScalarProperty(registry, outer_property, caller);
}

}  // namespace

void HamakerAttraction::connect(PropertyRegistry& registry, const NormalModelProbe& normal) {
  registry.registerProperty(constant_property, &make_constant);
  registry.registerProperty(surface_property, &make_surface_cutoff);
  registry.registerProperty(outer_property, &make_outer_cutoff);
  double** constant = registry.getMatrixProperty(constant_property, asked_for_by)->data;
  const double surface = registry.getScalarProperty(surface_property, asked_for_by)->data;
  outer_cutoff_ = registry.getScalarProperty(outer_property, asked_for_by)->data;

  materials_.connect(registry, normal);
  const auto given = [&](int i, int j) {
    const std::string of_material = materials_.shown(i, j);
    return shown(constant_property, constant[i][j]) + ", " + shown(surface_property, surface) +
           ", " + shown(outer_property, outer_cutoff_) +
           (of_material.empty() ? "" : ", " + of_material);
  };
  constants_.fill(
      lmp_, MODEL, registry.max_type(), [&](int i, int j) { return constant[i][j]; }, given);
  is_active_ = false;
  const std::vector<double>& radii = smallest_radii_ = smallest_radii(lmp_);
  laws_.fill(
      lmp_, MODEL, registry.max_type(),
      [&](int i, int j) {
        const cohesion::hamaker::Parameters real{constant[i][j], surface, outer_cutoff_};
        is_active_ = is_active_ || real.hamaker_constant > 0.0;
        cohesion::hamaker::require_valid(real);
        if (std::isfinite(radii[i]) && (is_wall_ || std::isfinite(radii[j])))
          cohesion::hamaker::require_far_below_radius(cohesion::hamaker::forms.front(), real,
                                                      geometry(is_wall_, radii[i], radii[j]));
        return Law(scaled(real, i, j));
      },
      given);
}

cohesion::hamaker::Parameters HamakerAttraction::scaled(const cohesion::hamaker::Parameters& real,
                                                        int itype, int jtype) const {
  const double stiffness = materials_.stiffness(itype, jtype);
  const cohesion::advice::Material material = materials_.of(itype, jtype);
  const auto used = cohesion::advice::for_stiffness(stiffness, material, real);
  materials_.tell(itype, jtype, cohesion::advice::scaling_note(stiffness, material, real, used));
  return used;
}

void HamakerAttraction::require_turns_as_touching() const {
  if (is_wall_) return;  // beside one nothing turns
  const std::vector<double>& radii = smallest_radii_;
  for (int i = 1; i < static_cast<int>(radii.size()); i++)
    for (int j = i; j < static_cast<int>(radii.size()); j++) {
      if (!std::isfinite(radii[i]) || !std::isfinite(radii[j])) continue;
      try {
        cohesion::contact_solver::require_turns_as_touching(adhesion(i, j, radii[i], radii[j]),
                                                            radii[i] + radii[j]);
      } catch (const cohesion::InvalidParameter& bad) {
        LAMMPS_NS::stop(lmp_, FLERR, "cohesion model ", MODEL, ", atom types ", i, " and ", j, ": ",
                        bad.what());
      }
    }
}

ContactRange HamakerAttraction::range() const {
  ContactRange range;
  if (!is_active_) return range;  // the engine looks as far as it does without
  range.gap = outer_cutoff_;
  range.source = outer_property;
  return range;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
