// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HAMAKER_COHESION_H
#define COHESION_HAMAKER_COHESION_H

#include <array>
#include <string>
#include <type_traits>
#include <vector>

#include "contact/adhesion.h"
#include "contact_solver/contact_solver.h"
#include "hamaker/forms.h"
#include "sampled_contact/sampled_hamaker.h"
#include "soft_contacts/cohesion_law.h"
#include "soft_contacts/scaling_notes.h"

namespace LAMMPS_NS {

/// Hamaker attraction as gran/hamaker and wall/gran/hamaker take it. The object holds the style's
/// settings: the form.
class HamakerCohesion : public CohesionLaw<cohesion::hamaker::HamakerParameters> {
 public:
  static constexpr char STYLE[] = "gran/hamaker";
  static constexpr char ADHESION[] = "hamaker", WITHOUT_ADHESION[] = "hamaker 0";
  static constexpr std::array SETTINGS{"form"};
  static constexpr int RESTART_LAYOUT = 10;
  static constexpr bool BINDS_IN_RANGE = true;

  /// Coefficients of the contact of two materials.
  struct HamakerContact {
    cohesion::contact::ContactParameters contact;
    cohesion::hamaker::HamakerParameters hamaker = cohesion::hamaker::none;
    cohesion::contact::Material material;
  };
  using Parameters = HamakerContact;
  using Law = cohesion::hamaker::AnyLaw;
  using Solver = cohesion::contact_solver::ContactSolver;
  using Sampled = cohesion::sampled_contact::SampledHamaker;

  static std::vector<ContactKeyword<Parameters> > keywords();
  static void require_valid(LAMMPS*, const std::string& where, const Parameters&,
                            const SpecifiedKeywords& given);
  /// With contact::mixed, and throws as that.
  static Parameters mixed(const Parameters&, const Parameters&);
  static double range(Scheme, const Parameters&, double radius_i, double radius_j);

  /// Stops LAMMPS at a range that is not far below the radii [length]; radius_j infinite: a wall.
  void require_short(LAMMPS* lmp, const std::string& where, const Parameters& p, double radius_i,
                     double radius_j) const {
    require_far_below_radius(lmp, where, *form_, p.hamaker, radius_i, radius_j);
  }

  void set(LAMMPS*, const std::string& where, const std::string& word, const char* value);
  int settings() const { return static_cast<int>(form_ - cohesion::hamaker::forms.data()); }
  void restore_settings(int number) { form_ = &cohesion::hamaker::forms[number]; }

  static cohesion::contact::Material material(const Parameters& p) { return p.material; }
  static const char* material_words(const cohesion::contact::ContactParameters&);
  static std::string doubt(const LAMMPS*, const Parameters&);
  /// With the adhesion scaled to the stiffness when that is wished; what was done is printed, where
  /// it is not what was printed last of `where`.
  Parameters scaled(LAMMPS*, const std::string& where, Parameters);
  Law law(LAMMPS*, const std::string& where, const Parameters&) const;
  Law no_law() const { return form_->law(cohesion::hamaker::none, false); }

  template <class Attraction>
  static Attraction of_pair(const Law& law, double radius_i, double radius_j) {
    return attraction<Attraction>(law, cohesion::two_spheres(radius_i, radius_j));
  }
  template <class Attraction>
  static Attraction of_wall(const Law& law, double radius) {
    return attraction<Attraction>(law, cohesion::sphere_and_plane(radius));
  }

 private:
  template <class Attraction>
  static Attraction attraction(const Law& law, const cohesion::PairGeometry& geometry) {
    if constexpr (std::is_same_v<Attraction, cohesion::contact::Adhesion>)
      return std::visit(
          [&](const auto& l) { return cohesion::contact::adhesion_with_tail(l, geometry); }, law);
    else
      return {law, geometry};
  }

  ScalingNotes notes_;
  const cohesion::hamaker::Form* form_ = cohesion::hamaker::forms.data();
};

}  // namespace LAMMPS_NS

#endif
