// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_COHESIVE_CONTACT_FROM_SCRIPT_H
#define COHESION_COHESIVE_CONTACT_FROM_SCRIPT_H

#include <string>
#include <type_traits>
#include <variant>

#include "advice/contact_advice.h"
#include "contact/adhesion.h"
#include "contact/contact_parameters.h"
#include "hamaker/forms.h"
#include "lammps.h"
#include "sphere.h"

namespace LAMMPS_NS {

/// What a script says about the contact of two materials.
struct CohesiveContactParameters {
  cohesion::contact::ContactParameters contact;
  cohesion::hamaker::Parameters hamaker = cohesion::hamaker::none;
  double material_stiffness = 0.0;  ///< [force/length]: scale the adhesion from it; 0: do not
};

/// How contacts are followed in time; to add one: its pair in src/event_stepping, its row in
/// `schemes`, its alternative in the styles' AnyContacts.
enum class Scheme { event, sampled };

/// What `scheme name` says.
Scheme scheme_from_script(LAMMPS*, const std::string& where, const std::string& name);
const cohesion::advice::SchemeLimits& limits_of(Scheme);

/// Reads `stiffness K [restitution e | damping eta] [tangential ratio] [tangential_damping ratio]
/// [friction mu] [hamaker A] [cutoff H_cut H_out] [asperity r]
/// [material_stiffness K]` from arg[first] on; `where` stands
/// in front of every message. Stops LAMMPS at a keyword or value that cannot be right.
CohesiveContactParameters cohesive_contact_from_script(LAMMPS*, const std::string& where, int first,
                                                       int narg, char** arg);

/// How many values a keyword of cohesive_contact_from_script takes; -1 when there is none called
/// so.
int values_of_contact_keyword(const std::string& name);
/// Their names, with commas.
std::string contact_keywords();

/// Gap up to which the scheme has to see a pair, [length].
double cohesive_range(Scheme, const CohesiveContactParameters&);

/// The parameters of a run: with the adhesion scaled to the stiffness when that is wished, which is
/// then printed.
CohesiveContactParameters scaled(LAMMPS*, const std::string& where, const cohesion::hamaker::Form&,
                                 CohesiveContactParameters);

/// The contact of unlike materials: geometric means of stiffness, restitution, friction, ratios and
/// Hamaker constant; the larger cut-offs and asperity.
CohesiveContactParameters mixed(const CohesiveContactParameters&, const CohesiveContactParameters&);

/// The attraction as a pair of the event scheme, or as SampledPair, takes it.
template <class Attraction>
Attraction attraction_of(const cohesion::hamaker::AnyLaw& law,
                         const cohesion::PairGeometry& geometry) {
  if constexpr (std::is_same_v<Attraction, cohesion::contact::Adhesion>)
    return std::visit([&](const auto& l) { return cohesion::contact::adhesion_of(l, geometry); },
                      law);
  else
    return {law, geometry};
}

/// Throws InvalidParameter.
cohesion::hamaker::AnyLaw hamaker_law(const cohesion::hamaker::Form&,
                                      const cohesion::hamaker::Parameters&);

}  // namespace LAMMPS_NS

#endif
