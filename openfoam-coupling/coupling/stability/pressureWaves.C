// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressureWaves.H"

#include "rankOfLargest.H"

using namespace cohesion;


Foam::pressureWaves::pressureWaves(const exchangeModel& model)
:
    particleCriterion(true, drag::pressure_grows),
    free_(model.response.free),
    felt_(model.form.shares_pressure)
{}


void Foam::pressureWaves::startStep(const label engineSteps)
{
    if (!limits_ || limits_->engine_steps() != engineSteps)
    {
        limits_.emplace(engineSteps, free_, felt_);
    }
}


void Foam::pressureWaves::add(const particleInGas& particle)
{
    const scalar step = particle.exchangeStep;
    const scalar longest = limits_->longest(particle.voidFraction);
    if (step <= longest)
    {
        return;
    }
    drag::PressureStep wave{step, particle.voidFraction, limits_->engine_steps(), free_, felt_};
    const scalar growth = drag::pressure_growth(wave);
    if (!(growth > limit()))
    {
        return;
    }
    stableShare_ = min(stableShare_, longest/step);
    wave.felt = false;
    growInFormB_ = growInFormB_ || drag::pressure_waves_grow(wave);
    if (growth > worst_)
    {
        worst_ = growth;
        position_ = particle.position;
        voidFraction_ = particle.voidFraction;
        step_ = step;
    }
}


void Foam::pressureWaves::warn(const scalar largest, const scalar dt)
{
    const bool mine = isRankOfLargest(worst_, largest);
    const vector position = valueOfRank(mine, position_);
    const scalar voidFraction = valueOfRank(mine, voidFraction_);
    const scalar step = valueOfRank(mine, step_);
    const scalar share = returnReduce(stableShare_, minOp<scalar>());
    const bool formB = !returnReduce(growInFormB_, orOp<bool>());
    WarningOnceInFunction(warning_)
        << "where particles are so dense and follow the gas so fast, waves of particles that nothing"
        << " holds would swing against the gas that they displace and grow by a factor of "
        << largest << " in a gas step, fastest at the particle at " << position
        << ": void fraction " << voidFraction << ", x = b deltaT/m = " << step
        << ". Particles that touch others hold them back. A deltaT below " << share*dt
        << " s cures it, as void fractions and drag are now and with as many particle steps in it"
        << (formB ? ", or 'form B;' in constant/couplingProperties" : "") << "; printed once" << endl;
}


void Foam::pressureWaves::clear()
{
    particleCriterion::clear();
    stableShare_ = 1;
    growInFormB_ = false;
}
