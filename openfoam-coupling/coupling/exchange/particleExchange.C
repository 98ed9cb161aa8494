// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleExchange.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "polyMesh.H"

#include "coupling/fromFirstRank.H"

#include <algorithm>
#include <vector>

using namespace cohesion;


Foam::particleExchange::particleExchange
(
    const polyMesh& mesh,
    const void_fraction::Kernel& kernel
)
:
    mesh_(mesh),
    meshCells_(mesh, kernel),
    images_(meshCells::images(mesh)),
    rankBounds_(Pstream::nProcs())
{
    // A particle on the outermost face must not fall between two boxes by round-off.
    boundBox bounds(mesh.points(), false);
    bounds.inflate(1e-9);
    rankBounds_[Pstream::myProcNo()] = bounds;
    Pstream::gatherList(rankBounds_);
    fromFirstRank(rankBounds_);
}


void Foam::particleExchange::requireInside
(
    const UList<point>& positions,
    const UList<int>& ids,
    const scalarList& sums
) const
{
    if (!returnReduce(sums.found(0), orOp<bool>()))
    {
        return;
    }
    label nOutside = 0;
    label lowest = labelMax;
    point example = point::max;
    forAll(sums, i)
    {
        if (sums[i] == 0)
        {
            ++nOutside;
            if (ids[i] < lowest)
            {
                lowest = ids[i];
                example = positions[i];
            }
        }
    }
    const label mine = lowest;
    reduce(nOutside, sumOp<label>());
    reduce(lowest, minOp<label>());
    example = mine == lowest ? example : point::max;
    reduce(example, minOp<point>());

    FatalErrorInFunction
        << nOutside << (nOutside > 1 ? " particles are" : " particle is") << " outside the mesh " << mesh_.bounds()
        << (nOutside > 1 ? "; the one of the lowest number is " : "; it is ") << "particle " << lowest << " at "
        << example << nl
        << "    Make the mesh as large as the box of the particles, its sides of type cyclic where that is periodic,"
        << " or give the particle script walls that keep them inside"
        << exit(FatalError);
}


std::vector<Foam::particleExchange::Candidate> Foam::particleExchange::candidates
(
    const UList<point>& positions,
    const UList<scalar>& radii
) const
{
    std::vector<Candidate> found;
    if (positions.empty())
    {
        return found;
    }
    const vector furthest = vector::uniform(meshCells_.reach(max(radii)));
    const boundBox around(positions, false);
    for (const vector& shift : images_)
    {
        const boundBox image(around.min() + shift - furthest, around.max() + shift + furthest);
        forAll(rankBounds_, rank)
        {
            if (rankBounds_[rank].overlaps(image))
            {
                found.push_back(Candidate{shift, rank});
            }
        }
    }
    return found;
}


template<class Visit>
void Foam::particleExchange::visitCandidates
(
    const std::vector<Candidate>& candidates,
    const UList<point>& positions,
    const UList<scalar>& radii,
    const Visit& visit
) const
{
    forAll(positions, i)
    {
        const vector reach = vector::uniform(meshCells_.reach(radii[i]));
        for (const auto& [shift, rank] : candidates)
        {
            const point position = positions[i] + shift;
            const boundBox& bounds = rankBounds_[rank];
            if (boundBox(bounds.min() - reach, bounds.max() + reach).contains(position))
            {
                visit(rank, i, position);
            }
        }
    }
}


Foam::particleExchange::PerRank<Foam::particleExchange::Query> Foam::particleExchange::queries
(
    const UList<point>& positions,
    const UList<scalar>& radii,
    labelListList& particles
) const
{
    const label nRanks = rankBounds_.size();
    // Most ranks are far from all of them.
    const auto reached = candidates(positions, radii);
    labelList sizes(nRanks, Zero);
    visitCandidates(reached, positions, radii, [&](const label rank, label, const point&) { ++sizes[rank]; });

    PerRank<Query> queries(nRanks);
    particles.setSize(nRanks);
    forAll(queries, rank)
    {
        queries[rank].setSize(sizes[rank]);
        particles[rank].setSize(sizes[rank]);
    }
    sizes = 0;
    const auto put = [&](const label rank, const label i, const point& position)
    {
        const label k = sizes[rank]++;
        particles[rank][k] = i;
        Query& query = queries[rank][k];
        for (direction d = 0; d < 3; ++d)
        {
            query[d] = position[d];
        }
        query[3] = radii[i];
    };
    visitCandidates(reached, positions, radii, put);
    return queries;
}


