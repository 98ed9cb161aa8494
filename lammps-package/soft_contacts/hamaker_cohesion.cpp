// SPDX-License-Identifier: GPL-2.0-only
#include "hamaker_cohesion.h"

#include "comm.h"
#include "hamaker_keywords.h"
#include "named_table.h"

using namespace LAMMPS_NS;
using Parameters = HamakerCohesion::Parameters;

static cohesion::hamaker::Parameters& hamaker_of(Parameters& p) { return p.hamaker; }

std::vector<ContactKeyword<Parameters>> HamakerCohesion::keywords() {
  using P = Parameters;
  auto rows = hamaker_keywords<P, &hamaker_of>();
  rows.push_back(
      {"material_stiffness", 1, [](P& p, const double* v) { p.material.stiffness = v[0]; }});
  rows.push_back({"material_keep", 1, nullptr, [](P& p, const char* word, const double*) {
                    p.material.keep =
                        cohesion::find_by_name(cohesion::advice::keeps, "material_keep", word).keep;
                  }});
  return rows;
}

void HamakerCohesion::require_valid(LAMMPS* lmp, const std::string& where, const Parameters& p,
                                    const GivenKeywords& given) {
  if (p.hamaker.hamaker_constant != 0.0 && !given.has("cutoff"))
    lmp->error->all(FLERR,
                    where + ": keyword 'hamaker' needs 'cutoff H_cut H_out', both distances");
  require_one_roughness(lmp, where, given);
  if (given.has("material_keep") && !given.has("material_stiffness"))
    lmp->error->all(FLERR, where +
                               ": keyword 'material_keep' needs 'material_stiffness K_m', the "
                               "stiffness of the material");
  if (given.has("material_stiffness") && p.contact.is_hertz())
    lmp->error->all(FLERR,
                    where +
                        ": material_stiffness is of linear springs; with 'normal hertz' give "
                        "E of the contact, and hamaker and cutoff as they are to act");
  from_script(lmp, where, [&] {
    cohesion::hamaker::require_valid(p.hamaker);
    cohesion::require_non_negative("material_stiffness", p.material.stiffness);
    return true;
  });
}

Parameters HamakerCohesion::mixed(const Parameters& a, const Parameters& b) {
  return {cohesion::contact::mixed(a.contact, b.contact),
          cohesion::hamaker::mixed(a.hamaker, b.hamaker),
          cohesion::advice::mixed(a.material, b.material)};
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

Parameters HamakerCohesion::scaled(LAMMPS* lmp, const std::string& where, Parameters p) {
  namespace advice = cohesion::advice;
  const cohesion::hamaker::Parameters real = p.hamaker;
  const bool scales =
      real.hamaker_constant > 0.0 && advice::is_scaled(p.material, p.contact.stiffness);
  if (scales && (form_->name != "small_gap" || real.asperity_radius > 0.0))
    lmp->error->all(FLERR, where +
                               ": material_stiffness scales the form small_gap only, without "
                               "asperities; 'material_keep force' leaves any adhesion as it is");
  p.hamaker = from_script(
      lmp, where, [&] { return advice::for_stiffness(p.contact.stiffness, p.material, real); });
  const std::string told = advice::scaling_note(p.contact.stiffness, p.material, real, p.hamaker);
  if (told_[where] != told && !told.empty() && lmp->comm->me == 0)
    utils::logmesg(lmp, where + ": " + told + "\n");
  told_[where] = told;
  return p;
}

HamakerCohesion::Law HamakerCohesion::law(LAMMPS* lmp, const std::string& where,
                                          const Parameters& p) const {
  return from_script(lmp, where,
                     [&] { return form_->law(p.hamaker, p.hamaker.asperity_radius > 0.0); });
}
