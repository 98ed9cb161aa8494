// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_SQUARE_WELL_COHESION_H
#define COHESION_SQUARE_WELL_COHESION_H

#include <string>
#include <vector>

#include "contact_solver/square_well_solver.h"
#include "input/words_of_law.h"
#include "sampled_contact/sampled_well.h"
#include "soft_contacts/cohesion_law.h"
#include "square_well/parameters.h"

namespace LAMMPS_NS {

/// A square well as gran/squarewell and wall/gran/squarewell take it.
class SquareWellCohesion : public CohesionLaw<cohesion::square_well::SquareWellParameters> {
 public:
  static constexpr char STYLE[] = "gran/squarewell";
  static constexpr char ADHESION[] = "well", WITHOUT_ADHESION[] = "well 0 1";
  static constexpr int RESTART_LAYOUT = 7;

  using Solver = cohesion::contact_solver::SquareWellSolver;
  using Sampled = cohesion::sampled_contact::SampledWell;

  static std::vector<ContactKeyword<Parameters>> keywords() {
    return {{"well", "D ratio", [](Parameters& p, const double* v) {
               p.law = cohesion::square_well::well(v[0], v[1]);
             }}};
  }
  static Parameters reversed(const Parameters& p) {
    return {p.contact, cohesion::square_well::reversed(p.law)};
  }
};

/// The well alone, laid over the contact of another style.
class SquareWellOverlay : public SquareWellCohesion {
 public:
  static constexpr char STYLE[] = "squarewell";
  static constexpr char COEFFICIENTS[] = "well D ratio'";
  static constexpr bool HAS_CONTACT = false;
  using Solver = cohesion::contact_solver::WellEdgeSolver;

  static bool attracts(const Parameters& p) { return p.law.depth > 0.0; }

  /// Reads `well D ratio` from arg[first] on.
  static Parameters from_script(LAMMPS* lmp, const std::string& where, int first, int narg,
                                char** arg) {
    WordsOfLaw words(lmp, where, first, narg, arg, {{"well", 2}});
    Parameters p;
    SpecifiedKeywords given(lmp, where);
    p.contact.stiffness = 1.0;  // of no contact, any above 0
    read_keywords(lmp, where, keywords(), 0, words.count(), words.get(), p, given);
    if (!given.has("well")) lmp->error->all(FLERR, where + " takes 'well D ratio'");
    require_valid(lmp, where, p, given);
    return p;
  }
};

}  // namespace LAMMPS_NS

#endif
