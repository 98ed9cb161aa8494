// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FORMER_WORDS_H
#define COHESION_FORMER_WORDS_H

#include <set>
#include <string>
#include <utility>

#include "comm.h"
#include "error.h"
#include "former_names.h"
#include "lammps.h"

namespace LAMMPS_NS {

/// What the word `name` of a script is called now. A former name is warned of once in the life of
/// the engine, whatever number of commands use it; `where` is the first of them.
inline std::string current_word(const LAMMPS* lmp, const std::string& where,
                                const std::string& what, const std::string& name) {
  return cohesion::current_name(what, name, [&](const std::string& sentence) {
    // A program may start one engine after another: the time of its start tells them apart.
    static std::set<std::pair<double, std::string>> given;
    if (!given.emplace(lmp->initclock, sentence).second || lmp->comm->me != 0) return;
    const std::string text = where + ": " + sentence;
    lmp->error->warning(FLERR, text.c_str());
  });
}

}  // namespace LAMMPS_NS

#endif
