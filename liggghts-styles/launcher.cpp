// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS with all options of `liggghts`, and with the models that the files register_*.cpp add.

#include <mpi.h>

#include <csignal>
#include <cstdio>

#include "input.h"
#include "lammps.h"
#include "signal_handling.h"

int main(int argc, char** argv) {
  // An interrupt ends the run after the current step, SIGUSR1 asks for a restart file.
  using namespace LAMMPS_NS;
  std::signal(SIGINT, SignalHandler::int_handler);
  std::signal(SIGTERM, SignalHandler::int_handler);
  std::signal(SIGUSR1, SignalHandler::usr1_handler);

  // A rank that stops with an error of its own ends all at once: line by line, it is not lost when
  // the output is a file.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  MPI_Init(&argc, &argv);
  {
    LAMMPS liggghts(argc, argv, MPI_COMM_WORLD);
    liggghts.input->file();
  }
  MPI_Finalize();
}
