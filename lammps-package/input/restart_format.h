// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_RESTART_FORMAT_H
#define COHESION_RESTART_FORMAT_H

#include <cstdio>
#include <string>

#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "utils.h"

// Styles write plain numbers to restart files, which tell nothing of their order. So each begins
// with a mark and the number of its layout, to be raised when the order, or the history of a
// contact, changes.

namespace LAMMPS_NS {

static constexpr int RESTART_MARK = 0x436f6800;  // "Coh", then the layout

inline void write_layout(FILE* fp, int layout) {
  const int number = RESTART_MARK + layout;
  fwrite(&number, sizeof(int), 1, fp);
}

/// Stops LAMMPS where `number`, which a file has in front, is another than RESTART_MARK + layout;
/// `where` stands in front of the message.
inline void require_layout(LAMMPS* lmp, double number, const std::string& where, int layout) {
  if (number == RESTART_MARK + layout) return;
  const double there = number - RESTART_MARK;
  const std::string known = there > 0.0 && there < 100.0
                                ? "layout " + std::to_string(static_cast<int>(there))
                                : "no known layout";
  lmp->error->all(
      FLERR, where + ": the restart file was written by another version of the package (" + known +
                 " of its numbers, this version reads layout " + std::to_string(layout) +
                 "); read it with that one, and carry places and velocities over by "
                 "'write_data'");
}

/// The same for the next number of the file, which write_layout() wrote.
inline void require_layout(LAMMPS* lmp, FILE* fp, const std::string& where, int layout) {
  int number = 0;
  if (lmp->comm->me == 0) utils::sfread(FLERR, &number, sizeof(int), 1, fp, nullptr, lmp->error);
  MPI_Bcast(&number, 1, MPI_INT, 0, lmp->world);
  require_layout(lmp, static_cast<double>(number), where, layout);
}

}  // namespace LAMMPS_NS

#endif
