// SPDX-License-Identifier: GPL-2.0-or-later
#include "type_materials.h"

#include "comm.h"
#include "common/message.h"
#include "error.h"
#include "liggghts_api.h"
#include "modify.h"
#include "property_readers.h"
#include "word_settings.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace advice = cohesion::advice;

namespace {

constexpr const char* stiffness_property = "materialStiffness";
constexpr const char* modulus_property = "materialYoungsModulus";
constexpr const char* poisson_property = "poissonsRatio";

}  // namespace

void TypeMaterials::registerSettings(Settings& settings, bool linear_springs) {
  if (linear_springs) settings.registerOnOff("material_stiffness", has_stiffness_, false);
  settings.registerOnOff("material_modulus", has_modulus_, false);
  register_keep(lmp_, settings, who(), keep_);
}

/// A restart file keeps no keywords of models.
void TypeMaterials::warn_if_unused(const char* property, const char* kind,
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
void TypeMaterials::require_spring(const NormalModelProbe& normal) const {
  if (!has_stiffness_ && !has_modulus_ && keep_ == cohesion::contact::Keep::force)
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

void TypeMaterials::connect(PropertyRegistry& registry, const NormalModelProbe& normal) {
  require_spring(normal);
  material_stiffness_ = nullptr;
  material_modulus_ = nullptr;
  const double* poissons_ratio = nullptr;
  if (has_stiffness_) {
    material_stiffness_ = type_pair_property<stiffness_property>(registry, model_);
  } else if (has_modulus_) {
    material_modulus_ = type_property<modulus_property>(registry, model_);
    registry.registerProperty(poisson_property, &MODEL_PARAMS::createPoissonsRatio);
    poissons_ratio = registry.getVectorProperty(poisson_property, model_)->data;
  } else {
    warn_if_unused(stiffness_property, "peratomtypepair", "material_stiffness");
    warn_if_unused(modulus_property, "peratomtype", "material_modulus");
  }
  const auto of_type = [&](int type) {
    cohesion::contact::Material m;
    m.keep = keep_;
    m.exponent = cohesion::contact::hertz_power;
    cohesion::require_non_negative(modulus_property, material_modulus_[type]);
    if (material_modulus_[type] > 0.0)
      cohesion::contact::set_hertz(m, material_modulus_[type], poissons_ratio[type]);
    return m;
  };
  const auto given = [this](int i, int j) { return shown(i, j); };
  materials_.fill(
      lmp_, model_, registry.max_type(),
      [&](int i, int j) {
        if (has_modulus_) return cohesion::contact::mixed(of_type(i), of_type(j));
        if (!has_stiffness_) return cohesion::contact::Material{};
        cohesion::require_non_negative(stiffness_property, material_stiffness_[i][j]);
        return cohesion::contact::Material{material_stiffness_[i][j], keep_};
      },
      given);
  stiffnesses_.fill(
      lmp_, model_, registry.max_type(),
      [&](int i, int j) { return normal.stiffness(i, j, is_wall_); }, given);
}

std::string TypeMaterials::shown(int itype, int jtype) const {
  if (material_stiffness_)
    return Cohesion::shown(stiffness_property, material_stiffness_[itype][jtype]);
  if (material_modulus_)
    return Cohesion::shown(modulus_property, material_modulus_[itype]) + " and " +
           Cohesion::shown(modulus_property, material_modulus_[jtype]);
  return "";
}

void TypeMaterials::print(int itype, int jtype, const std::string& note) const {
  if (!note.empty() && itype <= jtype)
    LAMMPS_NS::engine_api::tell(
        lmp_, LAMMPS_NS::message(who(), ", atom types ", itype, " and ", jtype, ": ", note, "\n"));
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
