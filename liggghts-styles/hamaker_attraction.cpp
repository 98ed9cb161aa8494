// SPDX-License-Identifier: GPL-2.0-or-later
#include <mpi.h>
// The engine's header of properties wants mpi.h before it.
#include "global_properties.h"
#include "hamaker_attraction.h"
#include "property_registry.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

constexpr const char* asked_for_by = "cohesion_model hamaker";
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

void HamakerAttraction::connect(PropertyRegistry& registry) {
  registry.registerProperty(constant_property, &make_constant);
  registry.registerProperty(surface_property, &make_surface_cutoff);
  registry.registerProperty(outer_property, &make_outer_cutoff);
  double** constant = registry.getMatrixProperty(constant_property, asked_for_by)->data;
  const double surface = registry.getScalarProperty(surface_property, asked_for_by)->data;
  outer_cutoff_ = registry.getScalarProperty(outer_property, asked_for_by)->data;

  laws_.fill(
      lmp_, MODEL, registry.max_type(),
      [&](int i, int j) {
        return Law(cohesion::hamaker::Parameters{constant[i][j], surface, outer_cutoff_});
      },
      [&](int i, int j) {
        return shown(constant_property, constant[i][j]) + ", " + shown(surface_property, surface) +
               ", " + shown(outer_property, outer_cutoff_);
      });
}

ContactRange HamakerAttraction::range() const {
  ContactRange range;
  range.gap = outer_cutoff_;
  range.source = outer_property;
  return range;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