Foam::particleExchange::Reply Foam::particleExchange::reply(const Query& query, const label k)
{
    const point position(query[0], query[1], query[2]);
    const label centreCell = meshCells_.findCell(position);
    cells_[k] = centreCell;

    Reply reply;
    reply[0] = centreCell >= 0;
    reply[1] = reply[0];
    if (meshCells_.spansCells())
    {
        starts_[k] = weights_.cells.size();
        reply[1] = meshCells_.appendShares(position, query[3], centreCell, weights_);
    }
    return reply;
}


Foam::particleExchange::PerRank<Foam::particleExchange::Reply> Foam::particleExchange::replies
(
    const PerRank<Query>& queries
)
{
    PerRank<Reply> replies(queries.size());
    const label all = sum(sizesOf(queries));
    cells_.setSize(all);
    starts_.setSize(meshCells_.spansCells() ? all + 1 : 0);
    label k = 0;
    forAll(queries, rank)
    {
        replies[rank].setSize(queries[rank].size());
        forAll(replies[rank], j)
        {
            replies[rank][j] = reply(queries[rank][j], k++);
        }
    }
    if (meshCells_.spansCells())
    {
        starts_[all] = weights_.cells.size();
    }
    return replies;
}


Foam::particleExchange::PerRank<Foam::particleExchange::Part> Foam::particleExchange::assign
(
    const PerRank<Reply>& replies,
    labelListList& particles,
    scalarList& sums
) const
{
    PerRank<Part> parts(replies.size());
    std::vector<bool> centred(std::size_t(sums.size()), false);
    forAll(replies, rank)
    {
        parts[rank].setSize(replies[rank].size());
        label nParts = 0;
        forAll(replies[rank], k)
        {
            const label i = particles[rank][k];
            const bool centre = replies[rank][k][0] > 0 && !centred[i];
            const bool some = meshCells_.spansCells() && replies[rank][k][1] > 0;
            parts[rank][k] = centre ? central : some ? outer : none;
            if (centre || some)
            {
                particles[rank][nParts++] = i;
                sums[i] += replies[rank][k][1];
            }
            centred[i] = centred[i] || centre;
        }
        particles[rank].setSize(nParts);
    }
    forAll(sums, i)
    {
        if (!centred[i])
        {
            sums[i] = 0;
        }
    }
    return parts;
}


Foam::labelList Foam::particleExchange::setParts
(
    const PerRank<Query>& queries,
    const PerRank<Part>& parts
)
{
    labelList starts(parts.size() + 1, Zero);
    forAll(parts, rank)
    {
        const auto isPart = [](const Part part) { return part != none; };
        starts[rank + 1] =
            starts[rank] + std::count_if(parts[rank].begin(), parts[rank].end(), isPart);
    }
    positions_.setSize(starts.last());
    label n = 0;
    label query = 0;
    forAll(parts, rank)
    {
        forAll(parts[rank], k)
        {
            const Part part = parts[rank][k];
            if (part != none)
            {
                cells_[n] = part == central ? cells_[query] : -1;
                const Query& of = queries[rank][k];
                positions_[n] = point(of[0], of[1], of[2]);
                if (meshCells_.spansCells())
                {
                    starts_[n] = starts_[query];
                }
                ++n;
            }
            ++query;
        }
    }
    cells_.setSize(n);
    if (meshCells_.spansCells())
    {
        // What is no part has no weights: with some it would be one.
        starts_[n] = starts_[query];
        starts_.setSize(n + 1);
    }
    return starts;
}


void Foam::particleExchange::setWeights(const scalarList& sums)
{
    if (!meshCells_.spansCells())
    {
        return;
    }
    const auto divide = [&](const label k, const scalar sum)
    {
        for (label j = starts_[k]; j < starts_[k + 1]; ++j)
        {
            weights_.weights[j] /= sum;
        }
    };
    visitParts(sums, divide);
}


void Foam::particleExchange::clear()
{
    map_.clear();
    cells_.clear();
    positions_.clear();
    starts_.clear();
    // The storage of the weights stays: how much they will take is not known.
    weights_.cells.clear();
    weights_.weights.clear();
}


void Foam::particleExchange::locate
(
    const UList<point>& positions,
    const UList<scalar>& radii,
    const UList<int>& ids
)
{
    clear();

    // Every rank that may have a share is queried.
    labelListList particles;
    PerRank<Query> sent(queries(positions, radii, particles));
    const labelList sizes(sizesOf(sent));
    const labelList received(neighbourSizes_(sizes));
    const PerRank<Query> queried(exchangeLists(std::move(sent), received));

    scalarList sums(positions.size(), Zero);
    PerRank<Part> parts(assign(exchangeLists(replies(queried), sizes), particles, sums));
    requireInside(positions, ids, sums);
    parts = exchangeLists(std::move(parts), received);
    map_.set(positions.size(), std::move(particles), setParts(queried, parts));
    setWeights(sums);
}
