// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleDrag.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "messageStream.H"

#include "coupling/stability/ofOneRank.H"
#include "coupling/input/selectRow.H"

#include "drag/exchange_error.h"
#include "drag/pressure_waves.h"
#include "sphere.h"

#include <sstream>

using namespace cohesion;

namespace
{

drag::DragLaw readLaw(const Foam::dictionary& dict)
{
    const drag::Closure& closure = Foam::selectRow(dict, "drag", drag::closures);
    std::optional<double> exponent;
    if (dict.found("dragExponent"))
    {
        exponent = dict.get<Foam::scalar>("dragExponent");
    }
    try
    {
        return drag::DragLaw
        (
            closure,
            dict.getOrDefault<Foam::scalar>("dragFactor", 1),
            exponent
        );
    }
    catch (const InvalidParameter& error)
    {
        FatalIOErrorInFunction(dict) << error.what() << Foam::exit(Foam::FatalIOError);
        throw;
    }
}

} // End anonymous namespace


Foam::particleDrag::particleDrag
(
    const dictionary& dict,
    const scalar mu,
    const bool feelPressure
)
:
    law_(readLaw(dict)),
    response_(selectRow(dict, "response", drag::responses, "held")),
    mu_(mu),
    feelPressure_(feelPressure)
{}


void Foam::particleDrag::countOutside(const scalar voidFraction, const scalar reynolds)
{
    ++outside_;
    ++step_.count;
    step_.lowestVoidFraction = min(step_.lowestVoidFraction, voidFraction);
    step_.highestVoidFraction = max(step_.highestVoidFraction, voidFraction);
    step_.highestReynolds = max(step_.highestReynolds, reynolds);
}


std::string Foam::particleDrag::validity() const
{
    const drag::Validity& validity = law_.closure().validity;
    std::ostringstream text;
    text<< "void fraction " << validity.lowest_void_fraction << " to "
        << validity.highest_void_fraction << " and Reynolds number up to "
        << validity.highest_reynolds;
    return text.str();
}


void Foam::particleDrag::lookAtStep
(
    const vector& place,
    const scalar voidFraction,
    const scalar coefficient,
    const scalar radius,
    const scalar mass,
    const scalar rho,
    const scalar dt
)
{
    if (warnedOfStep_ && !response_.free && warnedOfPressure_)
    {
        return;
    }
    const scalar step = drag::exchange_step(coefficient, mass, dt);
    const scalar loading = drag::mass_loading(voidFraction, mass, sphere_volume(radius), rho);
    const scalar error = drag::exchange_error(step, loading, response_.free);
    // Shorter steps are off by their first order.
    if (step > 1 && error > exchangeError_)
    {
        exchangeError_ = error;
        longestStep_ = step;
    }
    if (response_.free)
    {
        growth_ = max(growth_, drag::held_growth(step, loading));
    }
    if (!warnedOfPressure_)
    {
        lookAtPressure(step, voidFraction, place);
    }
}


void Foam::particleDrag::startStep(const label engineSteps)
{
    if (!pressureLimits_ || pressureLimits_->engine_steps() != engineSteps)
    {
        pressureLimits_.emplace(engineSteps, response_.free, feelPressure_);
    }
}


void Foam::particleDrag::lookAtPressure
(
    const scalar step,
    const scalar voidFraction,
    const vector& place
)
{
    const scalar longest = pressureLimits_->longest(voidFraction);
    if (step <= longest)
    {
        return;
    }
    drag::PressureStep wave{step, voidFraction, pressureLimits_->engine_steps(), response_.free, feelPressure_};
    const scalar growth = drag::pressure_growth(wave);
    if (growth > drag::pressure_grows)
    {
        pressureStepShare_ = min(pressureStepShare_, longest/step);
        wave.felt = false;
        growInFormB_ = growInFormB_ || drag::pressure_waves_grow(wave);
        if (growth > fastest_.growth)
        {
            fastest_ = {growth, place, voidFraction, step};
        }
    }
}


