# SPDX-License-Identifier: BSD-3-Clause
# OpenFOAM, ESI line. In this order:
#   -DOpenFOAM_ROOT=path     a built source tree
#   a sourced environment    WM_PROJECT_DIR with src/ in it
#   the system's package     with the headers that scripts/setup fetches
#
# Sets OpenFOAM_FOUND, OpenFOAM_VERSION (as 1912), OpenFOAM_BIN_DIR, OpenFOAM_ENVIRONMENT (list of
# NAME=VALUE to run its programs) and the targets OpenFOAM::OpenFOAM, OpenFOAM::finiteVolume,
# OpenFOAM::lagrangian and OpenFOAM::turbulence.

set(OpenFOAM_ROOT "" CACHE PATH "Built OpenFOAM source tree to use instead of the system's")

set(OpenFOAM_LABEL_SIZE 32)
set(OpenFOAM_TREE "${OpenFOAM_ROOT}")
if(NOT OpenFOAM_TREE AND EXISTS "$ENV{WM_PROJECT_DIR}/src/OpenFOAM/lnInclude")
  set(OpenFOAM_TREE "$ENV{WM_PROJECT_DIR}")
  if(DEFINED ENV{WM_LABEL_SIZE})
    set(OpenFOAM_LABEL_SIZE $ENV{WM_LABEL_SIZE})
  endif()
endif()

