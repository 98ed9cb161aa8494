// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_MESSAGE_H
#define COHESION_MESSAGE_H

#include <sstream>
#include <string>

#include "common/engine_api.h"
#include "lammps.h"

// Messages of styles that are built for LAMMPS and for LIGGGHTS, which does not put numbers into
// them.

namespace LAMMPS_NS {

/// Words and numbers one after the other.
template <class... Parts>
std::string message(const Parts&... parts) {
  std::ostringstream text;
  text.precision(10);
  (text << ... << parts);
  return text.str();
}

/// Ends the run on all ranks, which must all call it: stop(lmp, FLERR, parts...).
template <class... Parts>
void stop(const LAMMPS* lmp, const char* file, int line, const Parts&... parts) {
  engine_api::error_of_all(lmp, file, line, message(parts...));
}

}  // namespace LAMMPS_NS

#endif
