// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_SCHEME_SETTING_H
#define COHESION_SCHEME_SETTING_H

#include <map>
#include <string>

#include "contact_models.h"
#include "settings.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Keyword `scheme` of a cohesion model: what LIGGGHTS can carry of what pair_style gran/hamaker
/// and gran/square_well of the LAMMPS package know.
class SchemeSetting : public Setting {
 public:
  explicit SchemeSetting(const std::string& model) : Setting("scheme", 1), model_(model) {}

  /// Number of words taken; -1 with an error_message.
  int parseArguments(char** args) override {
    if (name != args[0]) return 0;
    if (std::string(args[1]) == "sampled") return 2;
    error_message = model_ + ", scheme " + args[1] + ": ";
    error_message +=
        std::string(args[1]) == "event"
            ? "LIGGGHTS asks a contact model for one force per contact and step. The event scheme "
              "must also move particles within the step, and follow each contact a second time "
              "with "
              "what the others of its particles do. Use 'scheme sampled' and a small time step, or "
              "the LAMMPS package"
            : "must be sampled";
    return -1;
  }
  void print_value(FILE* out) override { fprintf(out, "sampled"); }

 private:
  std::string model_;
};

/// The engine's table of settings takes words of its own kinds only; an explicit instantiation may
/// name its private member.
std::map<std::string, Setting*>& table_of(Settings& settings);
template <auto member>
struct TableOfSettings {
  friend std::map<std::string, Setting*>& table_of(Settings& settings) { return settings.*member; }
};
template struct TableOfSettings<&Settings::settings>;

/// settings owns the new entry.
inline void register_scheme(Settings& settings, const std::string& model) {
  table_of(settings)["scheme"] = new SchemeSetting(model);
}

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
