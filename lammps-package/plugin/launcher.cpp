// SPDX-License-Identifier: GPL-2.0-only
// LAMMPS with all options of `lmp`, and with the command `plugin load`.

#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "exceptions.h"
#include "input.h"
#include "lammps.h"
#include "library.h"

namespace {

void finalize() {
  lammps_kokkos_finalize();
  lammps_python_finalize();
}

/// Exit code. An engine either ends the process after an error or throws it, once it has shown it.
int run(int argc, char** argv) {
  try {
    // In the middle of its work an engine cannot be taken down: an error leaves it as it is.
    auto* const lammps = new LAMMPS_NS::LAMMPS(argc, argv, MPI_COMM_WORLD);
    lammps->input->file();
    delete lammps;
    finalize();
    return EXIT_SUCCESS;
  } catch (const LAMMPS_NS::LAMMPSAbortException&) {  // of one rank, for which the others may wait
    finalize();
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  } catch (const LAMMPS_NS::LAMMPSException&) {  // of all ranks
    finalize();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception: %s\n", error.what());
    finalize();
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  }
  return EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  // A rank that stops with an error of its own ends all at once: line by line, it is not lost when
  // the output is a file.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  MPI_Init(&argc, &argv);
  const int code = run(argc, argv);
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Finalize();
  return code;
}
