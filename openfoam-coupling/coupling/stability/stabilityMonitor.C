// SPDX-License-Identifier: GPL-3.0-or-later
#include "stabilityMonitor.H"

#include "Pstream.H"

#include "drag/exchange_error.h"
#include "sphere.h"

#include "coupling/fromFirstRank.H"

#include <algorithm>

using namespace cohesion;


Foam::stabilityMonitor::stabilityMonitor
(
    const fvMesh& mesh,
    const gasDensity& density,
    const drag::Closure& closure,
    const bool free,
    const bool felt,
    const scalar addedMass
)
:
    mesh_(mesh),
    validity_(closure),
    fixedBedGrowth_(free),
    pressureWaves_(free, felt),
    exchangeError_(free),
    viscousWaves_(mesh, density, felt, addedMass),
    ofParticles_{&fixedBedGrowth_, &pressureWaves_, &exchangeError_, &validity_}
{}


void Foam::stabilityMonitor::startStep(const label engineSteps)
{
    engineSteps_ = engineSteps;
    dt_ = mesh_.time().deltaTValue();
    judgesExchange_ = fixedBedGrowth_.due() || pressureWaves_.due() || exchangeError_.due();
    pressureWaves_.setEngineSteps(engineSteps);
}


void Foam::stabilityMonitor::addExchange(const particleInGas& particle)
{
    const scalar step = drag::exchange_step(particle.coefficient, particle.inertia, dt_);
    const scalar loading = drag::mass_loading
    (
        particle.voidFraction,
        particle.mass,
        sphere_volume(particle.radius),
        particle.rho
    );
    if (exchangeError_.due())
    {
        exchangeError_.add(step, loading);
    }
    if (fixedBedGrowth_.due())
    {
        fixedBedGrowth_.add(step, loading);
    }
    if (pressureWaves_.due())
    {
        pressureWaves_.add(step, particle.voidFraction, particle.position);
    }
}


void Foam::stabilityMonitor::endStep(const label n)
{
    validity_.addEvaluations(n);
    const auto isDue = [](const stepCriterion* criterion) { return criterion->due(); };
    if (std::any_of(ofParticles_.begin(), ofParticles_.end(), isDue))
    {
        warn();
    }
    for (stepCriterion* criterion : ofParticles_)
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
        stepCriterion& criterion = *ofParticles_[k];
        if (criterion.due() && largest[k] > criterion.limit())
        {
            criterion.warn(largest[k], dt_);
        }
    }
}
