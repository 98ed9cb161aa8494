// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_MATERIAL_KEYWORDS_H
#define COHESION_MATERIAL_KEYWORDS_H

#include <string>
#include <vector>

#include "contact/stiffness_scaling.h"
#include "input/cohesive_contact_from_script.h"

namespace LAMMPS_NS {

/// `material_stiffness K | material_modulus E nu`, `material_keep name`, of what material() finds
/// among the parameters P. The first is there where contacts may have linear springs.
template <class P, cohesion::contact::Material& (*material)(P&)>
std::vector<ContactKeyword<P>> material_keywords(bool linear_springs) {
  std::vector<ContactKeyword<P>> rows{
      {"material_modulus", "E_m nu_m",
       [](P& p, const double* v) { cohesion::contact::set_hertz(material(p), v[0], v[1]); }},
      {"material_keep", "name", nullptr, [](P& p, const char* word, const double*) {
         material(p).keep =
             cohesion::find_by_name(cohesion::contact::keeps, "material_keep", word).keep;
       }}};
  if (linear_springs)
    rows.insert(rows.begin(), {"material_stiffness", "K_m",
                               [](P& p, const double* v) { material(p).stiffness = v[0]; }});
  return rows;
}

/// How a script names the material of this contact.
inline const char* material_words(const cohesion::contact::ContactParameters& contact) {
  return contact.is_hertz() ? "'material_modulus E_m nu_m'" : "'material_stiffness K_m'";
}

/// Stops LAMMPS at keywords of the material that do not go with the contact.
inline void require_material(LAMMPS* lmp, const std::string& where,
                             const cohesion::contact::ContactParameters& contact,
                             const SpecifiedKeywords& given) {
  const bool linear = given.has("material_stiffness"), hertz = given.has("material_modulus");
  if (linear && contact.is_hertz())
    lmp->error->all(FLERR, where +
                               ": keyword 'material_stiffness' is of linear springs; with 'normal "
                               "hertz' give 'material_modulus E_m nu_m'");
  if (hertz && !contact.is_hertz())
    lmp->error->all(FLERR, where +
                               ": keyword 'material_modulus' is of 'normal hertz'; with "
                               "'stiffness' give 'material_stiffness K_m'");
  if (given.has("material_keep") && !linear && !hertz)
    lmp->error->all(FLERR, where + ": keyword 'material_keep' needs " + material_words(contact) +
                               ", of the material");
}

}  // namespace LAMMPS_NS

#endif
