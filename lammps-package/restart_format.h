// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_RESTART_FORMAT_H
#define COHESION_RESTART_FORMAT_H

#include <cstdio>
#include <string>

#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "utils.h"

// Pair styles write plain numbers to restart files, which tell nothing of their order. So each
// begins with a mark and the number of its layout, to be raised when the order changes.

namespace LAMMPS_NS {

static constexpr int RESTART_MARK = 0x436f6800;  // "Coh", then the layout

inline void write_layout(FILE* fp, int layout) {
  const int number = RESTART_MARK + layout;
  fwrite(&number, sizeof(int), 1, fp);
}

/// Stops LAMMPS where the next number of the file is another than write_layout() wrote; `where`
/// stands in front of the message.
inline void require_layout(LAMMPS* lmp, FILE* fp, const std::string& where, int layout) {
  int number = 0;
  if (lmp->comm->me == 0) utils::sfread(FLERR, &number, sizeof(int), 1, fp, nullptr, lmp->error);
  MPI_Bcast(&number, 1, MPI_INT, 0, lmp->world);
  if (number != RESTART_MARK + layout)
    lmp->error->all(FLERR,
                    where +
                        ": the restart file was written by another version of the package, with "
                        "other numbers; read it with that one, and carry places and velocities "
                        "over by 'write_data'");
}

}  // namespace LAMMPS_NS

#endif
