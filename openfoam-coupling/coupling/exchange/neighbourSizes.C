// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbourSizes.H"

#include "UPstream.H"
#include "error.H"

#include "exchangeTraffic.H"

#include <mpi.h>

#include <vector>

namespace
{

//- FatalError unless a message holds one label
void requireLabel(const MPI_Status& from)
{
    int came = 0;
    MPI_Get_count(&from, MPI_BYTE, &came);
    if (came != int(sizeof(Foam::label)))
    {
        FatalErrorInFunction
            << "rank " << from.MPI_SOURCE << " said in " << came << " bytes how much it is about to send to rank "
            << Foam::UPstream::myProcNo() << ", which expected a number of " << int(sizeof(Foam::label))
            << " bytes; are all ranks of the same build?" << Foam::exit(Foam::FatalError);
    }
}

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
    const int tag = odd_ ? oddTag : evenTag;
    const auto world = MPI_COMM_WORLD;
    const int bytes = sizeof(label);

    std::vector<MPI_Request> arrivals;
    forAll(sent, rank)
    {
        if (rank != me && sent[rank])
        {
            arrivals.emplace_back();
            MPI_Issend(&sent[rank], bytes, MPI_BYTE, rank, tag, world, &arrivals.back());
            exchangeTraffic::ofRank().count(rank, sizeof(label));
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
            requireLabel(from);
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
