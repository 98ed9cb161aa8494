// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchangeLists.H"

#include "error.H"

#include "exchangeTraffic.H"

#include <mpi.h>

namespace
{

// The tag is used by neither OpenFOAM nor the particle engines; neighbourSizes has those before it.
constexpr int tag = 20103;


//- Receives the next message of a rank. FatalError when it is not as large as expected
void receive(const int rank, const Foam::Records& expected, const MPI_Datatype record, const std::size_t bytes)
{
    MPI_Message message;
    MPI_Status status;
    MPI_Mprobe(rank, tag, MPI_COMM_WORLD, &message, &status);
    int count = 0;
    MPI_Get_count(&status, record, &count);  // MPI_UNDEFINED where a record is not whole
    if (count != expected.count)
    {
        int came = 0;
        MPI_Get_elements(&status, record, &came);
        FatalErrorInFunction
            << "rank " << rank << " sent " << came << " bytes to rank " << Foam::UPstream::myProcNo()
            << ", which expected " << expected.count << " records of " << Foam::label(bytes)
            << " bytes: the ranks disagree on what they exchange; are all of them of the same build?"
            << Foam::exit(Foam::FatalError);
    }
    MPI_Mrecv(expected.first, count, record, &message, MPI_STATUS_IGNORE);
}

} // End anonymous namespace


void Foam::exchangeRecords
(
    const std::vector<Records>& sent,
    const std::vector<Records>& expected,
    const std::size_t bytes
)
{
    if (!UPstream::parRun())
    {
        return;
    }
    MPI_Datatype record;
    MPI_Type_contiguous(int(bytes), MPI_BYTE, &record);
    MPI_Type_commit(&record);

    std::vector<MPI_Request> requests;
    for (std::size_t rank = 0; rank < sent.size(); ++rank)
    {
        if (sent[rank].count)
        {
            requests.emplace_back();
            const Records& r = sent[rank];
            MPI_Isend(r.first, r.count, record, int(rank), tag, MPI_COMM_WORLD, &requests.back());
            exchangeTraffic::ofRank().count(label(rank), r.count*bytes);
        }
    }
    for (std::size_t rank = 0; rank < expected.size(); ++rank)
    {
        if (expected[rank].count)
        {
            receive(int(rank), expected[rank], record, bytes);
        }
    }
    MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    MPI_Type_free(&record);
}
