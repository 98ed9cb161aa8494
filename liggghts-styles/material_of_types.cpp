// SPDX-License-Identifier: GPL-2.0-or-later
#include "material_of_types.h"

#include <mpi.h>
// The engine's header of properties wants mpi.h before it.
#include "comm.h"
#include "common/message.h"
#include "error.h"
#include "global_properties.h"
#include "liggghts_api.h"
#include "modify.h"
#include "property_registry.h"
#include "word_settings.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace advice = cohesion::advice;

namespace {

constexpr const char* stiffness_property = "materialStiffness";
constexpr const char* modulus_property = "materialYoungsModulus";
constexpr const char* poisson_property = "poissonsRatio";

MatrixProperty* make_stiffness(PropertyRegistry& registry, const char* caller, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, stiffness_property, caller);
}
VectorProperty* make_modulus(PropertyRegistry& registry, const char* caller, bool) {
  return MODEL_PARAMS::createPerTypeProperty(registry, modulus_property, caller);
}

}  // namespace

void MaterialOfTypes::registerSettings(Settings& settings, bool linear_springs) {
  if (linear_springs) settings.registerOnOff("material_stiffness", has_stiffness_, false);
  settings.registerOnOff("material_modulus", has_modulus_, false);
  register_keep(lmp_, settings, who(), keep_);
}

/// A restart file keeps no keywords of models.
void MaterialOfTypes::tell_of_unread(const char* property, const char* kind,
                                     const char* keyword) const {
  const auto word = [](const char* text) { return const_cast<char*>(text); };
  if (!lmp_->modify->find_fix_property(word(property), word("property/global"), word(kind), 0, 0,
                                       word(model_), false) ||
      lmp_->comm->me != 0)
    return;
  lmp_->error->warning(
      FLERR,
      LAMMPS_NS::message(who(), ": there is a fix property/global ", property, ", but ", keyword,
                         " is off, and the adhesion is not scaled; a restart file "
                         "does not keep the keyword: give it with pair_style and fix "
                         "wall/gran")
          .c_str());
}

/// One factor for a pair of types wants one spring for it.
void MaterialOfTypes::require_spring(const NormalModelProbe& normal) const {
  if (!has_stiffness_ && !has_modulus_ && keep_ == advice::Keep::force)
    LAMMPS_NS::stop(lmp_, FLERR, who(),
                    ": material_keep force needs 'material_stiffness on' with fix property/global "
                    "materialStiffness, or with model hertz 'material_modulus on' with "
                    "materialYoungsModulus");
  const auto require = [&](bool is_on, const char* keyword, const char* number) {
    if (!is_on || normal.material_keyword() == keyword) return;
    LAMMPS_NS::stop(lmp_, FLERR, who(), ", ", keyword, ": scales from the ", number,
                    " of the material to that of the contact, and model ", normal.name(),
                    " has no such number for two types: use 'material_stiffness on' with model "
                    "hooke/stiffness, 'material_modulus on' with model hertz, or give the scaled "
                    "properties of the adhesion");
  };
  require(has_stiffness_, "material_stiffness", "stiffness");
  require(has_modulus_, "material_modulus", "modulus");
}

void MaterialOfTypes::connect(PropertyRegistry& registry, const NormalModelProbe& normal) {
  require_spring(normal);
  stiffness_given_ = nullptr;
  modulus_given_ = nullptr;
  const double* poissons_ratio = nullptr;
  if (has_stiffness_) {
    registry.registerProperty(stiffness_property, &make_stiffness);
    stiffness_given_ = registry.getMatrixProperty(stiffness_property, model_)->data;
  } else if (has_modulus_) {
    registry.registerProperty(modulus_property, &make_modulus);
    registry.registerProperty(poisson_property, &MODEL_PARAMS::createPoissonsRatio);
    modulus_given_ = registry.getVectorProperty(modulus_property, model_)->data;
    poissons_ratio = registry.getVectorProperty(poisson_property, model_)->data;
  } else {
    tell_of_unread(stiffness_property, "peratomtypepair", "material_stiffness");
    tell_of_unread(modulus_property, "peratomtype", "material_modulus");
  }
  const auto of_type = [&](int type) {
    advice::Material m;
    m.keep = keep_;
    m.exponent = advice::hertz_power;
    cohesion::require_non_negative(modulus_property, modulus_given_[type]);
    if (modulus_given_[type] > 0.0)
      advice::set_hertz(m, modulus_given_[type], poissons_ratio[type]);
    return m;
  };
  const auto given = [this](int i, int j) { return shown(i, j); };
  materials_.fill(
      lmp_, model_, registry.max_type(),
      [&](int i, int j) {
        if (has_modulus_) return advice::mixed(of_type(i), of_type(j));
        if (!has_stiffness_) return advice::Material{};
        cohesion::require_non_negative(stiffness_property, stiffness_given_[i][j]);
        return advice::Material{stiffness_given_[i][j], keep_};
      },
      given);
  stiffnesses_.fill(
      lmp_, model_, registry.max_type(),
      [&](int i, int j) { return normal.stiffness(i, j, is_wall_); }, given);
}

std::string MaterialOfTypes::shown(int itype, int jtype) const {
  if (stiffness_given_) return Cohesion::shown(stiffness_property, stiffness_given_[itype][jtype]);
  if (modulus_given_)
    return Cohesion::shown(modulus_property, modulus_given_[itype]) + " and " +
           Cohesion::shown(modulus_property, modulus_given_[jtype]);
  return "";
}

void MaterialOfTypes::tell(int itype, int jtype, const std::string& note) const {
  if (!note.empty() && itype <= jtype)
    LAMMPS_NS::engine_api::tell(
        lmp_, LAMMPS_NS::message(who(), ", atom types ", itype, " and ", jtype, ": ", note, "\n"));
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
