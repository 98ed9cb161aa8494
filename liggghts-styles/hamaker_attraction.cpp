// SPDX-License-Identifier: GPL-2.0-or-later
#include "hamaker_attraction.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "atom.h"
#include "common/message.h"
#include "contact_solver/turning.h"
#include "error.h"
#include "fix.h"
#include "hamaker/range_of_validity.h"
#include "liggghts_api.h"
#include "modify.h"
#include "property_readers.h"
#include "word_settings.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

constexpr const char* model_name = "cohesion model hamaker";
constexpr const char* constant_property = "hamakerConstant";
constexpr const char* surface_property = "hamakerSurfaceCutoff";
constexpr const char* outer_property = "hamakerOuterCutoff";

/// By type, of all particles and of those still to be inserted, [length]; infinite: there are none.
std::vector<double> smallest_radii(const LAMMPS_NS::LAMMPS* lmp) {
  const LAMMPS_NS::Atom* const atom = lmp->atom;
  std::vector<double> mine(atom->ntypes + 1, std::numeric_limits<double>::infinity());
  const auto take = [&](int type, double radius) { mine[type] = std::min(mine[type], radius); };
  for (int i = 0; i < atom->nlocal; i++) take(atom->type[i], atom->radius[i]);
  for (int k = 0; k < lmp->modify->nfix; k++)
    for (int type = 1; type <= atom->ntypes; type++) {
      const double inserted = lmp->modify->fix[k]->min_rad(type);
      if (inserted > 0.0) take(type, inserted);
    }
  std::vector<double> all(mine.size());
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_MIN,
                lmp->world);
  return all;
}

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
        lmp_->error->all(FLERR, LAMMPS_NS::message("cohesion model ", MODEL, ", atom types ", i,
                                                   " and ", j, ": ", bad.what())
                                    .c_str());
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
