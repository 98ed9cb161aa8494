// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchangeTraffic.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "messageStream.H"


Foam::exchangeTraffic& Foam::exchangeTraffic::ofRank()
{
    static exchangeTraffic traffic;
    return traffic;
}


void Foam::exchangeTraffic::count(const label rank, const std::size_t bytes)
{
    messages_ += 1;
    bytes_ += bytes;
    to_.setSize(UPstream::nProcs(), false);
    ranks_ += !to_[rank];
    to_[rank] = true;
}


void Foam::exchangeTraffic::startStep()
{
    if (!steps_)
    {
        messages_ = 0;
        bytes_ = 0;
        ranks_ = 0;
    }
    ++steps_;
    to_ = false;
}


void Foam::exchangeTraffic::report() const
{
    const label nRanks = UPstream::nProcs();
    Info<< nl << "What a rank sent of the particles to others per gas step, mean and largest of "
        << nRanks << " ranks" << nl;
    const auto row = [&](const char* name, const scalar all)
    {
        const scalar mine = all/max(steps_, label(1));
        const scalar mean = returnReduce(mine, sumOp<scalar>())/nRanks;
        const scalar largest = returnReduce(mine, maxOp<scalar>());
        Info<< "    " << name << mean << ", " << largest << nl;
    };
    row("messages   ", messages_);
    row("bytes      ", bytes_);
    row("to ranks   ", ranks_);
}
