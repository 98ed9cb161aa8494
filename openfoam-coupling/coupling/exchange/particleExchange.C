// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleExchange.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "polyMesh.H"

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
    rankBounds_(Pstream::nProcs()),
    map_(traffic_)
{
    // A particle on the outermost face must not fall between two boxes by round-off.
    boundBox bounds(mesh.points(), false);
    bounds.inflate(1e-9);
    rankBounds_[Pstream::myProcNo()] = bounds;
    Pstream::gatherList(rankBounds_);
    Pstream::scatterList(rankBounds_);
}


void Foam::particleExchange::reportOutside
(
    const UList<point>& positions,
    const UList<int>& ids,
    const scalarList& sums
) const
{
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
        << "    Make the mesh as large as the box of the particles, or give the"
        << " particle script walls that keep them inside"
        << exit(FatalError);
    std::abort();
}


std::vector<Foam::particleExchange::Near> Foam::particleExchange::nearRanks
(
    const UList<point>& positions,
    const UList<scalar>& radii
) const
{
    std::vector<Near> near;
    if (positions.empty())
    {
        return near;
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
                near.push_back(Near{shift, rank});
            }
        }
    }
    return near;
}


template<class Visit>
void Foam::particleExchange::visitCandidates
(
    const std::vector<Near>& near,
    const UList<point>& positions,
    const UList<scalar>& radii,
    const Visit& visit
) const
{
    forAll(positions, i)
    {
        const vector reach = vector::uniform(meshCells_.reach(radii[i]));
        for (const auto& [shift, rank] : near)
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


Foam::particleExchange::PerRank<Foam::particleExchange::Question> Foam::particleExchange::ask
(
    const UList<point>& positions,
    const UList<scalar>& radii,
    labelListList& particles
) const
{
    const label nRanks = rankBounds_.size();
    // Most ranks are far from all of them.
    const auto near = nearRanks(positions, radii);
    labelList sizes(nRanks, Zero);
    visitCandidates(near, positions, radii, [&](const label rank, label, const point&) { ++sizes[rank]; });

    PerRank<Question> questions(nRanks);
    particles.setSize(nRanks);
    forAll(questions, rank)
    {
        questions[rank].setSize(sizes[rank]);
        particles[rank].setSize(sizes[rank]);
    }
    sizes = 0;
    const auto put = [&](const label rank, const label i, const point& position)
    {
        const label k = sizes[rank]++;
        particles[rank][k] = i;
        Question& question = questions[rank][k];
        for (direction d = 0; d < 3; ++d)
        {
            question[d] = position[d];
        }
        question[3] = radii[i];
    };
    visitCandidates(near, positions, radii, put);
    return questions;
}


Foam::particleExchange::Answer Foam::particleExchange::answer(const Question& question, const label k)
{
    const point position(question[0], question[1], question[2]);
    const label holder = meshCells_.holding(position);
    cells_[k] = holder;

    Answer answer;
    answer[0] = holder >= 0;
    answer[1] = answer[0];
    if (meshCells_.reachesOut())
    {
        starts_[k] = weights_.cells.size();
        answer[1] = meshCells_.appendShares(position, question[3], holder, weights_);
    }
    return answer;
}


Foam::particleExchange::PerRank<Foam::particleExchange::Answer> Foam::particleExchange::answer
(
    const PerRank<Question>& questions
)
{
    PerRank<Answer> answers(questions.size());
    const label all = sum(sizesOf(questions));
    cells_.setSize(all);
    starts_.setSize(meshCells_.reachesOut() ? all + 1 : 0);
    label k = 0;
    forAll(questions, rank)
    {
        answers[rank].setSize(questions[rank].size());
        forAll(answers[rank], j)
        {
            answers[rank][j] = answer(questions[rank][j], k++);
        }
    }
    if (meshCells_.reachesOut())
    {
        starts_[all] = weights_.cells.size();
    }
    return answers;
}


Foam::particleExchange::PerRank<Foam::particleExchange::Verdict> Foam::particleExchange::accept
(
    const PerRank<Answer>& answers,
    labelListList& particles,
    scalarList& sums
) const
{
    PerRank<Verdict> verdicts(answers.size());
    std::vector<bool> centred(std::size_t(sums.size()), false);
    forAll(answers, rank)
    {
        verdicts[rank].setSize(answers[rank].size());
        label nParts = 0;
        forAll(answers[rank], k)
        {
            const label i = particles[rank][k];
            const bool centre = answers[rank][k][0] > 0 && !centred[i];
            const bool some = meshCells_.reachesOut() && answers[rank][k][1] > 0;
            verdicts[rank][k] = centre ? centralPart : some ? part : noPart;
            if (centre || some)
            {
                particles[rank][nParts++] = i;
                sums[i] += answers[rank][k][1];
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
    return verdicts;
}


Foam::labelList Foam::particleExchange::setParts
(
    const PerRank<Question>& questions,
    const PerRank<Verdict>& verdicts
)
{
    labelList starts(verdicts.size() + 1, Zero);
    forAll(verdicts, rank)
    {
        const auto isPart = [](const Verdict verdict) { return verdict != noPart; };
        starts[rank + 1] =
            starts[rank] + std::count_if(verdicts[rank].begin(), verdicts[rank].end(), isPart);
    }
    positions_.setSize(starts.last());
    label n = 0;
    label question = 0;
    forAll(verdicts, rank)
    {
        forAll(verdicts[rank], k)
        {
            const Verdict verdict = verdicts[rank][k];
            if (verdict != noPart)
            {
                cells_[n] = verdict == centralPart ? cells_[question] : -1;
                const Question& of = questions[rank][k];
                positions_[n] = point(of[0], of[1], of[2]);
                if (meshCells_.reachesOut())
                {
                    starts_[n] = starts_[question];
                }
                ++n;
            }
            ++question;
        }
    }
    cells_.setSize(n);
    if (meshCells_.reachesOut())
    {
        // What is no part has no weights: with some it would be one.
        starts_[n] = starts_[question];
        starts_.setSize(n + 1);
    }
    return starts;
}


void Foam::particleExchange::setWeights(const scalarList& sums)
{
    if (!meshCells_.reachesOut())
    {
        return;
    }
    const auto divide = [&](const label k, const scalar sum)
    {
        for (label j = starts_[k]; j < starts_[k + 1]; ++j)
        {
            weights_.shares[j] /= sum;
        }
    };
    visitParts(sums, divide);
}


void Foam::particleExchange::forget()
{
    map_.clear();
    cells_.clear();
    positions_.clear();
    starts_.clear();
    // Its storage stays: how much it will take is not known.
    weights_.cells.clear();
    weights_.shares.clear();
}


void Foam::particleExchange::locate
(
    const UList<point>& positions,
    const UList<scalar>& radii,
    const UList<int>& ids
)
{
    forget();

    // Every rank that may have a share is asked.
    labelListList particles;
    PerRank<Question> questions(ask(positions, radii, particles));
    const labelList sizes(sizesOf(questions));
    const labelList asked(neighbourSizes_(sizes));
    traffic_.count(sizes);
    questions = exchangeLists(std::move(questions), asked, traffic_);

    scalarList sums(positions.size(), Zero);
    PerRank<Verdict> verdicts
    (
        accept(exchangeLists(answer(questions), sizes, traffic_), particles, sums)
    );
    if (returnReduce(sums.found(0), orOp<bool>()))
    {
        reportOutside(positions, ids, sums);
    }
    verdicts = exchangeLists(std::move(verdicts), asked, traffic_);
    map_.set(positions.size(), std::move(particles), setParts(questions, verdicts));
    setWeights(sums);
}