# Folders of headers, one per library
set(OpenFOAM_MODULES OpenFOAM OSspecific finiteVolume meshTools lagrangian turbulence)
if(OpenFOAM_TREE)
  set(OpenFOAM_OpenFOAM_INCLUDE ${OpenFOAM_TREE}/src/OpenFOAM/lnInclude)
  set(OpenFOAM_OSspecific_INCLUDE ${OpenFOAM_TREE}/src/OSspecific/POSIX/lnInclude)
  set(OpenFOAM_finiteVolume_INCLUDE ${OpenFOAM_TREE}/src/finiteVolume/lnInclude)
  set(OpenFOAM_meshTools_INCLUDE ${OpenFOAM_TREE}/src/meshTools/lnInclude)
  set(OpenFOAM_lagrangian_INCLUDE ${OpenFOAM_TREE}/src/lagrangian/basic/lnInclude)
  foreach(part turbulenceModels incompressible)
    list(APPEND OpenFOAM_turbulence_INCLUDE ${OpenFOAM_TREE}/src/TurbulenceModels/${part}/lnInclude)
  endforeach()
  # Its headers name each other by their folders.
  list(APPEND OpenFOAM_turbulence_INCLUDE ${OpenFOAM_TREE}/src/transportModels
    ${OpenFOAM_TREE}/src/transportModels/incompressible/lnInclude)
  file(GLOB OpenFOAM_PLATFORMS ${OpenFOAM_TREE}/platforms/*/lib)
  set(OpenFOAM_LIB_HINTS ${OpenFOAM_PLATFORMS})
  list(TRANSFORM OpenFOAM_PLATFORMS REPLACE "/lib$" "/bin" OUTPUT_VARIABLE OpenFOAM_BIN_HINTS)
  if(NOT OpenFOAM_ROOT)
    # The environment knows which of several builds, and folders that are elsewhere.
    list(PREPEND OpenFOAM_LIB_HINTS $ENV{FOAM_LIBBIN})
    list(PREPEND OpenFOAM_BIN_HINTS $ENV{FOAM_APPBIN})
  endif()
  file(GLOB OpenFOAM_PSTREAM_HINTS ${OpenFOAM_TREE}/platforms/*/lib/*mpi*)
  list(PREPEND OpenFOAM_PSTREAM_HINTS $ENV{FOAM_LIBBIN}/$ENV{FOAM_MPI})
  set(OpenFOAM_ENVIRONMENT WM_PROJECT_DIR=${OpenFOAM_TREE})
  if(EXISTS ${OpenFOAM_TREE}/META-INFO/api-info)
    file(STRINGS ${OpenFOAM_TREE}/META-INFO/api-info OpenFOAM_VERSION REGEX "api=")
    string(REPLACE "api=" "" OpenFOAM_VERSION "${OpenFOAM_VERSION}")
  endif()
else()
  foreach(module IN LISTS OpenFOAM_MODULES)
    set(OpenFOAM_${module}_INCLUDE ${COHESION_CACHE}/openfoam-stock/lnInclude/${module})
  endforeach()
  set(transport ${COHESION_CACHE}/openfoam-stock/source/src/transportModels)
  list(APPEND OpenFOAM_turbulence_INCLUDE ${transport}
    ${transport}/incompressible/singlePhaseTransportModel)
  set(OpenFOAM_LIB_HINTS /usr/lib /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE})
  set(OpenFOAM_PSTREAM_HINTS /usr/lib/openmpi-system ${OpenFOAM_LIB_HINTS})
  set(OpenFOAM_BIN_HINTS /usr/bin)
  set(OpenFOAM_ENVIRONMENT WM_PROJECT_DIR=/usr/share/openfoam)
  if(EXISTS ${COHESION_CACHE}/openfoam-stock/api)
    file(STRINGS ${COHESION_CACHE}/openfoam-stock/api OpenFOAM_VERSION)
  endif()
endif()

set(OpenFOAM_TURBULENCE_LIBRARIES turbulenceModels incompressibleTransportModels
  incompressibleTurbulenceModels DPMTurbulenceModels)
foreach(library OpenFOAM finiteVolume meshTools lagrangian fvOptions
    ${OpenFOAM_TURBULENCE_LIBRARIES})
  find_library(OpenFOAM_${library}_LIBRARY ${library} PATHS ${OpenFOAM_LIB_HINTS} NO_DEFAULT_PATH)
  mark_as_advanced(OpenFOAM_${library}_LIBRARY)
endforeach()
find_library(OpenFOAM_Pstream_LIBRARY Pstream PATHS ${OpenFOAM_PSTREAM_HINTS} NO_DEFAULT_PATH)
find_path(OpenFOAM_BIN_DIR blockMesh PATHS ${OpenFOAM_BIN_HINTS} NO_DEFAULT_PATH)
find_path(OpenFOAM_HEADERS fvMesh.H PATHS ${OpenFOAM_finiteVolume_INCLUDE} NO_DEFAULT_PATH)
find_path(OpenFOAM_TURBULENCE_HEADERS incompressibleTurbulenceModel.H
  PATHS ${OpenFOAM_turbulence_INCLUDE} NO_DEFAULT_PATH)
mark_as_advanced(OpenFOAM_Pstream_LIBRARY OpenFOAM_BIN_DIR OpenFOAM_HEADERS
  OpenFOAM_TURBULENCE_HEADERS)
if(OpenFOAM_TREE AND OpenFOAM_OpenFOAM_LIBRARY AND OpenFOAM_Pstream_LIBRARY)
  # Its libraries find each other by the environment alone.
  cmake_path(GET OpenFOAM_OpenFOAM_LIBRARY PARENT_PATH folder)
  cmake_path(GET OpenFOAM_Pstream_LIBRARY PARENT_PATH mpi_folder)
  set(folders ${folder} ${mpi_folder} $ENV{LD_LIBRARY_PATH})
  list(JOIN folders ":" folders)
  list(APPEND OpenFOAM_ENVIRONMENT LD_LIBRARY_PATH=${folders})
endif()

set(OpenFOAM_NOT_FOUND_MESSAGE
  "run scripts/setup, source an OpenFOAM environment, or give -DOpenFOAM_ROOT=built-source-tree")
foreach(needed OpenFOAM_OpenFOAM_LIBRARY OpenFOAM_finiteVolume_LIBRARY OpenFOAM_meshTools_LIBRARY
    OpenFOAM_lagrangian_LIBRARY OpenFOAM_fvOptions_LIBRARY OpenFOAM_DPMTurbulenceModels_LIBRARY
    OpenFOAM_Pstream_LIBRARY OpenFOAM_HEADERS OpenFOAM_TURBULENCE_HEADERS OpenFOAM_BIN_DIR
    OpenFOAM_VERSION)
  if(NOT ${needed})
    string(APPEND OpenFOAM_NOT_FOUND_MESSAGE ", no ${needed}")
  endif()
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenFOAM
  REQUIRED_VARS OpenFOAM_OpenFOAM_LIBRARY OpenFOAM_finiteVolume_LIBRARY OpenFOAM_meshTools_LIBRARY
    OpenFOAM_lagrangian_LIBRARY OpenFOAM_fvOptions_LIBRARY OpenFOAM_DPMTurbulenceModels_LIBRARY
    OpenFOAM_Pstream_LIBRARY OpenFOAM_HEADERS OpenFOAM_TURBULENCE_HEADERS OpenFOAM_BIN_DIR
    OpenFOAM_VERSION
  VERSION_VAR OpenFOAM_VERSION
  REASON_FAILURE_MESSAGE "${OpenFOAM_NOT_FOUND_MESSAGE}")

if(OpenFOAM_FOUND AND NOT TARGET OpenFOAM::OpenFOAM)
  add_library(OpenFOAM::OpenFOAM INTERFACE IMPORTED)
  target_include_directories(OpenFOAM::OpenFOAM SYSTEM INTERFACE
    ${OpenFOAM_OpenFOAM_INCLUDE} ${OpenFOAM_OSspecific_INCLUDE})
  target_compile_definitions(OpenFOAM::OpenFOAM INTERFACE
    OPENFOAM=${OpenFOAM_VERSION} WM_DP WM_LABEL_SIZE=${OpenFOAM_LABEL_SIZE} NoRepository
    OMPI_SKIP_MPICXX=1
    # OpenFOAM promises that fields do not overlap and then reuses temporaries in place: with g++ 12 at
    # -O3 the product of a tensor and a vector field reads components that it has overwritten, and
    # fvc::reconstruct is wrong in all cells that are not boxes along the axes.
    __restrict__=)
  target_compile_options(OpenFOAM::OpenFOAM INTERFACE -ftemplate-depth-100 -pthread)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(OpenFOAM::OpenFOAM INTERFACE
      "SHELL:-include ${CMAKE_CURRENT_LIST_DIR}/openfoam_without_deprecated.h")
  endif()
  # Classes that only a case names are found by the libraries' static initialisers.
  target_link_options(OpenFOAM::OpenFOAM INTERFACE -Wl,--no-as-needed)
  target_link_libraries(OpenFOAM::OpenFOAM INTERFACE
    ${OpenFOAM_OpenFOAM_LIBRARY} ${OpenFOAM_Pstream_LIBRARY} ${CMAKE_DL_LIBS} m)

  add_library(OpenFOAM::finiteVolume INTERFACE IMPORTED)
  target_include_directories(OpenFOAM::finiteVolume SYSTEM INTERFACE
    ${OpenFOAM_finiteVolume_INCLUDE} ${OpenFOAM_meshTools_INCLUDE})
  target_link_libraries(OpenFOAM::finiteVolume INTERFACE
    ${OpenFOAM_finiteVolume_LIBRARY} ${OpenFOAM_meshTools_LIBRARY} OpenFOAM::OpenFOAM)

  add_library(OpenFOAM::lagrangian INTERFACE IMPORTED)
  target_include_directories(OpenFOAM::lagrangian SYSTEM INTERFACE ${OpenFOAM_lagrangian_INCLUDE})
  target_link_libraries(OpenFOAM::lagrangian INTERFACE
    ${OpenFOAM_lagrangian_LIBRARY} OpenFOAM::finiteVolume)

  add_library(OpenFOAM::turbulence INTERFACE IMPORTED)
  target_include_directories(OpenFOAM::turbulence SYSTEM INTERFACE ${OpenFOAM_turbulence_INCLUDE})
  foreach(library fvOptions ${OpenFOAM_TURBULENCE_LIBRARIES})
    target_link_libraries(OpenFOAM::turbulence INTERFACE ${OpenFOAM_${library}_LIBRARY})
  endforeach()
  target_link_libraries(OpenFOAM::turbulence INTERFACE OpenFOAM::finiteVolume)
endif()
