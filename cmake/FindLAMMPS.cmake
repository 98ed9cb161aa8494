# SPDX-License-Identifier: BSD-3-Clause
# LAMMPS, as many as there are.
#
#   find_package(LAMMPS)
#
# Without LAMMPS_ROOT two engines are looked for:
#   stock    the system's package, with the complete headers that scripts/setup fetches
#   current  a recent release with `plugin load`, built by scripts/setup
# With LAMMPS_ROOT (a source tree with its build folder in LAMMPS_ROOT/build, or an install prefix)
# that one alone, called "given".
#
# Sets LAMMPS_ENGINES and, for each NAME in it, the target LAMMPS::NAME and LAMMPS_<NAME>_VERSION,
# LAMMPS_<NAME>_EXECUTABLE and LAMMPS_<NAME>_HAS_PLUGIN (whether it knows `plugin load`).

set(LAMMPS_ROOT "" CACHE PATH "LAMMPS to use instead of the system's")
set(LAMMPS_ENGINES "")

function(cohesion_add_lammps name headers library_hints)
  find_path(LAMMPS_${name}_INCLUDE_DIR lammpsplugin.h PATHS ${headers} NO_DEFAULT_PATH)
  find_library(LAMMPS_${name}_LIBRARY lammps PATHS ${library_hints} NO_DEFAULT_PATH)
  find_program(LAMMPS_${name}_EXECUTABLE NAMES lmp PATHS ${library_hints} ${ARGN} NO_DEFAULT_PATH)
  mark_as_advanced(LAMMPS_${name}_INCLUDE_DIR LAMMPS_${name}_LIBRARY LAMMPS_${name}_EXECUTABLE)
  if(NOT LAMMPS_${name}_INCLUDE_DIR OR NOT LAMMPS_${name}_LIBRARY OR NOT LAMMPS_${name}_EXECUTABLE)
    return()
  endif()

  file(STRINGS ${LAMMPS_${name}_INCLUDE_DIR}/version.h version REGEX "LAMMPS_VERSION")
  string(REGEX REPLACE ".*\"(.*)\".*" "\\1" version "${version}")
  # The mangled name of Plugin::command stands in the library when the package was built in.
  file(STRINGS ${LAMMPS_${name}_LIBRARY} plugin LIMIT_COUNT 1
    REGEX "_ZN9LAMMPS_NS6Plugin7commandEiPPc")

  add_library(LAMMPS::${name} INTERFACE IMPORTED)
  target_include_directories(LAMMPS::${name} SYSTEM INTERFACE ${LAMMPS_${name}_INCLUDE_DIR})
  target_compile_definitions(LAMMPS::${name} INTERFACE OMPI_SKIP_MPICXX=1 LAMMPS_LIB_MPI)
  target_link_libraries(LAMMPS::${name} INTERFACE ${LAMMPS_${name}_LIBRARY} MPI::MPI_CXX)

  set(LAMMPS_${name}_VERSION "${version}" PARENT_SCOPE)
  if(plugin)
    set(LAMMPS_${name}_HAS_PLUGIN TRUE PARENT_SCOPE)
  else()
    set(LAMMPS_${name}_HAS_PLUGIN FALSE PARENT_SCOPE)
  endif()
  set(LAMMPS_ENGINES ${LAMMPS_ENGINES} ${name} PARENT_SCOPE)
endfunction()

if(LAMMPS_ROOT)
  cohesion_add_lammps(given "${LAMMPS_ROOT}/src;${LAMMPS_ROOT}/include/lammps"
    "${LAMMPS_ROOT}/build;${LAMMPS_ROOT}/lib;${LAMMPS_ROOT}/lib64" ${LAMMPS_ROOT}/bin)
else()
  cohesion_add_lammps(stock ${COHESION_CACHE}/lammps-stock/src
    "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE};/usr/lib" /usr/bin)
  cohesion_add_lammps(current ${COHESION_CACHE}/lammps-current/src
    ${COHESION_CACHE}/lammps-current/build)
endif()

if(LAMMPS_ENGINES)
  set(LAMMPS_FOUND TRUE)
else()
  set(LAMMPS_FOUND FALSE)
  set(LAMMPS_NOT_FOUND_MESSAGE
    "no LAMMPS with complete headers; run scripts/setup, or give -DLAMMPS_ROOT=path")
endif()
