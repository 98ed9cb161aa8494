// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_KEYWORD_VALUES_H
#define COHESION_KEYWORD_VALUES_H

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "common/message.h"
#include "lammps.h"
#include "utils.h"

namespace LAMMPS_NS {

/// Whether the engine takes the word for a number, or would say itself why it does not.
inline bool is_number(const char* word) {
  char* end = nullptr;
  std::strtod(word, &end);
  return end != word && *end == '\0';
}

/// The values of a keyword by their names in `usage`, as in "hertz E nu".
inline std::vector<std::string> value_names(const std::string& usage) {
  std::istringstream text(usage);
  std::vector<std::string> names;
  for (std::string name; text >> name;) names.push_back(name);
  return names;
}

/// Reads the values behind the keyword arg[at], of a command of `narg` words: of those in `usage`
/// the first `words` are words, which are left alone, the others numbers. Stops LAMMPS where one is
/// missing, or where a word and a number are in each other's place, as where the next keyword comes
/// too early.
inline void read_values(LAMMPS* lmp, const std::string& where, const std::string& usage, int words,
                        int at, int narg, char** arg, double* numbers) {
  const std::vector<std::string> names = value_names(usage);
  for (int k = 0; k < static_cast<int>(names.size()); k++) {
    const int i = at + 1 + k;
    const bool missing = i >= narg;
    if (missing || is_number(arg[i]) != (k >= words))
      stop(lmp, FLERR, where, ": keyword '", arg[at], "' needs '", arg[at], " ", usage, "': ",
           missing ? names[k] + " is missing"
                   : "'" + std::string(arg[i]) + "' stands in the place of " + names[k]);
    if (k >= words) numbers[k - words] = utils::numeric(FLERR, arg[i], false, lmp);
  }
}

}  // namespace LAMMPS_NS

#endif
