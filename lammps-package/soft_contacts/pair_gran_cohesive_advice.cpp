// SPDX-License-Identifier: GPL-2.0-only
// The part of PairGranCohesive for the time-step check and for the sticking criterion of its
// contacts.
#include <cmath>
#include <string>
#include <vector>

#include "advice/warning_filter.h"
#include "atom.h"
#include "input/sticking_rules_of_law.h"
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/contact_advice.h"
#include "soft_contacts/pair_gran_cohesive.h"

using namespace LAMMPS_NS;
using cohesion::advice::StickingRules;

template <class Cohesion>
StickingRules PairGranCohesive<Cohesion>::sticking_rules() const {
  auto rules =
      sticking_rules_of_law<Cohesion>(coefficients.message_prefix(), coefficients.scheme());
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (!coefficients.has(i, j)) continue;
      const int k = coefficients.pair_index(i, j);
      add_contact<Cohesion>(
          rules, coefficients.template attraction<cohesion::contact::Adhesion>(k, 1.0, 1.0),
          coefficients.material(k), coefficients.contact(k));
    }
  return rules;
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::give_advice(const RunConditions& now, AdviceOfStyles& all) {
  if (!Cohesion::HAS_CONTACT) return;
  const std::string where = coefficients.message_prefix();
  const auto contacts = from_script(lmp, where, [&] { return advised_contacts(now.lightest); });
  all.add(where, "",
          advice_of_contacts(lmp, where, limits_of(coefficients.scheme()), contacts, now,
                             *advice_filter));
}

/// The contacts between particles of the types of this style.
template <class Cohesion>
std::vector<AdvisedContact> PairGranCohesive<Cohesion>::advised_contacts(
    const std::vector<LightestParticle>& lightest) const {
  std::vector<AdvisedContact> contacts;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      const LightestParticle &a = lightest[i], &b = lightest[j];
      if (!coefficients.has(i, j)) continue;
      if (!std::isfinite(a.radius) || !std::isfinite(b.radius)) continue;  // no particles yet
      const int types = coefficients.pair_index(i, j);
      contacts.push_back(
          advised_contact(fmt::format("{} - {}", i, j), a, b, coefficients.contact(types),
                          coefficients.template attraction<cohesion::contact::Adhesion>(
                              types, a.radius, b.radius)));
      contacts.back().material = coefficients.material(types);
      contacts.back().material_words = Cohesion::material_words(coefficients.contact(types));
      contacts.back().doubt = coefficients.doubt(types);
    }
  return contacts;
}

#define COHESION_INSTANTIATE(style, Law)                                \
  template StickingRules PairGranCohesive<Law>::sticking_rules() const; \
  template void PairGranCohesive<Law>::give_advice(const RunConditions&, AdviceOfStyles&);
COHESION_PAIR_LAWS(COHESION_INSTANTIATE)
