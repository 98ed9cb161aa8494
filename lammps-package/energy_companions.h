// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_ENERGY_COMPANIONS_H
#define COHESION_ENERGY_COMPANIONS_H

#include <string>

#include "atom.h"
#include "comm.h"
#include "engine_api.h"
#include "message.h"
#include "modify.h"

// What an energy book has no entry for, in both engines.

namespace LAMMPS_NS {

/// Stops when a fix changes the box.
inline void refuse_moving_box(LAMMPS* lmp, const std::string& where) {
  for (int i = 0; i < lmp->modify->nfix; i++) {
    const Fix* const fix = lmp->modify->fix[i];
    if (engine_api::changes_box(fix))
      stop(
          lmp, FLERR, where, ": fix ", fix->id, " ", fix->style,
          " changes the box, which changes velocities at its faces and does work, and no entry has "
          "that: use one without the other");
  }
}

/// Warns, once, when particles have come or gone since the last look.
class SameParticles {
 public:
  void look(LAMMPS* lmp, const std::string& where) {
    const bigint before = number_;
    number_ = lmp->atom->natoms;
    if (said_ || before < 0 || before == number_) return;
    said_ = true;
    if (lmp->comm->me == 0)
      lmp->error->warning(
          FLERR, message(where, ": there were ", before, " particles and now are ", number_,
                         "; the energy that came or went with them is in entry 10, "
                         "which is not the error of the time step then")
                     .c_str());
  }

 private:
  bigint number_ = -1;
  bool said_ = false;
};

}  // namespace LAMMPS_NS

#endif
