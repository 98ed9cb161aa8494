// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_COHESIVE_CONTACT_FROM_SCRIPT_H
#define COHESION_COHESIVE_CONTACT_FROM_SCRIPT_H

#include <algorithm>
#include <string>
#include <vector>

#include "advice/contact_advice.h"
#include "common/specified_keywords.h"
#include "contact/contact_parameters.h"
#include "error.h"
#include "input/law_from_script.h"
#include "lammps.h"
#include "utils.h"

// What scripts say about cohesive contacts, whatever the cohesion. `Cohesion` is one of
// cohesion_laws.h; its Parameters have a member `contact`, the contact
// without cohesion.

namespace LAMMPS_NS {

/// How the motion of contacts is integrated; to add a scheme: its pair in src/contact_solver, its
/// row in `schemes`, its alternative in the styles' AnyContacts.
enum class Scheme { exact, sampled };

/// What `scheme name` says.
Scheme scheme_from_script(LAMMPS*, const std::string& where, const std::string& name);
const cohesion::advice::SchemeLimits& limits_of(Scheme);

/// Whether `word` is a keyword of the style that the cohesion reads.
template <class Cohesion>
bool is_setting(const std::string& word) {
  return std::find(Cohesion::SETTINGS.begin(), Cohesion::SETTINGS.end(), word) !=
         Cohesion::SETTINGS.end();
}

/// The keywords of the style, with commas.
template <class Cohesion>
std::string setting_names() {
  std::string all = "scheme";
  for (const char* name : Cohesion::SETTINGS) all += std::string(", ") + name;
  return all;
}

/// `normal hertz E nu`, in place of a linear spring. Throws InvalidParameter for another law.
void set_normal_law(cohesion::contact::ContactParameters&, const char* law, const double* values);

template <class Parameters>
struct ContactKeyword {
  const char* name;
  int values;  ///< at most 3
  /// Throws InvalidParameter for values that it cannot take.
  void (*set)(Parameters&, const double*);
  /// In place of set() where the first value is a word; throws alike.
  void (*set_named)(Parameters&, const char* word, const double*) = nullptr;
};

/// The keywords of a contact, `stiffness K | normal hertz E nu [restitution e | damping eta]
/// [tangential ratio] [tangential_damping ratio] [friction mu] [rolling_friction mu_R]`, and those
/// of the cohesion.
template <class Cohesion>
const auto& contact_keywords() {
  using P = typename Cohesion::Parameters;
  using Keyword = ContactKeyword<P>;
  static const std::vector<Keyword> all = [] {
    std::vector<Keyword> rows{
        {"stiffness", 1, [](P& p, const double* v) { p.contact.stiffness = v[0]; }},
        {"normal", 3, nullptr,
         [](P& p, const char* law, const double* v) { set_normal_law(p.contact, law, v); }},
        {"restitution", 1, [](P& p, const double* v) { p.contact.restitution = v[0]; }},
        {"damping", 1, [](P& p, const double* v) { p.contact.damping = v[0]; }},
        {"tangential", 1, [](P& p, const double* v) { p.contact.tangential_ratio = v[0]; }},
        {"tangential_damping", 1,
         [](P& p, const double* v) { p.contact.tangential_damping_ratio = v[0]; }},
        {"friction", 1, [](P& p, const double* v) { p.contact.friction = v[0]; }},
        {"rolling_friction", 1, [](P& p, const double* v) { p.contact.rolling_friction = v[0]; }},
    };
    const auto own = Cohesion::keywords();
    rows.insert(rows.end(), own.begin(), own.end());
    return rows;
  }();
  return all;
}

/// How many values a keyword of the contact takes; -1 when there is none called so.
template <class Cohesion>
int values_of_contact_keyword(const std::string& name) {
  for (const auto& keyword : contact_keywords<Cohesion>())
    if (name == keyword.name) return keyword.values;
  return -1;
}

/// Their names, with commas.
template <class Cohesion>
std::string contact_keyword_names() {
  std::string all;
  for (const auto& keyword : contact_keywords<Cohesion>())
    all += (all.empty() ? "" : ", ") + std::string(keyword.name);
  return all;
}

/// Stops LAMMPS at a contact that cannot be right; `given` are the keywords that were there.
void require_valid(LAMMPS*, const std::string& where, const cohesion::contact::ContactParameters&,
                   const SpecifiedKeywords& given);
/// Stops LAMMPS where the scheme cannot compute the contact.
void require_computable(LAMMPS*, const std::string& where, Scheme,
                        const cohesion::contact::ContactParameters&);

/// Reads keywords of these rows from arg[first] on and notes them; `where` stands in front of every
/// message. Stops LAMMPS at a keyword or value that cannot be right.
template <class Keywords, class Parameters>
void read_keywords(LAMMPS* lmp, const std::string& where, const Keywords& keywords, int first,
                   int narg, char** arg, Parameters& p, SpecifiedKeywords& given) {
  for (int i = first; i < narg;) {
    const auto& keyword = *from_script(
        lmp, where, [&] { return &cohesion::find_by_name(keywords, "keyword", arg[i]); });
    if (i + keyword.values >= narg)
      lmp->error->all(FLERR, where + ": keyword '" + keyword.name + "' takes " +
                                 std::to_string(keyword.values) + " value(s)");
    given.note(keyword.values, arg + i);
    const int words = keyword.set_named ? 1 : 0;
    double values[2] = {0.0, 0.0};
    for (int k = words; k < keyword.values; k++)
      values[k - words] = utils::numeric(FLERR, arg[i + 1 + k], false, lmp);
    from_script(lmp, where, [&] {
      return words ? keyword.set_named(p, arg[i + 1], values) : keyword.set(p, values);
    });
    i += 1 + keyword.values;
  }
}

/// Reads the keywords of a contact and its cohesion from arg[first] on.
template <class Cohesion>
typename Cohesion::Parameters cohesive_contact_from_script(LAMMPS* lmp, const std::string& where,
                                                           int first, int narg, char** arg) {
  typename Cohesion::Parameters p;
  SpecifiedKeywords given(lmp, where);
  read_keywords(lmp, where, contact_keywords<Cohesion>(), first, narg, arg, p, given);
  require_valid(lmp, where, p.contact, given);
  Cohesion::require_valid(lmp, where, p, given);
  return p;
}

}  // namespace LAMMPS_NS

#endif
