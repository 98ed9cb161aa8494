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


Foam::List<Foam::DynamicList<Foam::label>> Foam::particleExchange::candidates
(
    const UList<point>& positions
) const
{
    List<DynamicList<label>> found(rankBounds_.size());
    forAll(positions, i)
    {
        forAll(rankBounds_, rank)
        {
            if (rankBounds_[rank].contains(positions[i]))
            {
                found[rank].append(i);
            }
        }
    }
    return found;
}


Foam::List<Foam::DynamicList<Foam::label>> Foam::particleExchange::askForCells
(
    const UList<point>& positions,
    const List<DynamicList<label>>& mayHold
) const
{
    List<DynamicList<point>> questions(mayHold.size());
    forAll(mayHold, rank)
    {
        for (const label i : mayHold[rank])
        {
            questions[rank].append(positions[i]);
        }
    }
    List<DynamicList<point>> asked(mayHold.size());
    Pstream::exchange<DynamicList<point>, point>(questions, asked);

    List<DynamicList<label>> answers(mayHold.size());
    forAll(asked, rank)
    {
        for (const point& position : asked[rank])
        {
            answers[rank].append(search_.findCell(position, -1, true));
        }
    }
    List<DynamicList<label>> cells(mayHold.size());
    Pstream::exchange<DynamicList<label>, label>(answers, cells);
    return cells;
}


Foam::particleExchange::Places Foam::particleExchange::firstClaims
(
    const label nParticles,
    const List<DynamicList<label>>& mayHold,
    const List<DynamicList<label>>& cells
)
{
    Places places{labelList(nParticles, -1), labelList(nParticles, -1), labelListList(cells.size())};
    forAll(mayHold, rank)
    {
        DynamicList<label> accepted(mayHold[rank].size());
        forAll(mayHold[rank], k)
        {
            const label i = mayHold[rank][k];
            if (places.owners[i] < 0 && cells[rank][k] >= 0)
            {
                places.owners[i] = rank;
                places.cells[i] = cells[rank][k];
                accepted.append(i);
            }
        }
        places.sent[rank].transfer(accepted);
    }
    return places;
}


void Foam::particleExchange::locate(const UList<point>& positions)
{
    nEngine_ = positions.size();

    // Every rank whose box holds a particle is asked; the first that has a cell for it gets it.
    const List<DynamicList<label>> mayHold(candidates(positions));
    Places places(firstClaims(nEngine_, mayHold, askForCells(positions, mayHold)));

    if (returnReduce(places.owners.found(-1), orOp<bool>()))
    {
        reportOutside(positions, places.owners);
    }

    map_.reset(new mapDistributeBase(makeMap(std::move(places.sent))));
    cells_ = toGas(places.cells);
}
