# SPDX-License-Identifier: BSD-3-Clause
# The libraries and headers of OpenFOAM's twoPhaseEulerFoam, whose models a library can add to. Looks where
# FindOpenFOAM.cmake has found OpenFOAM.
#
# Sets OpenFOAMTwoFluid_FOUND, OpenFOAMTwoFluid_VERSION and the target OpenFOAM::twoFluid.

# The models' base classes change from version to version, and those of others were not at hand.
set(OpenFOAMTwoFluid_KNOWN 1912)

if(OpenFOAM_TREE)
  set(folder ${OpenFOAM_TREE}/applications/solvers/multiphase/twoPhaseEulerFoam)
  set(OpenFOAMTwoFluid_INCLUDE ${OpenFOAM_TREE}/src/thermophysicalModels/basic/lnInclude
    ${OpenFOAM_TREE}/src/transportModels/compressible/lnInclude
    ${OpenFOAM_TREE}/src/transportModels/incompressible/lnInclude
    ${folder}/twoPhaseSystem/lnInclude ${folder}/interfacialModels/lnInclude
    ${folder}/phaseCompressibleTurbulenceModels/lnInclude)
else()
  set(OpenFOAMTwoFluid_INCLUDE ${COHESION_CACHE}/openfoam-stock/lnInclude/twoPhase)
endif()

set(OpenFOAMTwoFluid_LIBRARIES compressibleEulerianInterfacialModels compressibleTwoPhaseSystem
  phaseCompressibleTurbulenceModels fluidThermophysicalModels)
set(needed "")
foreach(library IN LISTS OpenFOAMTwoFluid_LIBRARIES)
  find_library(OpenFOAM_${library}_LIBRARY ${library} PATHS ${OpenFOAM_LIB_HINTS} NO_DEFAULT_PATH)
  list(APPEND needed OpenFOAM_${library}_LIBRARY)
endforeach()
find_path(OpenFOAMTwoFluid_DRAG dragModel.H PATHS ${OpenFOAMTwoFluid_INCLUDE} NO_DEFAULT_PATH)
find_path(OpenFOAMTwoFluid_KINETIC_THEORY radialModel.H PATHS ${OpenFOAMTwoFluid_INCLUDE} NO_DEFAULT_PATH)
list(APPEND needed OpenFOAMTwoFluid_DRAG OpenFOAMTwoFluid_KINETIC_THEORY)
mark_as_advanced(${needed})

set(OpenFOAMTwoFluid_NOT_FOUND_MESSAGE "run scripts/setup, which fetches its headers")
foreach(name IN LISTS needed)
  if(NOT ${name})
    string(APPEND OpenFOAMTwoFluid_NOT_FOUND_MESSAGE ", no ${name}")
  endif()
endforeach()
set(OpenFOAMTwoFluid_VERSION_KNOWN FALSE)
if(NOT BUILD_OpenFOAM)
  set(OpenFOAMTwoFluid_NOT_FOUND_MESSAGE "the OpenFOAM coupling is left out")
  if(COHESION_OPENFOAM STREQUAL "OFF")
    set(OpenFOAMTwoFluid_NOT_FOUND_MESSAGE "COHESION_OPENFOAM is OFF")
  endif()
elseif(OpenFOAM_VERSION IN_LIST OpenFOAMTwoFluid_KNOWN)
  set(OpenFOAMTwoFluid_VERSION_KNOWN TRUE)
else()
  set(OpenFOAMTwoFluid_NOT_FOUND_MESSAGE
    "models of twoPhaseEulerFoam are known of OpenFOAM v${OpenFOAMTwoFluid_KNOWN}, this is v${OpenFOAM_VERSION}")
endif()
set(OpenFOAMTwoFluid_VERSION ${OpenFOAM_VERSION})

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenFOAMTwoFluid
  REQUIRED_VARS ${needed} OpenFOAMTwoFluid_VERSION_KNOWN
  VERSION_VAR OpenFOAMTwoFluid_VERSION
  REASON_FAILURE_MESSAGE "${OpenFOAMTwoFluid_NOT_FOUND_MESSAGE}")

if(OpenFOAMTwoFluid_FOUND AND NOT TARGET OpenFOAM::twoFluid)
  add_library(OpenFOAM::twoFluid INTERFACE IMPORTED)
  target_include_directories(OpenFOAM::twoFluid SYSTEM INTERFACE ${OpenFOAMTwoFluid_INCLUDE})
  foreach(library IN LISTS OpenFOAMTwoFluid_LIBRARIES)
    target_link_libraries(OpenFOAM::twoFluid INTERFACE ${OpenFOAM_${library}_LIBRARY})
  endforeach()
  target_link_libraries(OpenFOAM::twoFluid INTERFACE OpenFOAM::finiteVolume)
endif()
