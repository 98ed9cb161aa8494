# SPDX-License-Identifier: BSD-3-Clause
# Options of the deliverables, the search for their engines, and the summary.

# Where scripts/setup keeps what it fetched and built; outside the build folder.
function(cohesion_cache_folder variable)
  if(DEFINED ENV{COHESION_CACHE})
    set(folder $ENV{COHESION_CACHE})
  else()
    set(folder $ENV{HOME}/.cache/cohesion)
  endif()
  set(${variable} ${folder} CACHE PATH "Folder of fetched headers and of the current LAMMPS")
endfunction()

function(cohesion_option name what)
  set(${name} AUTO CACHE STRING "${what}: ON, OFF, or AUTO (built when its engine is found)")
  set_property(CACHE ${name} PROPERTY STRINGS ON OFF AUTO)
  string(TOUPPER "${${name}}" value)
  if(NOT value MATCHES "^(ON|OFF|AUTO)$")
    message(FATAL_ERROR "${name} = ${${name}}: must be ON, OFF or AUTO")
  endif()
endfunction()

# Sets BUILD_<engine>. A macro: the find module's variables are the caller's.
macro(cohesion_find_engine option engine)
  set(BUILD_${engine} FALSE)
  if(NOT "${${option}}" STREQUAL "OFF")
    find_package(MPI QUIET COMPONENTS C CXX)
    find_package(${engine} QUIET)
    if(${engine}_FOUND AND MPI_FOUND)
      set(BUILD_${engine} TRUE)
    elseif("${${option}}" STREQUAL "ON")
      message(FATAL_ERROR "${option} is ON, but ${engine} was not found: run scripts/setup, or "
        "give -D${engine}_ROOT=path (and MPI must be installed)")
    endif()
  endif()
endmacro()

function(cohesion_report what option engine version)
  if(BUILD_${engine})
    message(STATUS "  ${what}: ${version}")
  elseif("${${option}}" STREQUAL "OFF")
    message(STATUS "  ${what}: left out, ${option} is OFF")
  else()
    message(STATUS "  ${what}: left out, ${engine} was not found (run scripts/setup, or give "
      "-D${engine}_ROOT=path)")
  endif()
endfunction()

function(cohesion_summary)
  set(versions "")
  foreach(name IN LISTS LAMMPS_ENGINES)
    list(APPEND versions "${LAMMPS_${name}_VERSION} (${name})")
  endforeach()
  list(JOIN versions ", " versions)

  message(STATUS "Cohesion ${PROJECT_VERSION}")
  cohesion_report("LAMMPS package" COHESION_LAMMPS LAMMPS "for LAMMPS ${versions}")
  cohesion_report("LIGGGHTS styles" COHESION_LIGGGHTS LIGGGHTS "for LIGGGHTS ${LIGGGHTS_VERSION}")
  cohesion_report("OpenFOAM coupling" COHESION_OPENFOAM OpenFOAM
    "for OpenFOAM v${OpenFOAM_VERSION}")
  if(BUILD_LAMMPS AND NOT "current" IN_LIST LAMMPS_ENGINES AND NOT LAMMPS_ROOT)
    set(reason "scripts/setup --current-lammps has not built it")
    if(EXISTS ${COHESION_CACHE}/lammps-current.missing)
      file(STRINGS ${COHESION_CACHE}/lammps-current.missing reason)
    endif()
    message(STATUS "  current LAMMPS: not tested, ${reason}")
  endif()
endfunction()
