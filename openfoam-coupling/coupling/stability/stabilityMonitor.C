// SPDX-License-Identifier: GPL-3.0-or-later
#include "stabilityMonitor.H"

#include "Pstream.H"

#include "coupling/fromFirstRank.H"

#include "dragValidity.H"
#include "exchangeError.H"
#include "fixedBedGrowth.H"
#include "pressureWaves.H"

#include <algorithm>

namespace
{

template<class... Criteria>
std::vector<std::unique_ptr<Foam::particleCriterion>> makeEach(const Foam::exchangeModel& model)
{
    std::vector<std::unique_ptr<Foam::particleCriterion>> all;
    (all.push_back(std::make_unique<Criteria>(model)), ...);
    return all;
}


//- The criteria of particles, in the order in which they warn
std::vector<std::unique_ptr<Foam::particleCriterion>> makeCriteria(const Foam::exchangeModel& model)
{
    return makeEach
    <
        Foam::fixedBedGrowth,
        Foam::pressureWaves,
        Foam::exchangeError,
        Foam::dragValidity
    >(model);
}

} // End anonymous namespace


Foam::stabilityMonitor::stabilityMonitor
(
    const fvMesh& mesh,
    const gasDensity& density,
    const exchangeModel& model,
    const scalar addedMass
)
:
    mesh_(mesh),
    ofParticles_(makeCriteria(model)),
    viscousWaves_(mesh, density, model.form.shares_pressure, addedMass)
{}


void Foam::stabilityMonitor::startStep(const label engineSteps)
{
    engineSteps_ = engineSteps;
    dt_ = mesh_.time().deltaTValue();
    adding_.clear();
    for (const auto& criterion : ofParticles_)
    {
        criterion->startStep(engineSteps);
        if (criterion->addsParticles())
        {
            adding_.push_back(criterion.get());
        }
    }
}


void Foam::stabilityMonitor::endStep()
{
    const auto isDue = [](const auto& criterion) { return criterion->due(); };
    if (std::any_of(ofParticles_.begin(), ofParticles_.end(), isDue))
    {
        warn();
    }
    for (const auto& criterion : ofParticles_)
    {
        criterion->clear();
    }
}


void Foam::stabilityMonitor::warn()
{
    scalarList largest(label(ofParticles_.size()));
    forAll(largest, k)
    {
        largest[k] = ofParticles_[k]->worst();
    }
    // All criteria at once: ranks wait for each other a single time.
    Pstream::listCombineGather(largest, maxEqOp<scalar>());
    fromFirstRank(largest);
    forAll(largest, k)
    {
        particleCriterion& criterion = *ofParticles_[k];
        if (criterion.due() && largest[k] > criterion.limit())
        {
            criterion.warn(largest[k], dt_);
        }
    }
}


void Foam::stabilityMonitor::report() const
{
    for (const auto& criterion : ofParticles_)
    {
        criterion->report();
    }
}
