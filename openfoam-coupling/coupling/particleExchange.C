// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleExchange.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "polyMesh.H"

#include <utility>
#include <vector>

using namespace cohesion;

namespace
{

template<class Lists>
Foam::labelList sizesOf(const Lists& lists)
{
    Foam::labelList sizes(lists.size());
    forAll(lists, rank)
    {
        sizes[rank] = lists[rank].size();
    }
    return sizes;
}

} // End anonymous namespace


Foam::particleExchange::particleExchange
(
    const polyMesh& mesh,
    const void_fraction::Kernel& kernel
)
:
    mesh_(mesh),
    meshCells_(mesh, kernel),
    images_(meshCells::images(mesh)),
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


template<class Item>
Foam::List<Foam::DynamicList<Item>> Foam::particleExchange::swap
(
    const List<DynamicList<Item>>& sent,
    const labelUList& sizes
)
{
    List<DynamicList<Item>> received(sent.size());
    Pstream::exchange<DynamicList<Item>, Item>(sent, sizes, received);
    traffic_.count(sent, sizeof(Item));
    return received;
}


void Foam::particleExchange::setMap
(
    labelListList&& sent,
    const List<DynamicList<Verdict>>& verdicts
)
{
    labelListList constructed(sent.size());
    label start = 0;
    forAll(verdicts, rank)
    {
        label n = 0;
        for (const Verdict verdict : verdicts[rank])
        {
            n += verdict != noPart;
        }
        constructed[rank] = identity(n, start);
        start += n;
    }
    map_.reset(new mapDistributeBase(start, std::move(sent), std::move(constructed)));
}


