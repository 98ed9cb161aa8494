// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_STICKING_RULES_OF_LAW_H
#define COHESION_STICKING_RULES_OF_LAW_H

#include <string>

#include "advice/unlike_walls.h"
#include "contact/adhesion.h"
#include "input/cohesive_contact_from_script.h"

namespace LAMMPS_NS {

/// Of a style with this law, so far without adhesion. name: as messages call it.
template <class Cohesion>
cohesion::advice::StickingRules sticking_rules_of_law(const std::string& name, Scheme scheme) {
  cohesion::advice::StickingRules rules;
  rules.name = name;
  rules.is_exact = scheme == Scheme::exact;
  rules.wall_words =
      std::string("fix wall/") + Cohesion::STYLE + " with '" + Cohesion::ADHESION + "'";
  rules.without_words = std::string("'") + Cohesion::WITHOUT_ADHESION + "'";
  return rules;
}

/// Adds a contact that attracts by `adhesion`, of any radii, or does not.
template <class Cohesion>
void add_contact(cohesion::advice::StickingRules& rules,
                 const cohesion::contact::Adhesion& adhesion,
                 const cohesion::contact::Material& material,
                 const cohesion::contact::ContactParameters& contact) {
  if (!adhesion.attracts()) return;
  rules.adhesion = Cohesion::STYLE;
  rules.material_words = Cohesion::material_words(contact);
  rules.softenings.push_back({material, cohesion::contact::stiffness_of(contact)});
}

}  // namespace LAMMPS_NS

#endif
