// SPDX-License-Identifier: GPL-2.0-only
#include "cohesive_contact_from_script.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "advice/stiffness_scaling.h"
#include "comm.h"
#include "law_from_script.h"

using namespace LAMMPS_NS;
using cohesion::contact::ContactParameters;

namespace {

struct Keyword {
  const char* name;
  int values;
  void (*set)(CohesiveContactParameters&, const double*);
};

constexpr std::array keywords{
    Keyword{"stiffness", 1, [](auto& p, const double* v) { p.contact.stiffness = v[0]; }},
    Keyword{"restitution", 1, [](auto& p, const double* v) { p.contact.restitution = v[0]; }},
    Keyword{"damping", 1, [](auto& p, const double* v) { p.contact.damping = v[0]; }},
    Keyword{"tangential", 1, [](auto& p, const double* v) { p.contact.tangential_ratio = v[0]; }},
    Keyword{"tangential_damping", 1,
            [](auto& p, const double* v) { p.contact.tangential_damping_ratio = v[0]; }},
    Keyword{"friction", 1, [](auto& p, const double* v) { p.contact.friction = v[0]; }},
    Keyword{"hamaker", 1, [](auto& p, const double* v) { p.hamaker.hamaker_constant = v[0]; }},
    Keyword{"cutoff", 2,
            [](auto& p, const double* v) {
              p.hamaker.surface_cutoff = v[0];
              p.hamaker.outer_cutoff = v[1];
            }},
    Keyword{"material_stiffness", 1, [](auto& p, const double* v) { p.material_stiffness = v[0]; }},
    Keyword{"asperity", 1, [](auto& p, const double* v) { p.hamaker.asperity_radius = v[0]; }},
};

}  // namespace

int LAMMPS_NS::values_of_contact_keyword(const std::string& name) {
  for (const Keyword& keyword : keywords)
    if (name == keyword.name) return keyword.values;
  return -1;
}

std::string LAMMPS_NS::contact_keywords() {
  std::string all;
  for (const Keyword& keyword : keywords)
    all += (all.empty() ? "" : ", ") + std::string(keyword.name);
  return all;
}

CohesiveContactParameters LAMMPS_NS::cohesive_contact_from_script(LAMMPS* lmp,
                                                                  const std::string& where,
                                                                  int first, int narg, char** arg) {
  CohesiveContactParameters p;
  bool has_cutoff = false;
  std::string both;
  for (int i = first; i < narg;) {
    const Keyword& keyword = *from_script(
        lmp, where, [&] { return &cohesion::find_by_name(keywords, "keyword", arg[i]); });
    if (i + keyword.values >= narg)
      lmp->error->all(FLERR, where + ": keyword '" + keyword.name + "' takes " +
                                 std::to_string(keyword.values) + " value(s)");
    double values[2] = {0.0, 0.0};
    for (int k = 0; k < keyword.values; k++)
      values[k] = utils::numeric(FLERR, arg[i + 1 + k], false, lmp);
    keyword.set(p, values);
    const std::string name = keyword.name;
    has_cutoff = has_cutoff || name == "cutoff";
    if (name == "restitution" || name == "damping") both += name;
    if (name == "damping" && values[0] < 0.0)
      lmp->error->all(FLERR, where + ": damping eta must not be negative");
    i += 1 + keyword.values;
  }
  if (both.size() > std::string("restitution").size())
    lmp->error->all(FLERR, where + ": give restitution or damping, not both");
  if (p.hamaker.hamaker_constant != 0.0 && !has_cutoff)
    lmp->error->all(FLERR,
                    where + ": keyword 'hamaker' needs 'cutoff H_cut H_out', both distances");
  from_script(lmp, where, [&] {
    require_valid(p.contact);
    require_valid(p.hamaker);
    cohesion::require_non_negative("material_stiffness", p.material_stiffness);
    return true;
  });
  return p;
}

CohesiveContactParameters LAMMPS_NS::mixed(const CohesiveContactParameters& a,
                                           const CohesiveContactParameters& b) {
  const auto mean = [](double x, double y) { return std::sqrt(x * y); };
  const ContactParameters& p = a.contact;
  const ContactParameters& q = b.contact;
  CohesiveContactParameters m;
  m.contact.stiffness = mean(p.stiffness, q.stiffness);
  m.contact.restitution = mean(p.restitution, q.restitution);
  m.contact.damping = p.damping >= 0.0 && q.damping >= 0.0 ? mean(p.damping, q.damping) : -1.0;
  m.contact.tangential_ratio = mean(p.tangential_ratio, q.tangential_ratio);
  m.contact.tangential_damping_ratio = mean(p.tangential_damping_ratio, q.tangential_damping_ratio);
  m.contact.friction = mean(p.friction, q.friction);
  m.hamaker = {mean(a.hamaker.hamaker_constant, b.hamaker.hamaker_constant),
               std::max(a.hamaker.surface_cutoff, b.hamaker.surface_cutoff),
               std::max(a.hamaker.outer_cutoff, b.hamaker.outer_cutoff),
               std::max(a.hamaker.asperity_radius, b.hamaker.asperity_radius)};
  m.material_stiffness = mean(a.material_stiffness, b.material_stiffness);
  return m;
}

CohesiveContactParameters LAMMPS_NS::scaled(LAMMPS* lmp, const std::string& where,
                                            const cohesion::hamaker::Form& form,
                                            CohesiveContactParameters p) {
  if (p.material_stiffness == 0.0 || p.hamaker.hamaker_constant == 0.0) return p;
  if (form.name != "small_gap")
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

namespace {

struct SchemeName {
  const char* name;
  Scheme scheme;
  const cohesion::advice::SchemeLimits* limits;
};

constexpr std::array schemes{
    SchemeName{"event", Scheme::event, &cohesion::advice::event_scheme},
    SchemeName{"sampled", Scheme::sampled, &cohesion::advice::sampled_scheme},
};

}  // namespace

Scheme LAMMPS_NS::scheme_from_script(LAMMPS* lmp, const std::string& where,
                                     const std::string& name) {
  return from_script(lmp, where,
                     [&] { return cohesion::find_by_name(schemes, "scheme", name).scheme; });
}

const cohesion::advice::SchemeLimits& LAMMPS_NS::limits_of(Scheme scheme) {
  return *schemes[static_cast<int>(scheme)].limits;
}

cohesion::hamaker::AnyLaw LAMMPS_NS::hamaker_law(const cohesion::hamaker::Form& form,
                                                 const cohesion::hamaker::Parameters& p) {
  return form.law(p, p.asperity_radius > 0.0);
}

double LAMMPS_NS::cohesive_range(Scheme scheme, const CohesiveContactParameters& p) {
  if (p.hamaker.hamaker_constant == 0.0) return 0.0;
  return scheme == Scheme::event ? p.hamaker.surface_cutoff : p.hamaker.outer_cutoff;
}