void Foam::particleExchange::reportOutside
(
    const UList<point>& positions,
    const scalarList& sums
) const
{
    label nOutside = 0;
    point example = point::max;
    forAll(sums, i)
    {
        if (sums[i] == 0)
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


Foam::particleExchange::Candidates Foam::particleExchange::candidates
(
    const UList<point>& positions,
    const UList<scalar>& radii
) const
{
    Candidates found(rankBounds_.size());
    if (positions.empty())
    {
        return found;
    }

    // Most ranks are far from all of them.
    const vector furthest = vector::uniform(meshCells_.reach(max(radii)));
    const boundBox around(positions, false);
    std::vector<std::pair<vector, label>> near;
    for (const vector& shift : images_)
    {
        const boundBox image(around.min() + shift - furthest, around.max() + shift + furthest);
        forAll(rankBounds_, rank)
        {
            if (rankBounds_[rank].overlaps(image))
            {
                near.emplace_back(shift, rank);
            }
        }
    }

    forAll(positions, i)
    {
        const vector reach = vector::uniform(meshCells_.reach(radii[i]));
        for (const auto& [shift, rank] : near)
        {
            const point position = positions[i] + shift;
            const boundBox& bounds = rankBounds_[rank];
            if (boundBox(bounds.min() - reach, bounds.max() + reach).contains(position))
            {
                found[rank].append(Candidate{i, position});
            }
        }
    }
    return found;
}


Foam::particleExchange::Answer Foam::particleExchange::answer
(
    const Question& question,
    Answered& mine
) const
{
    const point position(question[0], question[1], question[2]);
    const label holder = meshCells_.holding(position);
    mine.positions.append(position);
    mine.holders.append(holder);
    mine.starts.append(mine.shares.cells.size());

    Answer answer;
    answer[0] = holder >= 0;
    answer[1] =
        meshCells_.reachesOut()
      ? meshCells_.appendShares(position, question[3], holder, mine.shares)
      : answer[0];
    return answer;
}


Foam::List<Foam::DynamicList<Foam::particleExchange::Answer>> Foam::particleExchange::ask
(
    const Candidates& mayHold,
    const UList<scalar>& radii,
    List<Answered>& mine
)
{
    List<DynamicList<Question>> questions(mayHold.size());
    forAll(mayHold, rank)
    {
        for (const Candidate& candidate : mayHold[rank])
        {
            Question question;
            for (direction d = 0; d < 3; ++d)
            {
                question[d] = candidate.position[d];
            }
            question[3] = radii[candidate.particle];
            questions[rank].append(question);
        }
    }
    const labelList sizes(sizesOf(questions));
    const List<DynamicList<Question>> asked(swap(questions, neighbourSizes_(sizes)));
    traffic_.count(sizes);

    List<DynamicList<Answer>> answers(mayHold.size());
    forAll(asked, rank)
    {
        for (const Question& question : asked[rank])
        {
            answers[rank].append(answer(question, mine[rank]));
        }
        mine[rank].starts.append(mine[rank].shares.cells.size());
    }
    return swap(answers, sizes);
}


Foam::particleExchange::Parts Foam::particleExchange::accept
(
    const label nParticles,
    const Candidates& mayHold,
    const List<DynamicList<Answer>>& answers
) const
{
    Parts parts
    {
        List<DynamicList<Verdict>>(mayHold.size()),
        labelListList(mayHold.size()),
        scalarList(nParticles, Zero)
    };
    std::vector<bool> centred(std::size_t(nParticles), false);
    forAll(mayHold, rank)
    {
        DynamicList<label> particles(mayHold[rank].size());
        forAll(mayHold[rank], k)
        {
            const label i = mayHold[rank][k].particle;
            const bool centre = answers[rank][k][0] > 0 && !centred[i];
            const bool some = meshCells_.reachesOut() && answers[rank][k][1] > 0;
            parts.verdicts[rank].append(centre ? centralPart : some ? part : noPart);
            if (centre || some)
            {
                particles.append(i);
                parts.sums[i] += answers[rank][k][1];
            }
            centred[i] = centred[i] || centre;
        }
        parts.particles[rank].transfer(particles);
    }
    for (label i = 0; i < nParticles; ++i)
    {
        if (!centred[i])
        {
            parts.sums[i] = 0;
        }
    }
    return parts;
}


void Foam::particleExchange::setParts
(
    const List<Answered>& mine,
    const List<DynamicList<Verdict>>& verdicts
)
{
    DynamicList<label> cells;
    DynamicList<point> positions;
    DynamicList<label> starts;
    DynamicList<label> weightedCells;
    DynamicList<scalar> weights;
    forAll(verdicts, rank)
    {
        const Answered& answered = mine[rank];
        forAll(verdicts[rank], k)
        {
            const Verdict verdict = verdicts[rank][k];
            if (verdict == noPart)
            {
                continue;
            }
            cells.append(verdict == centralPart ? answered.holders[k] : -1);
            positions.append(answered.positions[k]);
            if (meshCells_.reachesOut())
            {
                starts.append(weights.size());
                for (label j = answered.starts[k]; j < answered.starts[k + 1]; ++j)
                {
                    weightedCells.append(answered.shares.cells[j]);
                    weights.append(answered.shares.shares[j]);
                }
            }
        }
    }
    if (meshCells_.reachesOut())
    {
        starts.append(weights.size());
    }
    cells_.transfer(cells);
    positions_.transfer(positions);
    starts_.transfer(starts);
    weightedCells_.transfer(weightedCells);
    weights_.transfer(weights);
}


void Foam::particleExchange::setWeights(const scalarList& sums)
{
    if (!meshCells_.reachesOut())
    {
        return;
    }
    const scalarList ofParts(toParts(sums));
    forAll(ofParts, k)
    {
        for (label j = starts_[k]; j < starts_[k + 1]; ++j)
        {
            weights_[j] /= ofParts[k];
        }
    }
}


void Foam::particleExchange::locate(const UList<point>& positions, const UList<scalar>& radii)
{
    nEngine_ = positions.size();

    // Every rank that may have a share is asked.
    const Candidates mayHold(candidates(positions, radii));
    List<Answered> mine(mayHold.size());
    const List<DynamicList<Answer>> answers(ask(mayHold, radii, mine));
    Parts parts(accept(nEngine_, mayHold, answers));

    if (returnReduce(parts.sums.found(0), orOp<bool>()))
    {
        reportOutside(positions, parts.sums);
    }

    labelList asked(mine.size());
    forAll(mine, rank)
    {
        asked[rank] = mine[rank].holders.size();
    }
    const List<DynamicList<Verdict>> verdicts(swap(parts.verdicts, asked));
    setParts(mine, verdicts);
    setMap(std::move(parts.particles), verdicts);
    setWeights(parts.sums);
}
