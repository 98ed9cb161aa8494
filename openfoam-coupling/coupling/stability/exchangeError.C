// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchangeError.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include "drag/exchange_error.h"

using namespace cohesion;


Foam::exchangeError::exchangeError(const exchangeModel& model)
:
    particleCriterion(true, drag::exchange_error_limit),
    free_(model.response.free)
{}


void Foam::exchangeError::add(const particleInGas& particle)
{
    const scalar error = drag::late_exchange_error(particle.exchangeStep, particle.loading, free_);
    if (error > worst_)
    {
        worst_ = error;
        step_ = particle.exchangeStep;
    }
}


void Foam::exchangeError::warn(const scalar largest, const scalar)
{
    const scalar step = returnReduce(worst_ == largest ? step_ : 0, maxOp<scalar>());
    WarningOnceInFunction(warning_)
        << "the gas step is " << step << " times the time m/b in which particles follow the gas, and"
        << " they have so little mass there that the gas should give way: their velocity may be off"
        << " by " << 100*largest << " % of the slip, and the gas's, until about as many steps"
        << " later. Nothing is wrong once they move steadily. A smaller deltaT cures it, or, where they"
        << " do not touch each other, 'response free;' in constant/couplingProperties; printed once"
        << endl;
}
