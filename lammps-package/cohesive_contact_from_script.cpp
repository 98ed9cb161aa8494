// SPDX-License-Identifier: GPL-2.0-only
#include "cohesive_contact_from_script.h"

#include <array>
#include <cmath>

using namespace LAMMPS_NS;
using cohesion::contact::ContactParameters;

void LAMMPS_NS::require_valid(LAMMPS* lmp, const std::string& where, const ContactParameters& p,
                              const std::set<std::string>& given) {
  if (given.count("damping") && p.damping < 0.0)
    lmp->error->all(FLERR, where + ": damping eta must not be negative");
  if (given.count("damping") && given.count("restitution"))
    lmp->error->all(FLERR, where + ": give restitution or damping, not both");
  from_script(lmp, where, [&] {
    require_valid(p);
    return true;
  });
}

ContactParameters LAMMPS_NS::mixed(const ContactParameters& p, const ContactParameters& q) {
  const auto mean = [](double x, double y) { return std::sqrt(x * y); };
  ContactParameters m;
  m.stiffness = mean(p.stiffness, q.stiffness);
  m.restitution = mean(p.restitution, q.restitution);
  m.damping = p.damping >= 0.0 && q.damping >= 0.0 ? mean(p.damping, q.damping) : -1.0;
  m.tangential_ratio = mean(p.tangential_ratio, q.tangential_ratio);
  m.tangential_damping_ratio = mean(p.tangential_damping_ratio, q.tangential_damping_ratio);
  m.friction = mean(p.friction, q.friction);
  m.rolling_friction = mean(p.rolling_friction, q.rolling_friction);
  return m;
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
