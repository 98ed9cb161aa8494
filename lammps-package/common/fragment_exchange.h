// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FRAGMENT_EXCHANGE_H
#define COHESION_FRAGMENT_EXCHANGE_H

#include <mpi.h>

#include <vector>

#include "agglomerates/fragment.h"

namespace LAMMPS_NS {

/// Merges the fragments of all ranks, each on the rank that its label belongs to: the label modulo
/// the number of ranks. Returns the agglomerates that belong to this rank; `extents`: of those that
/// this rank's own fragments are part of, in the order of `mine`. Collective.
std::vector<cohesion::agglomerates::Fragment> merge_across_ranks(
    MPI_Comm, const std::vector<cohesion::agglomerates::Fragment>& mine,
    std::vector<cohesion::agglomerates::Extent>& extents);

}  // namespace LAMMPS_NS

#endif
