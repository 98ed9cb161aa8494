// SPDX-License-Identifier: GPL-2.0-or-later
#include "hamaker_attraction.h"

#include <mpi.h>

#include <cmath>
#include <vector>

#include "common/message.h"
#include "contact_solver/turning.h"
#include "hamaker/range_of_validity.h"
#include "property_readers.h"
#include "smallest_radii.h"
#include "word_settings.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

constexpr const char* model_name = "cohesion model hamaker";
constexpr const char* constant_property = "hamakerConstant";
constexpr const char* surface_property = "hamakerSurfaceCutoff";
constexpr const char* outer_property = "hamakerOuterCutoff";

}  // namespace

void HamakerAttraction::connect(PropertyRegistry& registry, const NormalModelProbe& normal) {
  double** constant = type_pair_property<constant_property>(registry, model_name);
  const double surface = scalar_property<surface_property>(registry, model_name);
  outer_cutoff_ = scalar_property<outer_property>(registry, model_name);

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
        const cohesion::hamaker::HamakerParameters real{constant[i][j], surface, outer_cutoff_};
        is_active_ = is_active_ || real.hamaker_constant > 0.0;
        cohesion::hamaker::require_valid(real);
        if (std::isfinite(radii[i]) && (is_wall_ || std::isfinite(radii[j])))
          cohesion::hamaker::require_far_below_radius(cohesion::hamaker::forms.front(), real,
                                                      geometry(is_wall_, radii[i], radii[j]));
        return Law(materials_.scaled(real, i, j));
      },
      given);
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
