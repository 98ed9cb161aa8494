// SPDX-License-Identifier: GPL-2.0-only
#include "hamaker_cohesion.h"

#include "advice/stiffness_scaling.h"
#include "comm.h"
#include "mixing.h"

using namespace LAMMPS_NS;
using Parameters = HamakerCohesion::Parameters;

std::vector<ContactKeyword<Parameters> > HamakerCohesion::keywords() {
  using P = Parameters;
  return {
      {"hamaker", 1, [](P& p, const double* v) { p.hamaker.hamaker_constant = v[0]; }},
      {"cutoff", 2,
       [](P& p, const double* v) {
         p.hamaker.surface_cutoff = v[0];
         p.hamaker.outer_cutoff = v[1];
       }},
      {"material_stiffness", 1, [](P& p, const double* v) { p.material_stiffness = v[0]; }},
      {"asperity", 1, [](P& p, const double* v) { p.hamaker.asperity_radius = v[0]; }},
  };
}

void HamakerCohesion::require_valid(LAMMPS* lmp, const std::string& where, const Parameters& p,
                                    const GivenKeywords& given) {
  if (p.hamaker.hamaker_constant != 0.0 && !given.has("cutoff"))
    lmp->error->all(FLERR,
                    where + ": keyword 'hamaker' needs 'cutoff H_cut H_out', both distances");
  from_script(lmp, where, [&] {
    cohesion::hamaker::require_valid(p.hamaker);
    cohesion::require_non_negative("material_stiffness", p.material_stiffness);
    return true;
  });
}

Parameters HamakerCohesion::mixed(const Parameters& a, const Parameters& b) {
  return {cohesion::contact::mixed(a.contact, b.contact),
          cohesion::hamaker::mixed(a.hamaker, b.hamaker),
          cohesion::geometric_mean(a.material_stiffness, b.material_stiffness)};
}

double HamakerCohesion::range(Scheme scheme, const Parameters& p, double, double) {
  if (p.hamaker.hamaker_constant == 0.0) return 0.0;
  return scheme == Scheme::event ? p.hamaker.surface_cutoff : p.hamaker.outer_cutoff;
}

/// The only setting is the form.
void HamakerCohesion::set(LAMMPS* lmp, const std::string& where, const std::string&,
                          const char* value) {
  form_ = hamaker_form_from_script(lmp, where, value);
}

Parameters HamakerCohesion::scaled(LAMMPS* lmp, const std::string& where, Parameters p) const {
  if (p.material_stiffness == 0.0 || p.hamaker.hamaker_constant == 0.0) return p;
  if (form_->name != "small_gap")
    lmp->error->all(FLERR, where + ": material_stiffness scales the form small_gap only");
  const cohesion::hamaker::Parameters real = p.hamaker;
  p.hamaker = from_script(lmp, where, [&] {
    return cohesion::advice::StiffnessScaling(p.material_stiffness, p.contact.stiffness)
        .hamaker(real);
  });
  if (lmp->comm->me == 0)
    utils::logmesg(lmp, fmt::format("{}: adhesion scaled from stiffness {:.6g} to {:.6g}, so that "
                                    "as many stick: A {:.6g} -> {:.6g}, H_cut {:.6g} -> {:.6g}\n",
                                    where, p.material_stiffness, p.contact.stiffness,
                                    real.hamaker_constant, p.hamaker.hamaker_constant,
                                    real.surface_cutoff, p.hamaker.surface_cutoff));
  return p;
}

HamakerCohesion::Law HamakerCohesion::law(LAMMPS* lmp, const std::string& where,
                                          const Parameters& p) const {
  return from_script(lmp, where,
                     [&] { return form_->law(p.hamaker, p.hamaker.asperity_radius > 0.0); });
}
