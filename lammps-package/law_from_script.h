// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_LAW_FROM_SCRIPT_H
#define COHESION_LAW_FROM_SCRIPT_H

#include <string>

#include "error.h"
#include "hamaker/forms.h"
#include "lammps.h"
#include "named_table.h"

namespace LAMMPS_NS {

/// What `make` gives; a parameter that cannot be right stops LAMMPS with `where` (style and types)
/// in front of the core's own message.
template <class Make>
auto from_script(LAMMPS* lmp, const std::string& where, Make make) {
  try {
    return make();
  } catch (const cohesion::InvalidParameter& bad) {
    lmp->error->all(FLERR, where + ": " + bad.what());
    throw;
  }
}

/// The row of the form called `name`.
inline const cohesion::hamaker::Form* hamaker_form_from_script(LAMMPS* lmp,
                                                               const std::string& where,
                                                               const std::string& name) {
  return from_script(
      lmp, where, [&] { return &cohesion::find_by_name(cohesion::hamaker::forms, "form", name); });
}

}  // namespace LAMMPS_NS

#endif
