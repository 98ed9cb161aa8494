// SPDX-License-Identifier: GPL-2.0-or-later
#include "hamaker_attraction.h"

#include <mpi.h>
// The engine's header of properties wants mpi.h before it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "atom.h"
#include "contact_solver/turning.h"
#include "error.h"
#include "fix.h"
#include "global_properties.h"
#include "hamaker/range_of_validity.h"
#include "liggghts_api.h"
#include "message.h"
#include "modify.h"
#include "property_registry.h"
#include "word_settings.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

constexpr const char* asked_for_by = "cohesion model hamaker";
constexpr const char* constant_property = "hamakerConstant";
constexpr const char* surface_property = "hamakerSurfaceCutoff";
constexpr const char* outer_property = "hamakerOuterCutoff";
constexpr const char* stiffness_property = "materialStiffness";

MatrixProperty* make_constant(PropertyRegistry& registry, const char* caller, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, constant_property, caller);
}
MatrixProperty* make_stiffness(PropertyRegistry& registry, const char* caller, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, stiffness_property, caller);
}
ScalarProperty* make_surface_cutoff(PropertyRegistry& registry, const char* caller, bool) {
  return MODEL_PARAMS::createScalarProperty(registry, surface_property, caller);
}
ScalarProperty* make_outer_cutoff(PropertyRegistry& registry, const char* caller, bool) {
  return MODEL_PARAMS::createScalarProperty(registry, outer_property, caller);
}

/// A restart file keeps no keywords of models.
void tell_of_unread_stiffness(LAMMPS_NS::LAMMPS* lmp) {
  char* const property = const_cast<char*>(stiffness_property);
  char *const style = const_cast<char*>("property/global"),
              *const kind = const_cast<char*>("peratomtypepair"),
              *const caller = const_cast<char*>(asked_for_by);
  if (!lmp->modify->find_fix_property(property, style, kind, 0, 0, caller, false)) return;
  if (lmp->comm->me != 0) return;
  lmp->error->warning(FLERR,
                      "cohesion model hamaker: there is a fix property/global materialStiffness, "
                      "but material_stiffness is off, and the adhesion is not scaled; a restart "
                      "file does not keep the keyword: give it with pair_style and fix wall/gran");
}

/// One factor for a pair of types wants one spring for it.
void require_of_types(LAMMPS_NS::LAMMPS* lmp, const NormalModelProbe& normal) {
  if (normal.is_of_types()) return;
  const std::string message =
      std::string("cohesion model ") + HamakerAttraction::MODEL +
      ", material_stiffness: scales from the stiffness of the material to that of the contact, but "
      "the spring of model " +
      normal.name() + " differs from one pair of particles or overlap to the next: use model " +
      "hooke/stiffness, or give the scaled hamakerConstant and hamakerSurfaceCutoff";
  lmp->error->all(FLERR, message.c_str());
}

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

void HamakerAttraction::registerSettings(Settings& settings) {
  settings.registerOnOff("material_stiffness", has_material_, false);
  register_keep(settings, asked_for_by, keep_);
}

void HamakerAttraction::connect(PropertyRegistry& registry, const NormalModelProbe& normal) {
  registry.registerProperty(constant_property, &make_constant);
  registry.registerProperty(surface_property, &make_surface_cutoff);
  registry.registerProperty(outer_property, &make_outer_cutoff);
  double** constant = registry.getMatrixProperty(constant_property, asked_for_by)->data;
  const double surface = registry.getScalarProperty(surface_property, asked_for_by)->data;
  outer_cutoff_ = registry.getScalarProperty(outer_property, asked_for_by)->data;

  double** material = nullptr;
  if (!has_material_ && keep_ == cohesion::advice::Keep::force)
    lmp_->error->all(FLERR,
                     "cohesion model hamaker: material_keep force needs 'material_stiffness on' "
                     "and fix property/global materialStiffness");
  if (!has_material_) {
    tell_of_unread_stiffness(lmp_);
  } else {
    require_of_types(lmp_, normal);
    registry.registerProperty(stiffness_property, &make_stiffness);
    material = registry.getMatrixProperty(stiffness_property, asked_for_by)->data;
  }

  const auto given = [&](int i, int j) {
    return shown(constant_property, constant[i][j]) + ", " + shown(surface_property, surface) +
           ", " + shown(outer_property, outer_cutoff_) +
           (has_material_ ? ", " + shown(stiffness_property, material[i][j]) : "");
  };
  constants_.fill(
      lmp_, MODEL, registry.max_type(), [&](int i, int j) { return constant[i][j]; }, given);
  materials_.fill(
      lmp_, MODEL, registry.max_type(),
      [&](int i, int j) {
        if (!has_material_) return cohesion::advice::Material{};
        cohesion::require_non_negative(stiffness_property, material[i][j]);
        return cohesion::advice::Material{material[i][j], keep_};
      },
      given);
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
        return Law(has_material_ ? scaled(real, materials_.of(i, j), normal, i, j) : real);
      },
      given);
}

cohesion::hamaker::Parameters HamakerAttraction::scaled(const cohesion::hamaker::Parameters& real,
                                                        const cohesion::advice::Material& material,
                                                        const NormalModelProbe& normal, int itype,
                                                        int jtype) const {
  const double stiffness = normal.stiffness(itype, jtype, is_wall_);
  const cohesion::hamaker::Parameters used =
      cohesion::advice::for_stiffness(stiffness, material, real);
  const std::string note = cohesion::advice::scaling_note(stiffness, material, real, used);
  if (!note.empty() && itype <= jtype)
    LAMMPS_NS::engine_api::tell(lmp_, LAMMPS_NS::message("cohesion model ", MODEL, ", atom types ",
                                                         itype, " and ", jtype, ": ", note, "\n"));
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