void Foam::particleDrag::warnOfStep()
{
    // Implicit steps of the gas are off by some per cent where they are about as long as it takes to
    // follow the particles; this is about what does not get better with stiffer drag.
    constexpr scalar worthSaying = 0.05;
    const scalar mine = exchangeError_;
    reduce(exchangeError_, maxOp<scalar>());
    scalar step = mine == exchangeError_ ? longestStep_ : 0;
    reduce(step, maxOp<scalar>());
    if (exchangeError_ > worthSaying)
    {
        WarningInFunction
            << "the gas step is " << step << " times the time m/b in which particles follow the gas, and"
            << " they have so little mass there that the gas should give way: their velocity may be off"
            << " by " << 100*exchangeError_ << " % of the slip, and the gas's, until about as many steps"
            << " later. Nothing is wrong once they move steadily. A smaller deltaT cures it, or, where they"
            << " do not touch each other, 'response free;' in constant/couplingProperties; this is said once"
            << endl;
        warnedOfStep_ = true;
    }
    exchangeError_ = 0;
}


void Foam::particleDrag::warnOfGrowth()
{
    reduce(growth_, maxOp<scalar>());
    if (growth_ > 1)
    {
        WarningInFunction
            << "with response free the gas is solved with particles that give way to it; between particles"
            << " that are held, as in a packing, its velocity would grow by a factor of " << growth_
            << " in a step. Where they touch each other use 'response held;' in"
            << " constant/couplingProperties, or a smaller deltaT; this is said once" << endl;
        warnedOfGrowth_ = true;
    }
    growth_ = 0;
}


void Foam::particleDrag::warnOfPressure(const scalar dt)
{
    const scalar growth = returnReduce(fastest_.growth, maxOp<scalar>());
    if (growth > 0)
    {
        const bool mine = hasLargest(fastest_.growth, growth);
        ofOneRank(mine, fastest_.place);
        ofOneRank(mine, fastest_.voidFraction);
        ofOneRank(mine, fastest_.step);
        reduce(pressureStepShare_, minOp<scalar>());
        const bool formB = !returnReduce(growInFormB_, orOp<bool>());
        WarningInFunction
            << "where particles are so dense and follow the gas so fast, waves of particles that nothing"
            << " holds would swing against the gas that they displace and grow by a factor of "
            << growth << " in a gas step, fastest at the particle at " << fastest_.place
            << ": void fraction " << fastest_.voidFraction << ", x = b deltaT/m = " << fastest_.step
            << ". Particles that touch others hold them back. A deltaT below " << pressureStepShare_*dt
            << " s cures it, as void fractions and drag are now and with as many particle steps in it"
            << (formB ? ", or 'form B;' in constant/couplingProperties" : "") << "; this is said once" << endl;
        warnedOfPressure_ = true;
    }
    fastest_ = {};
    pressureStepShare_ = 1;
    growInFormB_ = false;
}


void Foam::particleDrag::endStep(const label n, const scalar dt)
{
    evaluations_ += n;
    if (response_.free && !warnedOfGrowth_)
    {
        warnOfGrowth();
    }
    if (!warnedOfPressure_)
    {
        warnOfPressure(dt);
    }
    if (!warnedOfStep_)
    {
        warnOfStep();
    }
    if (warned_)
    {
        return;
    }

    label count = step_.count;
    reduce(count, sumOp<label>());
    if (count)
    {
        reduce(step_.lowestVoidFraction, minOp<scalar>());
        reduce(step_.highestVoidFraction, maxOp<scalar>());
        reduce(step_.highestReynolds, maxOp<scalar>());
        label all = n;
        reduce(all, sumOp<label>());
        WarningInFunction
            << "drag " << law_.closure().name.data() << " was fitted for " << validity().c_str()
            << "; " << count << " of " << all << " particles are outside, at void fractions from "
            << step_.lowestVoidFraction << " to " << step_.highestVoidFraction
            << " and Reynolds numbers up to " << step_.highestReynolds
            << ". The formula is used as it is. This is said once; the end of the log has the count"
            << endl;
        warned_ = true;
    }
}


void Foam::particleDrag::report() const
{
    scalar evaluations = evaluations_;
    scalar outside = outside_;
    reduce(evaluations, sumOp<scalar>());
    reduce(outside, sumOp<scalar>());
    Info<< "Drag " << law_.closure().name.data() << ", fitted for " << validity().c_str()
        << nl << "    evaluations  " << evaluations << nl
        << "    outside      " << outside << ", " << 100*outside/max(evaluations, scalar(1))
        << " %" << endl;
}
