// SPDX-License-Identifier: GPL-2.0-only
// The part of FixWallGranCohesive for the time-step check and for the sticking criterion of its
// contacts.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "advice/warning_filter.h"
#include "atom.h"
#include "input/sticking_rules_of_law.h"
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/contact_advice.h"
#include "soft_contacts/fix_wall_gran_cohesive.h"

using namespace LAMMPS_NS;
using cohesion::advice::StickingRules;

template <class Cohesion>
StickingRules FixWallGranCohesive<Cohesion>::sticking_rules() const {
  auto rules = sticking_rules_of_law<Cohesion>(where, scheme);
  rules.meant_without = has_adhesion_word;
  add_contact<Cohesion>(rules, Cohesion::template of_wall<cohesion::contact::Adhesion>(law, 1.0),
                        Cohesion::material(parameters), parameters.contact);
  return rules;
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::give_advice(const RunConditions& of_all, AdviceOfStyles& all) {
  const RunConditions now = of_group(lmp, of_all, groupbit);
  const auto advised = from_script(lmp, where, [&] { return advised_contacts(now.lightest); });
  all.add(style, id,
          advice_of_contacts(lmp, where, limits_of(scheme), advised, now, *advice_filter));
}

template <class Cohesion>
std::vector<AdvisedContact> FixWallGranCohesive<Cohesion>::advised_contacts(
    const std::vector<LightestParticle>& lightest) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<AdvisedContact> advised;
  for (int type = 1; type <= atom->ntypes; type++) {
    if (!std::isfinite(lightest[type].radius)) continue;  // no particles yet
    advised.push_back(advised_contact(
        fmt::format("{} - wall", type), lightest[type], {infinite, infinite}, parameters.contact,
        Cohesion::template of_wall<cohesion::contact::Adhesion>(law, lightest[type].radius)));
    advised.back().material = Cohesion::material(parameters);
    advised.back().material_words = Cohesion::material_words(parameters.contact);
    advised.back().doubt = Cohesion::doubt(lmp, parameters);
  }
  return advised;
}

#define COHESION_INSTANTIATE(style, Law)                                   \
  template StickingRules FixWallGranCohesive<Law>::sticking_rules() const; \
  template void FixWallGranCohesive<Law>::give_advice(const RunConditions&, AdviceOfStyles&);
COHESION_CONTACT_LAWS(COHESION_INSTANTIATE)
