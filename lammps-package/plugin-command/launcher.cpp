// SPDX-License-Identifier: GPL-2.0-only
// LAMMPS with all options of `lmp`, and with the command `plugin load`.

#include <mpi.h>

#include "input.h"
#include "lammps.h"

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  {
    LAMMPS_NS::LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    lammps.input->file();
  }
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Finalize();
}
