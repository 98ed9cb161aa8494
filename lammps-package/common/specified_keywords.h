// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_SPECIFIED_KEYWORDS_H
#define COHESION_SPECIFIED_KEYWORDS_H

#include <map>
#include <string>
#include <utility>

#include "common/message.h"

namespace LAMMPS_NS {

/// The keywords that one command of a script gives. One that is there twice stops the engine: of
/// two values one would be passed over.
class SpecifiedKeywords {
 public:
  /// `where` stands in front of the message.
  SpecifiedKeywords(LAMMPS* lmp, std::string where) : lmp_(lmp), where_(std::move(where)) {}

  /// Notes arg[0], behind which `values` words are its values.
  void note(int values, char** arg) {
    std::string text;
    for (int k = 1; k <= values; k++) text += (k > 1 ? " " : "") + std::string(arg[k]);
    const auto [before, is_new] = values_.insert({arg[0], text});
    if (!is_new)
      stop(lmp_, FLERR, where_, ": keyword '", arg[0], "' is there twice, with ", before->second,
           " and with ", text, "; give it once");
  }
  bool has(const std::string& name) const { return values_.count(name) > 0; }

 private:
  LAMMPS* lmp_;
  std::string where_;
  std::map<std::string, std::string> values_;  // values by name, as they are spelt
};

}  // namespace LAMMPS_NS

#endif
