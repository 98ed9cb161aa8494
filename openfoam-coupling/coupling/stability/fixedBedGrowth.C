// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixedBedGrowth.H"

#include "drag/exchange_error.h"

using namespace cohesion;


Foam::fixedBedGrowth::fixedBedGrowth(const exchangeModel& model)
:
    particleCriterion(model.response.free, drag::fixed_bed_growth_limit)
{}


void Foam::fixedBedGrowth::add(const particleInGas& particle)
{
    worst_ = max(worst_, drag::fixed_bed_growth(particle.exchangeStep, particle.loading));
}


void Foam::fixedBedGrowth::warn(const scalar largest, const scalar)
{
    WarningOnceInFunction(warning_)
        << "with response free the gas is solved with particles that give way to it; in a fixed bed its"
        << " velocity would grow by a factor of " << largest << " in a step. Where they touch each"
        << " other use 'response held;' in constant/couplingProperties, or a smaller deltaT; printed once" << endl;
}
