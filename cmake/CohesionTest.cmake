# SPDX-License-Identifier: BSD-3-Clause
# cohesion_add_test(NAME name LABELS label... COMMAND command...
#                   [RANKS n] [TIMEOUT seconds] [COST seconds] [PROCESSORS n] [ENVIRONMENT name=value...]
#                   [MODULES folder...])
#
# A ctest test; with RANKS under mpiexec. Labels: unit, regression, verification, mpi, long; what is labelled mpi runs
# on 2 ranks and so takes 2 cores, and what is labelled long is left out by scripts/run-tests. The timeout (600 s) is
# a guard against hangs, far above what a test takes: ranks that share a busy machine wait for each other. Tests of
# high COST begin first, so that no long one is left over when the others have ended; by itself ctest knows what they
# took the last time in this build folder. COHESION_TEST_COSTS has the longest. Python finds the packages of
# tests/support and examples/common, and what lies in the folders of MODULES. MPI looks for no network. Ranks that wait
# keep their cores unless there are more ranks than cores (Open MPI's default): a rank that yields waits at every
# message for a time slice of each other test.

# Names, lammps.*.NAME without the engine, and seconds of a core, of tests that need ten or more
set(COHESION_TEST_COSTS
  coupling.still_gas_on_meshes 75
  coupling.pages.getting-started 50
  coupling.powder_case 35
  coupling.liggghts.powder_case 30
  lammps.gran_hamaker_many 28
  coupling.moving_cuts 23
  coupling.agglomerate_drag 16
  coupling.packed_bed_on_meshes 16
  coupling.closed_vessels 14
  lammps.pages 14
  coupling.two_fluid_uniform_beds 12
  coupling.liggghts.packed_mixture 12
  liggghts.jkr 12
  coupling.gas_density 10
  lammps.hard_square_well_ranks 10)

function(cohesion_add_test)
  cmake_parse_arguments(T "" "NAME;RANKS;TIMEOUT;COST;PROCESSORS" "LABELS;COMMAND;ENVIRONMENT;MODULES" ${ARGN})
  set(processors 1)
  if(T_PROCESSORS)
    set(processors ${T_PROCESSORS})
  elseif("mpi" IN_LIST T_LABELS)
    set(processors 2)
  endif()
  if(T_RANKS)
    set(T_COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe ${MPIEXEC_NUMPROC_FLAG} ${T_RANKS}
      ${T_COMMAND})
  endif()
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 600)
  endif()
  if(NOT T_NAME OR NOT T_LABELS OR NOT T_COMMAND OR T_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "cohesion_add_test(NAME ${T_NAME}): needs NAME, LABELS and COMMAND; "
      "unknown arguments: '${T_UNPARSED_ARGUMENTS}'")
  endif()
  set(modules ${PROJECT_SOURCE_DIR}/tests/support ${PROJECT_SOURCE_DIR}/examples/common ${T_MODULES})
  list(JOIN modules ":" modules)
  set(environment OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    OMPI_MCA_pml=ob1 OMP_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
    "PYTHONPATH=${modules}"
    ${T_ENVIRONMENT})
  add_test(NAME ${T_NAME} COMMAND ${T_COMMAND})
  set_tests_properties(${T_NAME} PROPERTIES
    LABELS "${T_LABELS}"
    TIMEOUT ${T_TIMEOUT}
    PROCESSORS ${processors}
    ENVIRONMENT "${environment}")
  string(REGEX REPLACE "^lammps\\.[^.]+\\." "lammps." key "${T_NAME}")
  list(FIND COHESION_TEST_COSTS ${key} place)
  if(NOT T_COST AND place GREATER -1)
    math(EXPR place "${place} + 1")
    list(GET COHESION_TEST_COSTS ${place} T_COST)
  endif()
  if(T_COST)
    set_tests_properties(${T_NAME} PROPERTIES COST ${T_COST})
  endif()
endfunction()
