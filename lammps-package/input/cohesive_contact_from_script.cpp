// SPDX-License-Identifier: GPL-2.0-only
#include "input/cohesive_contact_from_script.h"

#include <array>

#include "advice/contact_advice.h"
#include "common/former_words.h"

using namespace LAMMPS_NS;
using cohesion::contact::ContactParameters;

void LAMMPS_NS::require_valid(LAMMPS* lmp, const std::string& where, const ContactParameters& p,
                              const SpecifiedKeywords& given) {
  if (given.has("damping") && p.damping < 0.0)
    lmp->error->all(FLERR, where + ": damping eta must not be negative");
  if (given.has("damping") && given.has("restitution"))
    lmp->error->all(FLERR, where + ": give restitution or damping, not both");
  from_script(lmp, where, [&] {
    require_valid(p);
    return true;
  });
}

void LAMMPS_NS::set_normal_law(ContactParameters& p, const char* law, const double* values) {
  struct NormalLawName {
    const char* name;
    void (*set)(ContactParameters&, double, double);
  };
  static constexpr std::array laws{NormalLawName{"hertz", &cohesion::contact::set_hertz}};
  cohesion::find_by_name(laws, "normal", law).set(p, values[0], values[1]);
}

void LAMMPS_NS::require_computable(LAMMPS* lmp, const std::string& where, Scheme scheme,
                                   const ContactParameters& p) {
  if (scheme == Scheme::sampled && p.work_of_adhesion > 0.0)
    lmp->error->all(FLERR,
                    where +
                        ": scheme sampled does not follow the neck of JKR's contact beyond touch: "
                        "use scheme exact, the default");
}

namespace {

struct SchemeName {
  const char* name;
  Scheme scheme;
  const cohesion::advice::SchemeLimits* limits;
};

constexpr std::array schemes{
    SchemeName{"exact", Scheme::exact, &cohesion::advice::exact_scheme},
    SchemeName{"sampled", Scheme::sampled, &cohesion::advice::sampled_scheme},
};

}  // namespace

Scheme LAMMPS_NS::scheme_from_script(LAMMPS* lmp, const std::string& where,
                                     const std::string& name) {
  const std::string now = current_word(lmp, where, "scheme", name);
  return from_script(lmp, where,
                     [&] { return cohesion::find_by_name(schemes, "scheme", now).scheme; });
}

const cohesion::advice::SchemeLimits& LAMMPS_NS::limits_of(Scheme scheme) {
  return *schemes[static_cast<int>(scheme)].limits;
}
