# SPDX-License-Identifier: BSD-3-Clause
"""Environment of programs that start an engine many times: Open MPI's daemon of a single rank and its search for
networks would take longer than most of these runs. Other MPIs ignore it. ctest sets the same, cmake/CohesionTest.cmake."""
SHORT_START = {"OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self,vader",
               "OMP_NUM_THREADS": "1"}
