# SPDX-License-Identifier: BSD-3-Clause
"""Environment in which a program that uses MPI starts soon. Open MPI spends more time on its start than most runs of
the tests and many of the examples need. Other implementations of MPI ignore all of it."""

# Open MPI searches for networks, and hwloc for devices on the PCI bus. Components that no run here uses are not loaded.
HERE_ONLY = {"OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self,vader", "OMP_NUM_THREADS": "1",
             "OMPI_MCA_op": "^avx", "OMPI_MCA_mpool": "^hugepage", "OMPI_MCA_rcache": "^grdma",
             "HWLOC_COMPONENTS": "-pci,-x86,-linuxio"}
# A program without a launcher starts Open MPI's daemon, with a folder that the daemon keeps apart from others'. Without
# the daemon this folder is the same for all programs: one that ends removes it under another that starts.
ALONE = {"OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_orte_create_session_dirs": "0", "OMPI_MCA_btl": "self",
         "OMPI_MCA_coll": "^sm,tuned,monitoring,adapt,sync,inter,han",
         "OMPI_MCA_state": "^orted,hnp,novm,tool", "OMPI_MCA_errmgr": "^default_tool,default_orted,default_hnp",
         "OMPI_MCA_schizo": "^slurm,jsm,flux", "OMPI_MCA_reachable": "^netlink", "OMPI_MCA_shmem": "^sysv,posix"}


def short_start(ranks=0):
    """What to add to the environment of a program that is started many times; `ranks`: those under a launcher of MPI,
    0 without one."""
    return HERE_ONLY if ranks else {**HERE_ONLY, **ALONE}
