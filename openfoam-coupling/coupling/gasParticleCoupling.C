// SPDX-License-Identifier: GPL-3.0-or-later
// One gas step of the coupling, and its output.
#include "gasParticleCoupling.H"

#include "clockTime.H"

#include "coupling/drag/meanGasForce.H"
#include "coupling/exchange/exchangeTraffic.H"
#include "coupling/particles/engineView.H"
#include "coupling/particles/writeParticleCloud.H"
#include "coupling/restart/completeState.H"

#include <optional>

using namespace cohesion;

namespace
{

//- Lets the engine work. Its errors become FatalError; those of OpenFOAM are std::exception, too, and hold their text
//  elsewhere.
template<class Task>
void engineWorks(const Task& task)
{
    try
    {
        task();
    }
    catch (const Foam::error&)
    {
        throw;
    }
    catch (const std::exception& error)
    {
        FatalErrorInFunction << error.what() << Foam::exit(Foam::FatalError);
    }
}

} // End anonymous namespace


void Foam::gasParticleCoupling::locateParticles()
{
    const auto particles = engine_->particles();
    averaging_.exchange().locate
    (
        (*places_)(engineView(particles.position, particles.count)),
        engineView(particles.radius, particles.count),
        engineView(particles.id, particles.count)
    );
}


void Foam::gasParticleCoupling::setVoidFraction()
{
    const auto particles = engine_->particles();
    voidFraction_.set(engineView(particles.radius, particles.count), averaging_);
}


Foam::scalar Foam::gasParticleCoupling::particleCourantNumber() const
{
    const auto particles = engine_->particles();
    const particleExchange& exchange = averaging_.exchange();
    scalar largest = 0;
    const auto compare = [&](const label k, const vector& velocity)
    {
        const label celli = exchange.cells()[k];
        if (celli >= 0)
        {
            largest = max(largest, mag(velocity)/std::cbrt(mesh_.V()[celli]));
        }
    };
    exchange.visitParts(engineView(particles.velocity, particles.count), compare);
    return returnReduce(largest, maxOp<scalar>())*mesh_.time().deltaTValue();
}


void Foam::gasParticleCoupling::adjustStep(Time& time, const scalar courant)
{
    exchangeTraffic::ofRank().startStep();
    if (step_->adjustable())
    {
        locateParticles();
        step_->adjust(time, max(courant, particleCourantNumber()));
    }
    else
    {
        monitor_.checkCourant(courant);
    }
}


void Foam::gasParticleCoupling::depositParticles
(
    const volVectorField& U,
    const volVectorField& gradPOverRho
)
{
    const clockTime timer;
    step_->requireSame(engine_->time_step());
    // Where the step is adjusted they have been located.
    if (!step_->adjustable())
    {
        locateParticles();
    }
    setVoidFraction();
    inlets_.check(voidFraction(), U);
    inletVelocities_.check(voidFraction(), U);
    setCoefficients(U);
    setSources(gradPOverRho);
    seconds_.exchange += timer.elapsedTime();
}


void Foam::gasParticleCoupling::advanceParticles
(
    const volVectorField& U,
    const volVectorField& gradP
)
{
    clockTime timer;
    const vectorField gasVelocity(averaging_.gather(U.primitiveField()) + gasAt_.offset());
    const vector deferredBefore = sum(deferredImpulse());
    setGasOnParticles(gasVelocity, pressureOnParticles(gradP), transmittedGradient(gradP));
    hasLastGradient_ = true;
    if (liquid_.active())
    {
        setLiquidOnParticles(U);
    }
    turnover_.start(*engine_, mesh_.time().deltaTValue());
    seconds_.exchange += timer.timeIncrement();

    runEngine();
    seconds_.particles += timer.timeIncrement();

    turnover_.end(*engine_);
    reportBalance(U, gradP, deferredBefore);
    seconds_.exchange += timer.timeIncrement();
}


void Foam::gasParticleCoupling::runEngine()
{
    const Time& time = mesh_.time();
    const bool write = time.writeTime();
    const fileName state = write ? completeState::engineFile(time) : fileName();
    gasForce_.clear();
    std::optional<meanGasForce> force;
    if (write)
    {
        force.emplace(*engine_);
    }
    engineWorks([&]() { engine_->advance(step_->subSteps(), state); });
    if (write)
    {
        gasForce_ = force->over(time.deltaTValue());
    }
}


bool Foam::gasParticleCoupling::writeParticles()
{
    locateParticles();
    const particleExchange& exchange = averaging_.exchange();
    const auto particles = engine_->particles();
    const label n = particles.count;

    DynamicList<label> centred(exchange.cells().size());
    forAll(exchange.cells(), k)
    {
        if (exchange.cells()[k] >= 0)
        {
            centred.append(k);
        }
    }
    const auto here = [&](const auto& engineField)
    {
        using Type = typename std::decay_t<decltype(engineField)>::value_type;
        return List<Type>(exchange.toParts<Type>(engineField), centred);
    };
    return writeParticleCloud
    (
        mesh_,
        {
            labelList(exchange.cells(), centred),
            List<point>(exchange.positions(), centred),
            here(engineView(particles.velocity, n)),
            here(engineView(particles.radius, n)),
            here(engineView(particles.id, n)),
            here(engineView(particles.type, n)),
            here(gasForce_.size() == n ? gasForce_ : vectorField(n, Zero))
        }
    );
}


void Foam::gasParticleCoupling::writeState(const bool written)
{
    const bool particlesWritten = writeParticles();
    completeState::mark(mesh_.time(), engine_->steps_done(), written && particlesWritten);
    kept_.drop();
}


void Foam::gasParticleCoupling::keepState(const coupledTime& time)
{
    if (time.timeIndex() == time.startTimeIndex() || !kept_.due())
    {
        return;
    }
    const auto write = [&]()
    {
        const bool written = completeState::writeFields(time);
        const bool particlesWritten = writeParticles();
        const fileName state(completeState::engineFile(time));
        engineWorks([&]() { engine_->keep(state); });
        completeState::mark(time, engine_->steps_done(), written && particlesWritten, time.writtenFrom());
    };
    kept_.keep(write);
}
