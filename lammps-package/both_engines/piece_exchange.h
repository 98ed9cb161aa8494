// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_PIECE_EXCHANGE_H
#define COHESION_PIECE_EXCHANGE_H

#include <mpi.h>

#include <vector>

#include "agglomerates/piece.h"

namespace LAMMPS_NS {

/// Every label belongs to one rank, its number modulo the ranks: there the pieces of an agglomerate
/// are put together. Gives the agglomerates that belong to this rank; `sizes`: of those that this
/// rank's own pieces are part of, in their order. All ranks must call it.
std::vector<cohesion::agglomerates::Piece> whole_pieces(
    MPI_Comm, const std::vector<cohesion::agglomerates::Piece>& mine, std::vector<double>& sizes);

}  // namespace LAMMPS_NS

#endif
