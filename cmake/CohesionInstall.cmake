# SPDX-License-Identifier: BSD-3-Clause
# cmake --install: where what goes, relative to the prefix, which may be moved afterwards.
#
# COHESION_TREE holds programs and libraries in folders like those of the build folder (lammps/stock, liggghts, openfoam,
# tools, summary.txt), so that what takes a build folder takes an installation too; the programs are linked into bin/.
# Each component is a package of CPack.

include(GNUInstallDirs)
set(COHESION_TREE ${CMAKE_INSTALL_LIBDIR}/cohesion)
set(COHESION_SHARE ${CMAKE_INSTALL_DATADIR}/cohesion)
# Folders of engines outside of the project and of the system's places
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)

# What the linker is to find beside a library or program, and in the further folders.
function(cohesion_install target folder component)
  set(rpath "$ORIGIN")
  foreach(other IN LISTS ARGN)
    list(APPEND rpath "$ORIGIN/${other}")
  endforeach()
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "${rpath}" COHESION_FOLDER ${folder})
  set_property(GLOBAL APPEND PROPERTY COHESION_INSTALLED ${target})
  install(TARGETS ${target}
    LIBRARY DESTINATION ${COHESION_TREE}/${folder} COMPONENT ${component}
    RUNTIME DESTINATION ${COHESION_TREE}/${folder} COMPONENT ${component})
endfunction()

# The same for a program, called `name`, with its link in bin/.
function(cohesion_install_program target name folder component)
  cohesion_install(${target} ${folder} ${component} ${ARGN})
  set(link ${CMAKE_BINARY_DIR}/installed/bin/${name})
  file(RELATIVE_PATH there ${CMAKE_INSTALL_FULL_BINDIR}
    ${CMAKE_INSTALL_FULL_LIBDIR}/cohesion/${folder}/${name})
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/installed/bin)
  file(CREATE_LINK ${there} ${link} SYMBOLIC)
  install(FILES ${link} DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component})
endfunction()

# A file made of a template: FILE.in of cmake/installed, with the relative ways that it needs.
function(cohesion_install_made file destination component)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/installed/${file}.in ${CMAKE_BINARY_DIR}/installed/${file} @ONLY)
  install(${ARGN} ${CMAKE_BINARY_DIR}/installed/${file} DESTINATION ${destination} COMPONENT ${component})
endfunction()

# Headers of the laws, with a package for find_package(Cohesion).
function(cohesion_install_headers)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cohesion COMPONENT dev
    FILES_MATCHING PATTERN "*.h")
  install(FILES ${CMAKE_BINARY_DIR}/generated/cohesion_version.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cohesion COMPONENT dev)
  install(TARGETS cohesion_core EXPORT Cohesion)
  set(place ${CMAKE_INSTALL_DATADIR}/cmake/Cohesion)
  install(EXPORT Cohesion NAMESPACE Cohesion:: FILE CohesionConfig.cmake DESTINATION ${place} COMPONENT dev)
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file(${CMAKE_BINARY_DIR}/installed/CohesionConfigVersion.cmake
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
  install(FILES ${CMAKE_BINARY_DIR}/installed/CohesionConfigVersion.cmake DESTINATION ${place} COMPONENT dev)
endfunction()

# Examples, which hold the Python package of all, and the command that starts their programs.
function(cohesion_install_examples)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${COHESION_SHARE} COMPONENT studies
    USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
  set(module ${CMAKE_BINARY_DIR}/installed/python/cohesion_studies)
  file(RELATIVE_PATH there ${CMAKE_INSTALL_PREFIX}/lib/python3/dist-packages
    ${CMAKE_INSTALL_FULL_DATADIR}/cohesion/examples/common/cohesion_studies)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/installed/python)
  file(CREATE_LINK ${there} ${module} SYMBOLIC)
  install(FILES ${module} DESTINATION lib/python3/dist-packages COMPONENT studies)

  file(RELATIVE_PATH COHESION_EXAMPLES_OF_BIN ${CMAKE_INSTALL_FULL_BINDIR}
    ${CMAKE_INSTALL_FULL_DATADIR}/cohesion/examples)
  find_program(COHESION_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
  if(NOT COHESION_PYTHON)
    set(COHESION_PYTHON "/usr/bin/env python3")
  endif()
  cohesion_install_made(cohesion-studies ${CMAKE_INSTALL_BINDIR} studies PROGRAMS)
endfunction()

# What tells programs of the tree, and of what is built, and the environment of shells.
function(cohesion_install_environment)
  file(RELATIVE_PATH COHESION_TREE_OF_SHARE ${CMAKE_INSTALL_FULL_DATADIR}/cohesion ${CMAKE_INSTALL_FULL_LIBDIR}/cohesion)
  file(RELATIVE_PATH COHESION_PREFIX_OF_SHARE ${CMAKE_INSTALL_FULL_DATADIR}/cohesion ${CMAKE_INSTALL_PREFIX})
  cohesion_install_made(tree ${COHESION_SHARE} common FILES)
  cohesion_install_made(environment.sh ${COHESION_SHARE} common FILES)
  install(FILES ${CMAKE_BINARY_DIR}/summary.txt DESTINATION ${COHESION_TREE} COMPONENT common)

  set(modules ${CMAKE_INSTALL_DATADIR}/modulefiles/cohesion)
  file(RELATIVE_PATH COHESION_PREFIX_OF_MODULE ${CMAKE_INSTALL_FULL_DATADIR}/modulefiles/cohesion
    ${CMAKE_INSTALL_PREFIX})
  set(COHESION_MODULE_LINES "")
  foreach(setting IN LISTS OpenFOAM_ENVIRONMENT)
    string(REGEX MATCH "^([^=]+)=(.*)$" setting "${setting}")
    if(CMAKE_MATCH_1 STREQUAL "LD_LIBRARY_PATH")
      string(APPEND COHESION_MODULE_LINES "prepend-path LD_LIBRARY_PATH ${CMAKE_MATCH_2}\n")
    else()
      string(APPEND COHESION_MODULE_LINES "setenv ${CMAKE_MATCH_1} ${CMAKE_MATCH_2}\n")
    endif()
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/installed/modulefile.in
    ${CMAKE_BINARY_DIR}/installed/${PROJECT_VERSION} @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/installed/${PROJECT_VERSION} DESTINATION ${modules} COMPONENT common)
endfunction()

function(cohesion_install_pages)
  install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)
  install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)
  # Pages name examples as in the repository.
  file(RELATIVE_PATH there ${CMAKE_INSTALL_FULL_DOCDIR} ${CMAKE_INSTALL_FULL_DATADIR}/cohesion/examples)
  file(CREATE_LINK ${there} ${CMAKE_BINARY_DIR}/installed/examples SYMBOLIC)
  install(FILES ${CMAKE_BINARY_DIR}/installed/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)
endfunction()
