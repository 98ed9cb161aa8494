// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_JKR_ATTRACTION_H
#define COHESION_JKR_ATTRACTION_H

#include <string>
#include <string_view>

#include "cohesion_defaults.h"
#include "contact/adhesion.h"
#include "contact_range.h"
#include "contact_solver/jkr_solver.h"
#include "encounter.h"
#include "lammps.h"
#include "normal_model_probe.h"
#include "type_materials.h"
#include "type_matrix.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Of the cohesion model jkr (contact/jkr_spring_dashpot.h): spring and adhesion are one law, made
/// of Hertz's contact of the engine. Scheme exact only.
class JkrAttraction : public CohesionDefaults {
 public:
  static constexpr const char* MODEL = "jkr";
  static constexpr bool BINDS_WHAT_ENTERED = true;
  static constexpr bool HAS_SAMPLED = false;
  using Solver = cohesion::contact_solver::JkrSolver;

  JkrAttraction(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup*, LAMMPS_NS::FixWallGran* wall)
      : lmp_(lmp), is_wall_(wall != nullptr), materials_(lmp, MODEL, wall != nullptr) {}

  /// Keywords of the material.
  void registerSettings(Settings& settings) { materials_.registerSettings(settings, false); }

  /// Reads fix property/global surfaceEnergy (peratomtypepair) [energy/length^2], and the material
  /// when the adhesion is to be scaled; what was done is printed. A parameter that
  /// cannot be right stops the engine with the types and the values given, and so does another
  /// normal model than hertz.
  void connect(PropertyRegistry& registry, const NormalModelProbe& normal);

  /// Up to where the neck of the largest particles tears.
  ContactRange range() const;
  bool is_active() const { return longest_neck_ > 0.0; }

  /// Its pull-off force; rj infinite: beside a wall.
  cohesion::contact::Adhesion adhesion(int itype, int jtype, double ri, double rj) const;
  /// JKR's contact, of Hertz's; rj infinite: beside a wall.
  cohesion::contact::NormalLaw contact_law(const cohesion::contact::NormalLaw& hertz, int itype,
                                           int jtype, double ri, double rj) const;

  /// Given where material_modulus is on.
  cohesion::contact::Material material(int itype, int jtype) const {
    return materials_.of(itype, jtype);
  }
  static std::string_view material_words(const NormalModelProbe& normal) {
    return normal.material_words();
  }
  std::string doubt(int itype, int jtype) const;

  // Scheme sampled does not exist.
  static constexpr bool is_out_of_reach(const ContactModels::SurfacesCloseData&, bool) {
    return true;
  }
  static bool binds(int, int, double, double, double gap, const double*) { return gap < 0.0; }
  static constexpr double force(const Encounter&) { return 0.0; }
  static constexpr double energy(int, int, double, double, double, bool) { return 0.0; }

 private:
  /// The work of adhesion of a contact, from that of its material.
  double scaled(double real, int itype, int jtype) const;

  LAMMPS_NS::LAMMPS* lmp_;
  bool is_wall_;
  TypeMaterials materials_;
  TypeMatrix<double> works_of_adhesion_;  // scaled, if wished
  TypeMatrix<double> energies_;           // as given
  double longest_neck_ = 0.0;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
