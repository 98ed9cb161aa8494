# SPDX-License-Identifier: BSD-3-Clause
# LIGGGHTS: the system's package, or that in LIGGGHTS_ROOT (an install prefix).
#
# Sets LIGGGHTS_FOUND, LIGGGHTS_VERSION, LIGGGHTS_EXECUTABLE and the target LIGGGHTS::LIGGGHTS.

set(LIGGGHTS_ROOT "" CACHE PATH "LIGGGHTS to use instead of the system's")
find_path(LIGGGHTS_INCLUDE_DIR contact_models.h PATH_SUFFIXES liggghts)
find_library(LIGGGHTS_LIBRARY liggghts)
find_program(LIGGGHTS_EXECUTABLE liggghts)
mark_as_advanced(LIGGGHTS_INCLUDE_DIR LIGGGHTS_LIBRARY LIGGGHTS_EXECUTABLE)

# The headers do not say the version of LIGGGHTS, only that of the LAMMPS it came from.
if(LIGGGHTS_LIBRARY)
  file(STRINGS ${LIGGGHTS_LIBRARY} LIGGGHTS_VERSION LIMIT_COUNT 1
    REGEX "LIGGGHTS-[A-Z]+ [0-9.]+, compiled")
  string(REGEX REPLACE ".*LIGGGHTS-[A-Z]+ ([0-9.]+), compiled.*" "\\1"
    LIGGGHTS_VERSION "${LIGGGHTS_VERSION}")
endif()

include(FindPackageHandleStandardArgs)
set(FPHSA_NAME_MISMATCHED TRUE)
find_package_handle_standard_args(LIGGGHTS
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR LIGGGHTS_EXECUTABLE
  VERSION_VAR LIGGGHTS_VERSION
  REASON_FAILURE_MESSAGE "run scripts/setup, or give -DLIGGGHTS_ROOT=prefix")

if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::LIGGGHTS)
  add_library(LIGGGHTS::LIGGGHTS INTERFACE IMPORTED)
  target_include_directories(LIGGGHTS::LIGGGHTS SYSTEM INTERFACE ${LIGGGHTS_INCLUDE_DIR})
  target_compile_definitions(LIGGGHTS::LIGGGHTS INTERFACE OMPI_SKIP_MPICXX=1)
  target_link_libraries(LIGGGHTS::LIGGGHTS INTERFACE ${LIGGGHTS_LIBRARY} MPI::MPI_CXX)
endif()
