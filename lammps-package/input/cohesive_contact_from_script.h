// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_COHESIVE_CONTACT_FROM_SCRIPT_H
#define COHESION_COHESIVE_CONTACT_FROM_SCRIPT_H

#include <algorithm>
#include <string>
#include <vector>

#include "common/specified_keywords.h"
#include "contact/contact_parameters.h"
#include "error.h"
#include "input/keyword_values.h"
#include "input/law_from_script.h"
#include "lammps.h"

// What scripts say about cohesive contacts, whatever the cohesion. `Cohesion` is one of
// cohesion_laws.h; its Parameters have a member `contact`, the contact
// without cohesion.

namespace cohesion::advice {
struct SchemeLimits;
}

namespace LAMMPS_NS {

/// How the motion of contacts is integrated; to add a scheme: its pair in src/contact_solver, its
/// row in `schemes`, its alternative in PairGranCohesive and FixWallGranCohesive, and the
/// instantiation of its PairContacts (soft_contacts/*_step.cpp).
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
  const char* usage;  ///< the names of its values, at most 3
  /// Throws InvalidParameter for values that it cannot take.
  void (*set)(Parameters&, const double*);
  /// In place of set() where the first value is a word; throws alike.
  void (*set_named)(Parameters&, const char* word, const double*) = nullptr;

  int words() const { return set_named ? 1 : 0; }
  int values() const { return static_cast<int>(value_names(usage).size()); }
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
        {"stiffness", "K", [](P& p, const double* v) { p.contact.stiffness = v[0]; }},
        {"normal", "hertz E nu", nullptr,
         [](P& p, const char* law, const double* v) { set_normal_law(p.contact, law, v); }},
        {"restitution", "e", [](P& p, const double* v) { p.contact.restitution = v[0]; }},
        {"damping", "eta", [](P& p, const double* v) { p.contact.damping = v[0]; }},
        {"tangential", "ratio", [](P& p, const double* v) { p.contact.tangential_ratio = v[0]; }},
        {"tangential_damping", "ratio",
         [](P& p, const double* v) { p.contact.tangential_damping_ratio = v[0]; }},
        {"friction", "mu", [](P& p, const double* v) { p.contact.friction = v[0]; }},
        {"rolling_friction", "mu_R",
         [](P& p, const double* v) { p.contact.rolling_friction = v[0]; }},
    };
    const auto own = Cohesion::keywords();
    rows.insert(rows.end(), own.begin(), own.end());
    return rows;
  }();
  return all;
}

/// How many values the keyword arg[at] of the contact has, which are there; -1 when there is none
/// called so. Stops LAMMPS as read_values().
template <class Cohesion>
int values_of_contact_keyword(LAMMPS* lmp, const std::string& where, int at, int narg, char** arg) {
  for (const auto& keyword : contact_keywords<Cohesion>()) {
    if (std::string(arg[at]) != keyword.name) continue;
    double values[3];
    read_values(lmp, where, keyword.usage, keyword.words(), at, narg, arg, values);
    return keyword.values();
  }
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
    double values[3] = {0.0, 0.0, 0.0};
    read_values(lmp, where, keyword.usage, keyword.words(), i, narg, arg, values);
    given.note(keyword.values(), arg + i);
    from_script(lmp, where, [&] {
      return keyword.words() ? keyword.set_named(p, arg[i + 1], values) : keyword.set(p, values);
    });
    i += 1 + keyword.values();
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
