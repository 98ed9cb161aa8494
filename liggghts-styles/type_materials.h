// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_TYPE_MATERIALS_H
#define COHESION_TYPE_MATERIALS_H

#include <string>

#include "contact/stiffness_scaling.h"
#include "normal_model_probe.h"
#include "type_matrix.h"

namespace LIGGGHTS {
namespace Cohesion {

/// The materials that the contacts of a cohesion model stand for, as its keywords
/// material_stiffness or material_modulus and material_keep say; none are given without them.
class TypeMaterials {
 public:
  /// model: who asks, in messages; wall: beside one.
  TypeMaterials(LAMMPS_NS::LAMMPS* lmp, const char* model, bool wall)
      : lmp_(lmp), model_(model), is_wall_(wall) {}

  /// linear_springs: whether contacts of the model may have them, and then material_stiffness.
  void registerSettings(Settings& settings, bool linear_springs);
  /// Reads fix property/global materialStiffness (peratomtypepair) or materialYoungsModulus
  /// (peratomtype). What does not go with the normal model stops the engine.
  void connect(PropertyRegistry& registry, const NormalModelProbe& normal);

  cohesion::contact::Material of(int itype, int jtype) const { return materials_.of(itype, jtype); }
  /// Behind what a message shows of a pair of types; empty: no material is given.
  std::string shown(int itype, int jtype) const;
  /// K or E* of the contact of two types.
  double stiffness(int itype, int jtype) const { return stiffnesses_.of(itype, jtype); }
  /// The adhesion of two types, scaled from the stiffness of the material to that of the contact
  /// (cohesion::contact::for_stiffness). Prints the scaling, once for both orders of the types.
  template <class Adhesion>
  Adhesion scaled(const Adhesion& real, int itype, int jtype) const {
    const cohesion::contact::Material material = of(itype, jtype);
    const double contact = stiffness(itype, jtype);
    const Adhesion used = cohesion::contact::for_stiffness(contact, material, real);
    print(itype, jtype, cohesion::contact::scaling_note(contact, material, real, used));
    return used;
  }

 private:
  std::string who() const { return std::string("cohesion model ") + model_; }
  void require_spring(const NormalModelProbe& normal) const;
  void warn_if_unused(const char* property, const char* kind, const char* keyword) const;
  void print(int itype, int jtype, const std::string& note) const;

  LAMMPS_NS::LAMMPS* lmp_;
  const char* model_;
  bool is_wall_;
  bool has_stiffness_ = false, has_modulus_ = false;
  cohesion::contact::Keep keep_ = cohesion::contact::Keep::escape_velocity;
  TypeMatrix<cohesion::contact::Material> materials_;
  TypeMatrix<double> stiffnesses_;
  double** material_stiffness_ = nullptr;  // null where the script has none
  const double* material_modulus_ = nullptr;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
