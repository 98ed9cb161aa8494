// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_JKR_COHESION_H
#define COHESION_JKR_COHESION_H

#include <string>
#include <vector>

#include "advice/known_materials.h"
#include "contact/jkr_spring_dashpot.h"
#include "contact_solver/jkr_solver.h"
#include "input/material_keywords.h"
#include "sampled_contact/sampled_bridge.h"
#include "soft_contacts/cohesion_law.h"
#include "soft_contacts/scaling_notes.h"
#include "sphere.h"

namespace LAMMPS_NS {

/// JKR's contact as gran/jkr and wall/gran/jkr take it: the contact has all numbers of JKR's, and
/// the law is the material that it stands for.
class JkrCohesion : public CohesionLaw<cohesion::contact::Material> {
 public:
  static constexpr char STYLE[] = "gran/jkr";
  /// None is without it.
  static constexpr char ADHESION[] = "surface_energy", WITHOUT_ADHESION[] = "";
  static constexpr char COEFFICIENTS[] = "normal hertz E nu surface_energy gamma ...'";
  static constexpr int RESTART_LAYOUT = 3;

  using Solver = cohesion::contact_solver::JkrSolver;
  /// Never used: scheme sampled has linear springs only.
  using Sampled = cohesion::sampled_contact::SampledBridge;

  struct JkrLaw {
    double work_of_adhesion;
  };
  using Law = JkrLaw;

  static std::vector<ContactKeyword<Parameters>> keywords() {
    auto rows = material_keywords<Parameters, &material_of>(false);
    rows.push_back({"surface_energy", "gamma", [](Parameters& p, const double* v) {
                      cohesion::contact::set_surface_energy(p.contact, v[0]);
                    }});
    return rows;
  }
  static void require_valid(LAMMPS* lmp, const std::string& where, const Parameters& p,
                            const SpecifiedKeywords& given) {
    if (!given.has("normal") || !given.has("surface_energy"))
      lmp->error->all(FLERR, where + ": needs 'normal hertz E nu' and 'surface_energy gamma'");
    require_material(lmp, where, p.contact, given);
  }
  /// Up to where a neck tears.
  static double range(Scheme, const Parameters& p, double radius_i, double radius_j) {
    const double radius = radius_j > 0.0 ? cohesion::reduced_radius(radius_i, radius_j) : radius_i;
    return cohesion::contact::JkrSpringDashpot::tearing_gap(p.contact.modulus, radius,
                                                            p.contact.work_of_adhesion);
  }

  static cohesion::contact::Material material(const Parameters& p) { return p.law; }
  static const char* material_words(const cohesion::contact::ContactParameters& contact) {
    return LAMMPS_NS::material_words(contact);
  }
  static std::string doubt(const LAMMPS* lmp, const Parameters& p) {
    return cohesion::advice::above_surface_energies(
        cohesion::contact::surface_energy(p.contact.work_of_adhesion), si_units(lmp));
  }
  /// With the work of adhesion scaled to the modulus; what was done is printed.
  Parameters scaled(LAMMPS* lmp, const std::string& where, Parameters p) {
    namespace contact = cohesion::contact;
    const double modulus = contact::stiffness_of(p.contact), real = p.contact.work_of_adhesion;
    p.contact.work_of_adhesion =
        from_script(lmp, where, [&] { return contact::for_stiffness(modulus, p.law, real); });
    notes_.print(lmp, where,
                 contact::scaling_note(modulus, p.law, real, p.contact.work_of_adhesion));
    return p;
  }
  Law law(LAMMPS*, const std::string&, const Parameters& p) const {
    return {p.contact.work_of_adhesion};
  }
  Law no_law() const { return {0.0}; }

  /// The pull-off force, for the time-step check; the solver obtains the rest from the contact.
  template <class Attraction>
  static Attraction of_pair(const Law& law, double radius_i, double radius_j) {
    return of_wall<Attraction>(law, cohesion::reduced_radius(radius_i, radius_j));
  }
  template <class Attraction>
  static Attraction of_wall(const Law& law, double radius) {
    Attraction pull{};
    pull.force = cohesion::contact::JkrSpringDashpot::pull_off_force(radius, law.work_of_adhesion);
    pull.forms_at_touch = true;
    return pull;
  }

 private:
  static cohesion::contact::Material& material_of(Parameters& p) { return p.law; }

  ScalingNotes notes_;
};

}  // namespace LAMMPS_NS

#endif
