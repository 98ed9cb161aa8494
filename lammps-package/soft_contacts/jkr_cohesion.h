// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_JKR_COHESION_H
#define COHESION_JKR_COHESION_H

#include <string>
#include <vector>

#include "cohesion_law.h"
#include "contact/jkr_spring_dashpot.h"
#include "contact_solver/jkr_solver.h"
#include "sampled_contact/sampled_bridge.h"
#include "sphere.h"

namespace LAMMPS_NS {

/// Besides the contact, which has all numbers of JKR's.
struct NoFurtherLaw {};
inline void require_valid(const NoFurtherLaw&) {}
inline NoFurtherLaw mixed(const NoFurtherLaw&, const NoFurtherLaw&) { return {}; }

/// JKR's contact as gran/jkr and wall/gran/jkr take it.
class JkrCohesion : public CohesionLaw<NoFurtherLaw> {
 public:
  static constexpr char STYLE[] = "gran/jkr";
  static constexpr char COEFFICIENTS[] = "normal hertz E nu surface_energy gamma ...'";
  static constexpr int RESTART_LAYOUT = 1;

  using Solver = cohesion::contact_solver::JkrSolver;
  /// Never used: scheme sampled has linear springs only.
  using Sampled = cohesion::sampled_contact::SampledBridge;

  struct Law {
    double work_of_adhesion;
  };

  static std::vector<ContactKeyword<Parameters>> keywords() {
    return {{"surface_energy", 1, [](Parameters& p, const double* v) {
               cohesion::contact::set_surface_energy(p.contact, v[0]);
             }}};
  }
  static void require_valid(LAMMPS* lmp, const std::string& where, const Parameters&,
                            const GivenKeywords& given) {
    if (!given.has("normal") || !given.has("surface_energy"))
      lmp->error->all(FLERR, where + ": needs 'normal hertz E nu' and 'surface_energy gamma'");
  }
  /// Up to where a neck tears.
  static double range(Scheme, const Parameters& p, double radius_i, double radius_j) {
    const double radius = radius_j > 0.0 ? cohesion::reduced_radius(radius_i, radius_j) : radius_i;
    return cohesion::contact::JkrSpringDashpot::tearing_gap(p.contact.modulus, radius,
                                                            p.contact.work_of_adhesion);
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
};

}  // namespace LAMMPS_NS

#endif
