# SPDX-License-Identifier: BSD-3-Clause
# LAMMPS, as many as there are.
#
#   find_package(LAMMPS)
#
# Without LAMMPS_ROOT these engines are looked for:
#   stock    the system's package, with the complete headers that scripts/setup fetches
#   current  a recent release with `plugin load`, built by scripts/setup
#   newest   Debian unstable's, built by scripts/setup, where COHESION_NEWEST_LAMMPS is ON
# With LAMMPS_ROOT that one alone, called "given". LAMMPS_ROOT is its source tree (an installed one
# lacks headers that styles need), built in LAMMPS_BUILD: a build folder or an install prefix,
# LAMMPS_ROOT/build unless given. LAMMPS_ROOT may also be a prefix into which all headers were put.
#
# Sets LAMMPS_ENGINES and, for each NAME in it, the target LAMMPS::NAME and LAMMPS_<NAME>_VERSION,
# LAMMPS_<NAME>_EXECUTABLE and LAMMPS_<NAME>_HAS_PLUGIN (whether it knows `plugin load`).

set(LAMMPS_ROOT "" CACHE PATH "LAMMPS to use instead of the system's")
set(LAMMPS_BUILD "" CACHE PATH "Build folder or install prefix of LAMMPS_ROOT (LAMMPS_ROOT/build)")
option(COHESION_NEWEST_LAMMPS "Test the newest LAMMPS, too (scripts/setup --newest-lammps builds it)" OFF)
set(LAMMPS_ENGINES "")
# Those from source that are wanted
set(LAMMPS_FROM_SOURCE current)
if(COHESION_NEWEST_LAMMPS)
  list(APPEND LAMMPS_FROM_SOURCE newest)
endif()

# cohesion_add_lammps(name folders-of-headers folders-of-library-and-program)
function(cohesion_add_lammps name headers hints)
  find_path(LAMMPS_${name}_INCLUDE_DIR lammpsplugin.h PATHS ${headers} NO_DEFAULT_PATH)
  find_library(LAMMPS_${name}_LIBRARY NAMES lammps lammps_mpi PATHS ${hints} NO_DEFAULT_PATH)
  find_program(LAMMPS_${name}_EXECUTABLE NAMES lmp lmp_mpi PATHS ${hints} NO_DEFAULT_PATH)
  mark_as_advanced(LAMMPS_${name}_INCLUDE_DIR LAMMPS_${name}_LIBRARY LAMMPS_${name}_EXECUTABLE)
  if(NOT LAMMPS_${name}_INCLUDE_DIR OR NOT LAMMPS_${name}_LIBRARY OR NOT LAMMPS_${name}_EXECUTABLE)
    set(missing "")
    list(JOIN headers " " header_places)
    list(JOIN hints " " places)
    if(NOT LAMMPS_${name}_INCLUDE_DIR)
      string(APPEND missing ", no lammpsplugin.h in ${header_places}")
    endif()
    if(NOT LAMMPS_${name}_LIBRARY)
      string(APPEND missing ", no shared library liblammps in ${places}")
    endif()
    if(NOT LAMMPS_${name}_EXECUTABLE)
      string(APPEND missing ", no program lmp in ${places}")
    endif()
    set(LAMMPS_NOT_FOUND_MESSAGE "${LAMMPS_NOT_FOUND_MESSAGE}${missing}" PARENT_SCOPE)
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

set(LAMMPS_NOT_FOUND_MESSAGE "run scripts/setup, or give -DLAMMPS_ROOT=source-tree and \
-DLAMMPS_BUILD=folder (shared library, lmp)")
if(LAMMPS_ROOT)
  set(hints ${LAMMPS_BUILD} ${LAMMPS_BUILD}/lib ${LAMMPS_BUILD}/lib64 ${LAMMPS_BUILD}/bin)
  if(NOT LAMMPS_BUILD)
    set(hints ${LAMMPS_ROOT}/build ${LAMMPS_ROOT}/src
      ${LAMMPS_ROOT}/lib ${LAMMPS_ROOT}/lib64 ${LAMMPS_ROOT}/bin)
  endif()
  cohesion_add_lammps(given "${LAMMPS_ROOT}/src;${LAMMPS_ROOT}/include/lammps" "${hints}")
else()
  cohesion_add_lammps(stock ${COHESION_CACHE}/lammps-stock/src
    "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE};/usr/lib;/usr/bin")
  foreach(name IN LISTS LAMMPS_FROM_SOURCE)
    if(EXISTS ${COHESION_CACHE}/lammps-${name}/done)
      cohesion_add_lammps(${name} ${COHESION_CACHE}/lammps-${name}/src ${COHESION_CACHE}/lammps-${name}/build)
    endif()
  endforeach()
endif()

if(LAMMPS_ENGINES)
  set(LAMMPS_FOUND TRUE)
else()
  set(LAMMPS_FOUND FALSE)
endif()
