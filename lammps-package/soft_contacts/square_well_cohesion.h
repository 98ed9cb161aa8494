// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_SQUARE_WELL_COHESION_H
#define COHESION_SQUARE_WELL_COHESION_H

#include <array>
#include <string>
#include <vector>

#include "advice/stiffness_scaling.h"
#include "cohesive_contact_from_script.h"
#include "event_stepping/plane_pair.h"
#include "event_stepping/sampled_well.h"
#include "event_stepping/well_edge.h"
#include "event_stepping/well_pair.h"
#include "square_well/parameters.h"

namespace LAMMPS_NS {

/// A square well as gran/square_well and wall/gran/square_well take it: what PairGranCohesive and
/// FixWallGranCohesive must be told of a cohesion.
class SquareWellCohesion {
 public:
  static constexpr char STYLE[] = "gran/square_well";
  static constexpr char HISTORY_ID[] = "NEIGH_HISTORY_GRAN_SQUARE_WELL";
  static constexpr char COEFFICIENTS[] = "stiffness K ...', see its page for the other keywords";
  static constexpr std::array<const char*, 0> SETTINGS{};
  static constexpr char MATERIAL_WORDS[] = "";
  static constexpr int RESTART_LAYOUT = 3;
  static constexpr bool HAS_CONTACT = true;

  /// What a script says about the contact of two materials.
  struct Parameters {
    cohesion::contact::ContactParameters contact;
    cohesion::square_well::Parameters well;
  };
  using Law = cohesion::square_well::Parameters;
  using EventPair = cohesion::event_stepping::WellPair;
  using EventWall = cohesion::event_stepping::PlanePair;
  using Sampled = cohesion::event_stepping::SampledWell;

  static std::vector<ContactKeyword<Parameters> > keywords() {
    return {{"well", 2, [](Parameters& p, const double* v) {
               p.well = cohesion::square_well::well(v[0], v[1]);
             }}};
  }
  static void require_valid(LAMMPS* lmp, const std::string& where, const Parameters& p,
                            const GivenKeywords&) {
    from_script(lmp, where, [&] {
      cohesion::square_well::require_valid(p.well);
      return true;
    });
  }
  static Parameters mixed(const Parameters& a, const Parameters& b) {
    return {cohesion::contact::mixed(a.contact, b.contact),
            cohesion::square_well::mixed(a.well, b.well)};
  }
  static Parameters reversed(const Parameters& p) {
    return {p.contact, cohesion::square_well::reversed(p.well)};
  }
  static double range(Scheme, const Parameters& p, double radius_i, double radius_j) {
    return cohesion::square_well::adhesion_of(p.well, radius_i, radius_j).cutoff;
  }

  /// The ratio of a well has no unit, and was asked for when it was read.
  void require_short(LAMMPS*, const std::string&, const Parameters&, double, double) const {}

  void set(LAMMPS*, const std::string&, const std::string&, const char*) {}
  int settings() const { return 0; }
  void restore_settings(int) {}

  static cohesion::advice::Material material(const Parameters&) { return {}; }
  const Parameters& scaled(LAMMPS*, const std::string&, const Parameters& p) const { return p; }
  Law law(LAMMPS*, const std::string&, const Parameters& p) const { return p.well; }
  Law no_law() const { return {}; }

  template <class Attraction>
  static Attraction of_pair(const Law& law, double radius_i, double radius_j) {
    return cohesion::square_well::adhesion_of(law, radius_i, radius_j);
  }
  template <class Attraction>
  static Attraction of_wall(const Law& law, double radius) {
    return cohesion::square_well::adhesion_of(law, radius, 0.0);
  }
};

/// The well alone, laid over the contact of another style.
class SquareWellOverlay : public SquareWellCohesion {
 public:
  static constexpr char STYLE[] = "square_well";
  static constexpr char HISTORY_ID[] = "NEIGH_HISTORY_SQUARE_WELL";
  static constexpr char COEFFICIENTS[] = "D ratio'";
  static constexpr bool HAS_CONTACT = false;
  using EventPair = cohesion::event_stepping::WellEdge;
  using Sampled = EventPair;

  static bool attracts(const Parameters& p) { return p.well.depth > 0.0; }

  /// Reads `D ratio` from arg[first] on.
  static Parameters from_script(LAMMPS* lmp, const std::string& where, int first, int narg,
                                char** arg) {
    if (narg != first + 2) lmp->error->all(FLERR, where + " takes 'D ratio'");
    Parameters p;
    p.contact.stiffness = 1.0;  // of no contact: no spring is ever asked
    p.well = cohesion::square_well::well(utils::numeric(FLERR, arg[first], false, lmp),
                                         utils::numeric(FLERR, arg[first + 1], false, lmp));
    require_valid(lmp, where, p, GivenKeywords(lmp, where));
    return p;
  }
};

}  // namespace LAMMPS_NS

#endif
