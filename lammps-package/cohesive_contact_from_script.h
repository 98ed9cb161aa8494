// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_COHESIVE_CONTACT_FROM_SCRIPT_H
#define COHESION_COHESIVE_CONTACT_FROM_SCRIPT_H

#include <string>

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
};

/// Reads `stiffness K [restitution e | damping eta] [tangential ratio] [tangential_damping ratio]
/// [friction mu] [hamaker A] [cutoff H_cut H_out] [asperity r]` from arg[first] on; `where` stands
/// in front of every message. Stops LAMMPS at a keyword or value that cannot be right.
CohesiveContactParameters cohesive_contact_from_script(LAMMPS*, const std::string& where, int first,
                                                       int narg, char** arg);

/// How many values a keyword of cohesive_contact_from_script takes; -1 when there is none called
/// so.
int values_of_contact_keyword(const std::string& name);
/// Their names, with commas.
std::string contact_keywords();

/// The contact of unlike materials: geometric means of stiffness, restitution, friction, ratios and
/// Hamaker constant; the larger cut-offs and asperity.
CohesiveContactParameters mixed(const CohesiveContactParameters&, const CohesiveContactParameters&);

/// The Hamaker law of a pair of materials as the event scheme takes it.
cohesion::contact::Adhesion adhesion_of(const cohesion::hamaker::AnyLaw&,
                                        const cohesion::PairGeometry&);

/// Throws InvalidParameter.
cohesion::hamaker::AnyLaw hamaker_law(const cohesion::hamaker::Form&,
                                      const cohesion::hamaker::Parameters&);

}  // namespace LAMMPS_NS

#endif
