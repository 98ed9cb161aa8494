// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleExchange.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "polyMesh.H"

Foam::particleExchange::particleExchange(const polyMesh& mesh)
:
    mesh_(mesh),
    search_(mesh, polyMesh::FACE_PLANES),
    rankBounds_(Pstream::nProcs()),
    nEngine_(0)
{
    // A particle on the outermost face must not fall between two boxes by round-off.
    boundBox bounds(mesh.points(), false);
    bounds.inflate(1e-9);
    rankBounds_[Pstream::myProcNo()] = bounds;
    Pstream::gatherList(rankBounds_);
    Pstream::scatterList(rankBounds_);
}


Foam::mapDistributeBase Foam::particleExchange::makeMap(labelListList&& sent)
{
    labelList received;
    Pstream::exchangeSizes(sent, received);

    labelListList constructed(received.size());
    label start = 0;
    forAll(received, rank)
    {
        constructed[rank] = identity(received[rank], start);
        start += received[rank];
    }
    return mapDistributeBase(start, std::move(sent), std::move(constructed));
}


void Foam::particleExchange::reportOutside
(
    const UList<point>& positions,
    const labelList& owners
) const
{
    label nOutside = 0;
    point example = point::max;
    forAll(owners, i)
    {
        if (owners[i] < 0)
        {
            ++nOutside;
            example = min(example, positions[i]);
        }
    }
    reduce(nOutside, sumOp<label>());
    reduce(example, minOp<point>());

    FatalErrorInFunction
        << nOutside << " particles are outside the mesh " << mesh_.bounds()
        << "; the lowest of their coordinates are " << example << nl
        << "    Make the mesh as large as the box of the particles, or give the"
        << " particle script walls that keep them inside"
        << exit(FatalError);
    std::abort();
}


void Foam::particleExchange::locate(const UList<point>& positions)
{
    nEngine_ = positions.size();
    const label nRanks = Pstream::nProcs();

    // Ask every rank whose box holds the particle ...
    List<DynamicList<label>> candidates(nRanks);
    List<DynamicList<point>> questions(nRanks);
    forAll(positions, i)
    {
        forAll(rankBounds_, rank)
        {
            if (rankBounds_[rank].contains(positions[i]))
            {
                candidates[rank].append(i);
                questions[rank].append(positions[i]);
            }
        }
    }
    List<DynamicList<point>> asked(nRanks);
    Pstream::exchange<DynamicList<point>, point>(questions, asked);

    List<DynamicList<label>> answers(nRanks);
    forAll(asked, rank)
    {
        for (const point& position : asked[rank])
        {
            answers[rank].append(search_.findCell(position, -1, true));
        }
    }
    List<DynamicList<label>> answered(nRanks);
    Pstream::exchange<DynamicList<label>, label>(answers, answered);

    // ... and give it to the first that has a cell for it.
    labelList owners(nEngine_, -1);
    labelList cellsOfOwner(nEngine_, -1);
    labelListList sent(nRanks);
    forAll(candidates, rank)
    {
        DynamicList<label> accepted(candidates[rank].size());
        forAll(candidates[rank], k)
        {
            const label i = candidates[rank][k];
            if (owners[i] < 0 && answered[rank][k] >= 0)
            {
                owners[i] = rank;
                cellsOfOwner[i] = answered[rank][k];
                accepted.append(i);
            }
        }
        sent[rank].transfer(accepted);
    }

    if (returnReduce(owners.found(-1), orOp<bool>()))
    {
        reportOutside(positions, owners);
    }

    map_.reset(new mapDistributeBase(makeMap(std::move(sent))));
    cells_ = toGas(cellsOfOwner);
}
