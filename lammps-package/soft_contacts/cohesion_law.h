// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_COHESION_LAW_H
#define COHESION_COHESION_LAW_H

#include <array>
#include <string>

#include "contact/stiffness_scaling.h"
#include "input/cohesive_contact_from_script.h"

namespace LAMMPS_NS {

// Found by the type of what they are given.
template <class Core>
void require_valid_law(const Core& law) {
  require_valid(law);
}
template <class Core>
Core mixed_law(const Core& a, const Core& b) {
  return mixed(a, b);
}

/// What PairGranCohesive and FixWallGranCohesive ask of a law of cohesion, for a law whose numbers
/// are a struct of the core, `Core`: it comes with require_valid(), mixed(), and adhesion_of(law,
/// radius_i, radius_j), with radius_j 0 beside a wall. A law derives from this, states
///
///   STYLE                         of the pairs; "wall/" in front: of the walls
///   ADHESION, WITHOUT_ADHESION    its keyword, and that with values of no adhesion
///   RESTART_LAYOUT                number of the layout of settings and Parameters in restart files
///   Solver                        of src/contact_solver: its normal motion in scheme exact
///   Sampled                       of src/sampled_contact: its normal motion in scheme sampled
///   keywords()                    of pair_coeff and of the fix, which set Parameters::law
///
/// and hides what is different with it. Its row in cohesion_laws.h makes it known. A new Solver
/// needs a file such as liquid_bridge_step.cpp, and a new Sampled a line in sampled_step.cpp, which
/// instantiate the steps of its pairs.
template <class Core>
class CohesionLaw {
 public:
  /// What pair_coeff takes behind `i j`, for messages.
  static constexpr char COEFFICIENTS[] = "stiffness K ...', see its page for the other keywords";
  /// Keywords of the style besides `scheme`, one value each.
  static constexpr std::array<const char*, 0> SETTINGS{};
  /// Whether the style follows contacts, by a scheme and with advice, or lies over another's.
  static constexpr bool HAS_CONTACT = true;
  /// Whether a pair is bound within the range of the attraction, range() of scheme sampled, and
  /// types without attraction never; else what a pair remembers says so.
  static constexpr bool BINDS_IN_RANGE = false;

  /// What a script says about the contact of two materials.
  struct Parameters {
    cohesion::contact::ContactParameters contact;
    Core law;
  };
  /// What acts between two materials in a run.
  using Law = Core;

  static void require_valid(LAMMPS* lmp, const std::string& where, const Parameters& p,
                            const SpecifiedKeywords&) {
    from_script(lmp, where, [&] {
      require_valid_law(p.law);
      return true;
    });
  }
  /// Unlike materials, as contact::mixed and mixed() of the law.
  static Parameters mixed(const Parameters& a, const Parameters& b) {
    return {cohesion::contact::mixed(a.contact, b.contact), mixed_law(a.law, b.law)};
  }
  /// The same contact, by its Parameters, seen from the other side.
  template <class Given>
  static const Given& reversed(const Given& p) {
    return p;
  }
  /// Gap up to which the scheme has to see a pair, [length].
  static double range(Scheme, const Parameters& p, double radius_i, double radius_j) {
    return adhesion_of(p.law, radius_i, radius_j).cutoff;
  }
  /// Stops LAMMPS at a range that is wrong for the radii [length]; radius_j infinite: a wall.
  void require_short(LAMMPS*, const std::string&, const Parameters&, double, double) const {}

  /// The settings: what a word of SETTINGS says, and all of them as a number, for restart files.
  void set(LAMMPS*, const std::string&, const std::string&, const char*) {}
  int settings() const { return 0; }
  void restore_settings(int) {}

  static cohesion::contact::Material material(const Parameters&) { return {}; }
  /// How a script names the material of a contact; empty: it cannot.
  static const char* material_words(const cohesion::contact::ContactParameters&) { return ""; }
  /// What to say of numbers that no material has; empty: nothing.
  static std::string doubt(const LAMMPS*, const Parameters&) { return ""; }
  /// The parameters of a run.
  const Parameters& scaled(LAMMPS*, const std::string&, const Parameters& p) const { return p; }
  Law law(LAMMPS*, const std::string&, const Parameters& p) const { return p.law; }
  Law no_law() const { return {}; }

  /// The attraction as solvers take it.
  template <class Attraction>
  static Attraction of_pair(const Law& law, double radius_i, double radius_j) {
    return adhesion_of(law, radius_i, radius_j);
  }
  template <class Attraction>
  static Attraction of_wall(const Law& law, double radius) {
    return adhesion_of(law, radius, 0.0);
  }
};

}  // namespace LAMMPS_NS

#endif
