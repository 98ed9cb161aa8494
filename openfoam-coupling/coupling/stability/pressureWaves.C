// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressureWaves.H"

#include "rankOfLargest.H"

using namespace cohesion;


Foam::pressureWaves::pressureWaves(const bool free, const bool felt)
:
    stepCriterion(true, drag::pressure_grows),
    free_(free),
    felt_(felt)
{}


void Foam::pressureWaves::setEngineSteps(const label engineSteps)
{
    if (!limits_ || limits_->engine_steps() != engineSteps)
    {
        limits_.emplace(engineSteps, free_, felt_);
    }
}


void Foam::pressureWaves::add(const scalar step, const scalar voidFraction, const vector& position)
{
    const scalar longest = limits_->longest(voidFraction);
    if (step <= longest)
    {
        return;
    }
    drag::PressureStep wave{step, voidFraction, limits_->engine_steps(), free_, felt_};
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
        position_ = position;
        voidFraction_ = voidFraction;
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
        << (formB ? ", or 'form B;' in constant/couplingProperties" : "") << "; this is said once" << endl;
}


void Foam::pressureWaves::clear()
{
    stepCriterion::clear();
    stableShare_ = 1;
    growInFormB_ = false;
}
