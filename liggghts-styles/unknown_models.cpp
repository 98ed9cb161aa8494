// SPDX-License-Identifier: GPL-2.0-or-later
#include "unknown_models.h"

// The engine's headers need these three before all others.
#include <mpi.h>
// clang-format off
#include "fix_insert_stream.h"
#include "global_properties.h"
// clang-format on
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cohesive_pairs.h"
#include "common/message.h"
#include "contact_models.h"
#include "granular_pair_style.h"
#include "granular_wall.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

using Names = std::vector<std::string>;

/// A kind of model: its word in scripts, and those that cohesion models of this package are
/// combined with (model-lists/).
struct ModelKind {
  std::string word;
  Names combined;
};

#define NORMAL_MODEL(model, name, number) #name,
#define TANGENTIAL_MODEL(model, name, number) #name,
#define ROLLING_MODEL(model, name, number) #name,
#define SURFACE_MODEL(model, name, number) #name,
// clang-format off
const Names normal_models{
#include "style_normal_model.h"
};
const Names tangential_models{"off",
#include "style_tangential_model.h"
};
const Names rolling_models{"off",
#include "style_rolling_model.h"
};
const Names surface_models{
#include "style_surface_model.h"
};
// clang-format on
#undef NORMAL_MODEL
#undef TANGENTIAL_MODEL
#undef ROLLING_MODEL
#undef SURFACE_MODEL

const ModelKind kinds[] = {{"model", normal_models},
                           {"tangential", tangential_models},
                           {"cohesion", {}},
                           {"rolling_friction", rolling_models},
                           {"surface", surface_models}};

