// SPDX-License-Identifier: GPL-2.0-or-later
#include "word_settings.h"

#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <map>

#include "common/former_words.h"
#include "common/message.h"
#include "contact_models.h"
#include "liggghts_api.h"
#include "modify.h"
#include "named_table.h"
#include "settings.h"
#include "unknown_models.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

using Table = std::map<std::string, Setting*>;

/// A keyword of a cohesion model, the value of which is a word. A wrong one stops the engine here:
/// what the engine prints of a Setting's error_message may be followed by a jest (liggghts_api.h).
class WordSetting : public Setting {
 public:
  WordSetting(const LAMMPS_NS::LAMMPS* lmp, const std::string& model, const std::string& keyword,
              int values)
      : Setting(keyword, values), lmp_(lmp), model_(model) {}

  void print_value(FILE*) override {}

 protected:
  const LAMMPS_NS::LAMMPS* lmp_;
  std::string model_;
};

/// A keyword that is the last word of its line. The engine's settings read a value behind each
/// keyword and are passed no count.
class LastWord : public WordSetting {
 public:
  /// Its name is the first of any table: it sees each word before the others.
  static constexpr const char* NAME = "";

  LastWord(const LAMMPS_NS::LAMMPS* lmp, const std::string& model, const Table& table)
      : WordSetting(lmp, model, NAME, 0), table_(table) {}

  int parseArguments(char** args) override {
    if (args + 1 != end_of_words()) return 0;
    const auto found = table_.find(args[0]);
    if (found == table_.end() || found->second->num_params == 0) return 0;
    LAMMPS_NS::stop(lmp_, FLERR, model_, ": keyword '", found->first, "' needs a value behind it",
                    found->first == "scheme" ? ", exact or sampled" : "");
    return -1;
  }

 private:
  const Table& table_;
};

class SchemeSetting : public WordSetting {
 public:
  SchemeSetting(const LAMMPS_NS::LAMMPS* lmp, const std::string& model, SchemeChoice& choice)
      : WordSetting(lmp, model, "scheme", 1), choice_(choice) {}

  /// Number of words taken.
  int parseArguments(char** args) override {
    if (name != args[0]) return 0;
    const std::string scheme = LAMMPS_NS::current_word(lmp_, model_, name, args[1]);
    if (scheme == "exact" || scheme == "sampled") {
      choice_ = scheme == "exact" ? SchemeChoice::exact : SchemeChoice::sampled;
      return 2;
    }
    LAMMPS_NS::stop(lmp_, FLERR, model_, ", scheme ", scheme, ": must be exact or sampled");
    return -1;
  }
  void print_value(FILE* out) override {
    fprintf(out, choice_ == SchemeChoice::sampled ? "sampled" : "exact");
  }

 private:
  SchemeChoice& choice_;
};

/// A word that stands where only keywords may, and says where these belong: the engine would blame
/// the word.
class MisplacedSetting : public WordSetting {
 public:
  MisplacedSetting(const LAMMPS_NS::LAMMPS* lmp, const std::string& model, const std::string& word)
      : WordSetting(lmp, model, word, 0) {}

  int parseArguments(char** args) override {
    if (name != args[0]) return 0;
    LAMMPS_NS::stop(lmp_, FLERR, model_, ": '", name,
                    "' stands behind a keyword as 'scheme', and keywords come last: behind all "
                    "models and, in fix wall/gran, behind 'primitive ...' or 'mesh ...', as in "
                    "'fix ID all wall/gran model hooke/stiffness tangential history cohesion "
                    "hamaker primitive type 1 zplane 0.0 scheme exact'");
    return -1;
  }
};

class KeepSetting : public WordSetting {
 public:
  KeepSetting(const LAMMPS_NS::LAMMPS* lmp, const std::string& model, cohesion::contact::Keep& keep)
      : WordSetting(lmp, model, "material_keep", 1), keep_(keep) {}

  /// Number of words taken.
  int parseArguments(char** args) override {
    if (name != args[0]) return 0;
    try {
      keep_ = cohesion::find_by_name(cohesion::contact::keeps, name, args[1]).keep;
    } catch (const cohesion::InvalidParameter& bad) {
      LAMMPS_NS::stop(lmp_, FLERR, model_, ": ", bad.what());
      return -1;
    }
    return 2;
  }
  void print_value(FILE* out) override {
    for (const auto& row : cohesion::contact::keeps)
      if (row.keep == keep_) fprintf(out, "%s", row.name);
  }

 private:
  cohesion::contact::Keep& keep_;
};

/// The engine's table of settings takes words of its own kinds only; an explicit instantiation may
/// name its private member. There may be one in the program only: not in a header.
Table& table_of(Settings& settings);
template <auto member>
struct TableOfSettings {
  friend Table& table_of(Settings& settings) { return settings.*member; }
};
template struct TableOfSettings<&Settings::settings>;

}  // namespace

void register_scheme(const LAMMPS_NS::LAMMPS* lmp, Settings& settings, const std::string& model,
                     SchemeChoice& choice) {
  Table& table = table_of(settings);  // settings owns its rows
  table[LastWord::NAME] = new LastWord(lmp, model, table);
  table["scheme"] = new SchemeSetting(lmp, model, choice);
  for (const char* const word :
       {"primitive", "mesh", "model", "tangential", "cohesion", "rolling_friction", "surface"})
    table[word] = new MisplacedSetting(lmp, model, word);
}

SchemeChoice scheme_of(LAMMPS_NS::LAMMPS* lmp, const std::string& model,
                       const LAMMPS_NS::FixWallGran* wall, SchemeChoice specified,
                       const std::string& obstacle, bool has_sampled) {
  const auto print = [&](const std::string& line) {
    LAMMPS_NS::engine_api::tell(lmp, model + ": " + line + "\n");
  };
  if (obstacle.empty()) {
    if (specified == SchemeChoice::none && !wall)
      print(has_sampled ? "scheme exact by default ('scheme sampled' up to version 0.2)"
                        : "scheme exact");
    return SchemeChoice::exact;
  }
  if (specified == SchemeChoice::exact || !has_sampled)
    LAMMPS_NS::stop(lmp, FLERR, model, ", scheme exact: ", obstacle,
                    has_sampled ? ": use 'scheme sampled', or leave that out"
                                : ": leave that out; the model has no other scheme");
  print("scheme sampled by default: " + obstacle);
  return SchemeChoice::sampled;
}

void tell_of_restart_files(LAMMPS_NS::LAMMPS* lmp, const std::string& model) {
  if (lmp->modify->nfix_restart_peratom > 0)
    LAMMPS_NS::engine_api::tell(lmp, model +
                                         ": without 'scheme' the contacts of a restart file are "
                                         "those of scheme exact; use 'scheme sampled' if that "
                                         "wrote the file\n");
}

void register_keep(const LAMMPS_NS::LAMMPS* lmp, Settings& settings, const std::string& model,
                   cohesion::contact::Keep& keep) {
  table_of(settings)["material_keep"] = new KeepSetting(lmp, model, keep);
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
