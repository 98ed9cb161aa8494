// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_MATERIAL_OF_TYPES_H
#define COHESION_MATERIAL_OF_TYPES_H

#include <string>

#include "advice/stiffness_scaling.h"
#include "normal_model_probe.h"
#include "table_of_types.h"

namespace LIGGGHTS {
namespace Cohesion {

/// The materials that the contacts of a cohesion model stand for, as its keywords
/// material_stiffness or material_modulus and material_keep say; none are given without them.
class MaterialOfTypes {
 public:
  /// model: who asks, in messages; wall: beside one.
  MaterialOfTypes(LAMMPS_NS::LAMMPS* lmp, const char* model, bool wall)
      : lmp_(lmp), model_(model), is_wall_(wall) {}

  /// linear_springs: whether contacts of the model may have them, and then material_stiffness.
  void registerSettings(Settings& settings, bool linear_springs);
  /// Reads fix property/global materialStiffness (peratomtypepair) or materialYoungsModulus
  /// (peratomtype). What does not go with the normal model stops the engine.
  void connect(PropertyRegistry& registry, const NormalModelProbe& normal);

  cohesion::advice::Material of(int itype, int jtype) const { return materials_.of(itype, jtype); }
  /// Behind what a message shows of a pair of types; empty: no material is given.
  std::string shown(int itype, int jtype) const;
  /// K or E* of the contact of two types.
  double stiffness(int itype, int jtype) const { return stiffnesses_.of(itype, jtype); }
  /// Prints a note on two types (advice::scaling_note), once of both orders.
  void tell(int itype, int jtype, const std::string& note) const;

 private:
  std::string who() const { return std::string("cohesion model ") + model_; }
  void require_spring(const NormalModelProbe& normal) const;
  void tell_of_unread(const char* property, const char* kind, const char* keyword) const;

  LAMMPS_NS::LAMMPS* lmp_;
  const char* model_;
  bool is_wall_;
  bool has_stiffness_ = false, has_modulus_ = false;
  cohesion::advice::Keep keep_ = cohesion::advice::Keep::escape_velocity;
  TableOfTypes<cohesion::advice::Material> materials_;
  TableOfTypes<double> stiffnesses_;
  double** stiffness_given_ = nullptr;  // null: not
  const double* modulus_given_ = nullptr;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
