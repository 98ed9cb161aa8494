// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_SCALING_NOTES_H
#define COHESION_SCALING_NOTES_H

#include <map>
#include <string>

#include "comm.h"
#include "lammps.h"
#include "utils.h"

namespace LAMMPS_NS {

/// Prints how the adhesion of contacts was scaled, once until that changes.
class ScalingNotes {
 public:
  /// `where`: which contact; an empty note prints nothing.
  void print(LAMMPS* lmp, const std::string& where, const std::string& note) {
    if (printed_[where] != note && !note.empty() && lmp->comm->me == 0)
      utils::logmesg(lmp, where + ": " + note + "\n");
    printed_[where] = note;
  }

 private:
  std::map<std::string, std::string> printed_;  // by `where`
};

}  // namespace LAMMPS_NS

#endif
