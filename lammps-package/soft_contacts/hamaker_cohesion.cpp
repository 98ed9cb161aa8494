// SPDX-License-Identifier: GPL-2.0-only
#include "soft_contacts/hamaker_cohesion.h"

#include "advice/known_materials.h"
#include "common/plausible_sizes.h"
#include "input/hamaker_keywords.h"
#include "input/material_keywords.h"

using namespace LAMMPS_NS;
using Parameters = HamakerCohesion::Parameters;

static cohesion::hamaker::HamakerParameters& hamaker_of(Parameters& p) { return p.hamaker; }
static cohesion::contact::Material& material_of(Parameters& p) { return p.material; }

std::vector<ContactKeyword<Parameters>> HamakerCohesion::keywords() {
  auto rows = hamaker_keywords<Parameters, &hamaker_of>();
  const auto material = material_keywords<Parameters, &material_of>(true);
  rows.insert(rows.end(), material.begin(), material.end());
  return rows;
}

void HamakerCohesion::require_valid(LAMMPS* lmp, const std::string& where, const Parameters& p,
                                    const SpecifiedKeywords& given) {
  if (p.hamaker.hamaker_constant != 0.0 && !given.has("cutoff"))
    lmp->error->all(FLERR,
                    where + ": keyword 'hamaker' needs 'cutoff H_cut H_out', both distances");
  require_one_roughness(lmp, where, given);
  require_material(lmp, where, p.contact, given);
  from_script(lmp, where, [&] {
    cohesion::hamaker::require_valid(p.hamaker);
    cohesion::contact::require_valid(p.material);
    return true;
  });
}

Parameters HamakerCohesion::mixed(const Parameters& a, const Parameters& b) {
  return {cohesion::contact::mixed(a.contact, b.contact),
          cohesion::hamaker::mixed(a.hamaker, b.hamaker),
          cohesion::contact::mixed(a.material, b.material)};
}

double HamakerCohesion::range(Scheme scheme, const Parameters& p, double, double) {
  if (p.hamaker.hamaker_constant == 0.0) return 0.0;
  return scheme == Scheme::exact ? p.hamaker.surface_cutoff : p.hamaker.outer_cutoff;
}

/// The only setting is the form.
void HamakerCohesion::set(LAMMPS* lmp, const std::string& where, const std::string&,
                          const char* value) {
  form_ = hamaker_form_from_script(lmp, where, value);
}

const char* HamakerCohesion::material_words(const cohesion::contact::ContactParameters& contact) {
  return LAMMPS_NS::material_words(contact);
}

std::string HamakerCohesion::doubt(const LAMMPS* lmp, const Parameters& p) {
  return cohesion::advice::above_hamaker_constants(p.hamaker.hamaker_constant, si_units(lmp));
}

Parameters HamakerCohesion::scaled(LAMMPS* lmp, const std::string& where, Parameters p) {
  namespace contact = cohesion::contact;
  const cohesion::hamaker::HamakerParameters real = p.hamaker;
  const double stiffness = contact::stiffness_of(p.contact);
  const bool scales = real.hamaker_constant > 0.0 && contact::is_scaled(p.material, stiffness);
  if (scales && (form_->name != "small_gap" || real.asperity_radius > 0.0))
    lmp->error->all(FLERR, where + ": " + material_words(p.contact) +
                               " scales the form small_gap only, without asperities; "
                               "'material_keep force' leaves any adhesion as it is");
  p.hamaker =
      from_script(lmp, where, [&] { return contact::for_stiffness(stiffness, p.material, real); });
  notes_.print(lmp, where, contact::scaling_note(stiffness, p.material, real, p.hamaker));
  return p;
}

HamakerCohesion::Law HamakerCohesion::law(LAMMPS* lmp, const std::string& where,
                                          const Parameters& p) const {
  return from_script(lmp, where,
                     [&] { return form_->law(p.hamaker, p.hamaker.asperity_radius > 0.0); });
}