std::string list_of(const Names& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

/// Kind and name of each model at the beginning of the words behind `pair_style gran`, until
/// another word comes.
std::vector<std::pair<const ModelKind*, std::string>> models_in(int narg, char** arg) {
  std::vector<std::pair<const ModelKind*, std::string>> models;
  for (int k = 0; k + 1 < narg; k += 2) {
    const ModelKind* found = nullptr;
    for (const ModelKind& kind : kinds)
      if (kind.word == arg[k]) found = &kind;
    if (!found) break;
    models.emplace_back(found, arg[k + 1]);
  }
  return models;
}

/// By the engine's reader of models itself: its tables take a name that they are asked for.
bool engine_has(const ModelKind& kind, const std::string& name, Custom_contact_models custom) {
  std::string words[] = {"model", "hooke", kind.word, name};
  char* arg[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data()};
  const bool is_normal = kind.word == words[0];
  char** first = is_normal ? arg + 2 : arg;
  int narg = is_normal ? 2 : 4;
  return ContactModels::Factory::select(narg, first, custom) != -1;
}

/// The name is no model of its kind; empty: all are, or the engine has more to say.
std::string unknown(const std::vector<std::pair<const ModelKind*, std::string>>& models,
                    Custom_contact_models custom) {
  for (const auto& [kind, name] : models) {
    if (engine_has(*kind, name, custom)) continue;
    const bool of_cohesion = kind->word == "cohesion";
    return "there is no '" + kind->word + " " + name + "'; the models of this package are " +
           (of_cohesion ? "cohesion " + cohesion_models()
                        : "combined with '" + kind->word + "' " + list_of(kind->combined)) +
           (of_cohesion ? ", and the engine has its own" : ", and the engine has more");
  }
  return "";
}

/// A cohesion model of this package stands beside a model that it is not combined with; empty: none
/// does.
std::string not_combined(const std::vector<std::pair<const ModelKind*, std::string>>& models) {
  std::string cohesion;
  for (const auto& [kind, name] : models)
    if (kind->word == "cohesion" && is_cohesion_model(name)) cohesion = name;
  if (cohesion.empty()) return "";
  for (const auto& [kind, name] : models) {
    const Names& with = kind->combined;
    if (with.empty() || std::find(with.begin(), with.end(), name) != with.end()) continue;
    return "cohesion model " + cohesion + " is not combined with '" + kind->word + " " + name +
           "', but with '" + kind->word + "' " + list_of(with);
  }
  return "";
}

/// The cohesion model that the words name; empty: they name none.
std::string cohesion_in(const std::vector<std::pair<const ModelKind*, std::string>>& models) {
  for (const auto& [kind, name] : models)
    if (kind->word == "cohesion") return name;
  return "";
}

/// By pair style or fix of a wall; of one that is gone until another is in its place.
std::map<const void*, std::string>& known_cohesion_words() {
  static std::map<const void*, std::string> words;
  return words;
}

char* const*& known_end() {
  static char* const* end = nullptr;
  return end;
}

using Selector = int64_t (*)(int& narg, char**& arg, Custom_contact_models custom);
using Selectors = std::map<std::string, Selector>;
template <class Style>
using Creator = Style* (*)(LAMMPS*, typename Style::ParentType*, int64_t);
template <class Style>
using Creators = std::map<std::pair<std::string, int>, Creator<Style>>;
template <class Style>
using StyleFactory = Utils::AbstractFactory<Style>;

/// The engine's tables of combinations; an explicit instantiation may name its private members.
/// There may be one in the program only: not in a header.
template <class Style>
struct Tables {
  Selectors* selectors;
  Creators<Style>* creators;
};
Tables<PairStyles::IGranularPairStyle> tables_of(StyleFactory<PairStyles::IGranularPairStyle>&);
Tables<Walls::IGranularWall> tables_of(StyleFactory<Walls::IGranularWall>&);
template <class Style, auto selectors, auto creators>
struct TablesOfFactory {
  friend Tables<Style> tables_of(StyleFactory<Style>& factory) {
    return {&(factory.*selectors), &(factory.*creators)};
  }
};
template struct TablesOfFactory<PairStyles::IGranularPairStyle,
                                &StyleFactory<PairStyles::IGranularPairStyle>::variantSelectorTable,
                                &StyleFactory<PairStyles::IGranularPairStyle>::styleTable>;
template struct TablesOfFactory<Walls::IGranularWall,
                                &StyleFactory<Walls::IGranularWall>::variantSelectorTable,
                                &StyleFactory<Walls::IGranularWall>::styleTable>;

/// Stands before what the engine does with the models of a style. What is wrong is found where
/// their names are read, and reported where the style is made, which has the engine's errors.
template <class Style>
struct Named {
  static void put_before(StyleFactory<Style>& factory) {
    const Tables<Style> tables = tables_of(factory);
    const auto selector = tables.selectors->find("gran");
    const auto creator = tables.creators->find({"gran", static_cast<int>(ANY)});
    if (selector == tables.selectors->end() || creator == tables.creators->end()) return;
    if (selector->second == &select) return;
    engine_select = selector->second;
    engine_create = creator->second;
    selector->second = &select;
    creator->second = &create;
  }

 private:
  /// The engine's combination of whatever models.
  static constexpr int64_t ANY =
      ContactModels::GranStyle<ContactModels::NORMAL_OFF, ContactModels::TANGENTIAL_OFF,
                               ContactModels::COHESION_OFF, ContactModels::ROLLING_OFF,
                               ContactModels::SURFACE_DEFAULT>::HASHCODE;

  static int64_t select(int& narg, char**& arg, Custom_contact_models custom) {
    const auto models = models_in(narg, arg);
    known_end() = arg + narg;
    const int64_t hash = engine_select(narg, arg, custom);
    cohesion_word = cohesion_in(models);
    wrong = hash == -1 ? unknown(models, custom) : not_combined(models);
    return wrong.empty() ? hash : ANY;
  }
  static Style* create(LAMMPS* lmp, typename Style::ParentType* parent, int64_t hash) {
    if (!wrong.empty()) LAMMPS_NS::stop(lmp, FLERR, wrong);
    // A restart file has no words.
    known_cohesion_words()[parent] = std::exchange(cohesion_word, "");
    return engine_create(lmp, parent, hash);
  }

  static inline Selector engine_select = nullptr;
  static inline Creator<Style> engine_create = nullptr;
  static inline std::string wrong;
  static inline std::string cohesion_word;
};

}  // namespace

std::string cohesion_word_of(const void* style) {
  const auto found = known_cohesion_words().find(style);
  return found == known_cohesion_words().end() ? "" : found->second;
}

char* const* end_of_words() { return known_end(); }

void name_unknown_models() {
  Named<PairStyles::IGranularPairStyle>::put_before(PairStyles::Factory::instance());
  Named<Walls::IGranularWall>::put_before(Walls::Factory::instance());
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
