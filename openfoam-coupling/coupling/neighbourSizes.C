// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbourSizes.H"

#include "UPstream.H"

#include <mpi.h>

#include <vector>

namespace
{

// Of the even and of the odd rounds; used by neither OpenFOAM nor the particle engines
constexpr int tags[] = {20101, 20102};

} // End anonymous namespace


Foam::labelList Foam::neighbourSizes::operator()(const labelUList& sent)
{
    labelList received(sent.size(), Zero);
    const label me = UPstream::myProcNo();
    received[me] = sent[me];
    if (!UPstream::parRun())
    {
        return received;
    }
    odd_ = !odd_;
    const int tag = tags[odd_];
    const auto world = MPI_COMM_WORLD;
    const int bytes = sizeof(label);

    std::vector<MPI_Request> arrivals;
    forAll(sent, rank)
    {
        if (rank != me && sent[rank])
        {
            arrivals.emplace_back();
            MPI_Issend(&sent[rank], bytes, MPI_BYTE, rank, tag, world, &arrivals.back());
        }
    }

    MPI_Request barrier = MPI_REQUEST_NULL;
    int all = 0;
    while (!all)
    {
        MPI_Status from;
        int there = 0;
        MPI_Iprobe(MPI_ANY_SOURCE, tag, world, &there, &from);
        if (there)
        {
            const int rank = from.MPI_SOURCE;
            MPI_Recv(&received[rank], bytes, MPI_BYTE, rank, tag, world, MPI_STATUS_IGNORE);
        }
        if (barrier != MPI_REQUEST_NULL)
        {
            MPI_Test(&barrier, &all, MPI_STATUS_IGNORE);
            continue;
        }
        int arrived = 0;
        MPI_Testall(int(arrivals.size()), arrivals.data(), &arrived, MPI_STATUSES_IGNORE);
        if (arrived)
        {
            MPI_Ibarrier(world, &barrier);
        }
    }
    return received;
}
