# SPDX-License-Identifier: BSD-3-Clause
"""Environment for starting an engine many times. Open MPI's daemon of a single rank, its folder, which that
daemon keeps apart from others', and its search for networks take longer than most runs of the tests; other MPIs
ignore all of it."""
HERE_ONLY = {"OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self,vader", "OMP_NUM_THREADS": "1"}
ALONE = {"OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_orte_create_session_dirs": "0"}


def short_start(ranks=1):
    return HERE_ONLY if ranks > 1 else {**HERE_ONLY, **ALONE}
