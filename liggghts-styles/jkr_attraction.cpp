// SPDX-License-Identifier: GPL-2.0-or-later
#include "jkr_attraction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "advice/known_materials.h"
#include "common/message.h"
#include "common/plausible_sizes.h"
#include "contact/contact_parameters.h"
#include "property_readers.h"
#include "sphere.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

constexpr const char* model_name = "cohesion model jkr";
constexpr const char* energy_property = "surfaceEnergy";

/// rj infinite: beside a wall.
double reduced_radius(double ri, double rj) {
  return std::isfinite(rj) ? cohesion::reduced_radius(ri, rj) : ri;
}

/// Hertz's contact where nothing adheres.
cohesion::contact::NormalLaw jkr_law(const cohesion::contact::HertzSpringDashpot& hertz,
                                     double radius, double work) {
  if (work == 0.0) return hertz;
  return cohesion::contact::JkrSpringDashpot(hertz, radius, work);
}

}  // namespace

void JkrAttraction::connect(PropertyRegistry& registry, const NormalModelProbe& normal) {
  if (normal.name() != "hertz")
    LAMMPS_NS::stop(lmp_, FLERR,
                    "cohesion model jkr: needs 'model hertz', whose elasticity and restitution its "
                    "contact has; model ",
                    normal.name(), " was given");
  double** energy = type_pair_property<energy_property>(registry, model_name);
  const double largest = registry.max_radius();
  longest_neck_ = 0.0;
  materials_.connect(registry, normal);
  const auto given = [&](int i, int j) {
    const std::string of_material = materials_.shown(i, j);
    return shown(energy_property, energy[i][j]) + (of_material.empty() ? "" : ", " + of_material);
  };
  energies_.fill(
      lmp_, MODEL, registry.max_type(), [&](int i, int j) { return energy[i][j]; }, given);
  works_of_adhesion_.fill(
      lmp_, MODEL, registry.max_type(),
      [&](int i, int j) {
        const double work = scaled(cohesion::contact::work_of_adhesion(energy[i][j]), i, j);
        const auto hertz = std::get<cohesion::contact::HertzSpringDashpot>(
            normal.law({i, j, largest, largest, 1.0, 0.0, is_wall_}));
        const double partner = is_wall_ ? std::numeric_limits<double>::infinity() : largest;
        const auto law = jkr_law(hertz, reduced_radius(largest, partner), work);
        longest_neck_ = std::max(longest_neck_, -cohesion::contact::lowest_overlap(law));
        return work;
      },
      given);
}

double JkrAttraction::scaled(double real, int itype, int jtype) const {
  if (real == 0.0) return 0.0;
  return materials_.scaled(real, itype, jtype);
}

ContactRange JkrAttraction::range() const {
  ContactRange range;
  range.gap = longest_neck_;
  range.source = "the gap at which necks tear";
  return range;
}

cohesion::contact::Adhesion JkrAttraction::adhesion(int itype, int jtype, double ri,
                                                    double rj) const {
  cohesion::contact::Adhesion pull;
  pull.force = cohesion::contact::JkrSpringDashpot::pull_off_force(
      reduced_radius(ri, rj), works_of_adhesion_.of(itype, jtype));
  pull.forms_at_touch = true;
  return pull;
}

std::string JkrAttraction::doubt(int itype, int jtype) const {
  return cohesion::advice::above_surface_energies(energies_.of(itype, jtype),
                                                  LAMMPS_NS::si_units(lmp_));
}

cohesion::contact::NormalLaw JkrAttraction::contact_law(const cohesion::contact::NormalLaw& hertz,
                                                        int itype, int jtype, double ri,
                                                        double rj) const {
  return jkr_law(std::get<cohesion::contact::HertzSpringDashpot>(hertz), reduced_radius(ri, rj),
                 works_of_adhesion_.of(itype, jtype));
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
