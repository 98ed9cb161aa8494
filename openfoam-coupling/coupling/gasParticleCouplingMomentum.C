// SPDX-License-Identifier: GPL-3.0-or-later
// The momentum that passes between particles and gas in a step: coefficients, sources of the gas, what particles get.
#include "gasParticleCoupling.H"

#include "clockTime.H"

#include "drag/exchange_error.h"
#include "drag/momentum_exchange.h"
#include "liquid/liquid_exchange.h"
#include "sphere.h"

#include "coupling/exchange/cellVolume.H"
#include "coupling/particles/engineView.H"

using namespace cohesion;


Foam::List<Foam::vector> Foam::gasParticleCoupling::deferredImpulse() const
{
    const drag::GasOnParticle* gas = engine_->gas();
    List<vector> deferred(engine_->particles().count);
    forAll(deferred, i)
    {
        deferred[i] = dragImpulse(gas[i]);
    }
    return deferred;
}


Foam::scalarField Foam::gasParticleCoupling::rhoAtParticles()
{
    scalarField rho(engine_->particles().count, rho_);
    if (density_.ideal())
    {
        rho *= averaging_.gather(density_.ratio().primitiveField());
    }
    return rho;
}


void Foam::gasParticleCoupling::startExchange(const volVectorField& U)
{
    const auto particles = engine_->particles();
    gasAt_.set(voidFraction(), U, averaging_);
    if (drag_.mixture().mixes)
    {
        sizesAt_.set(engineView(particles.radius, particles.count), mesh_.V(), averaging_);
    }
    if (bound_.on())
    {
        bound_.look(*engine_);
    }
    if (filter_.active())
    {
        filter_.set(averaging_);
    }
    monitor_.startStep(step_->subSteps());
    if (liquid_.active())
    {
        liquid_.start(particles.count, U, averaging_);
    }
}


Foam::particleDrag::Drag Foam::gasParticleCoupling::dragOn
(
    const label i,
    const particleDrag::DragConditions& sphere
)
{
    particleDrag::Drag drag =
        drag_.mixture().mixes ? drag_(sphere, form_, sizesAt_.around(i)) : drag_(sphere, form_);
    if (bound_.on())
    {
        drag.coefficient *= bound_.factor(i, sphere);
    }
    if (filter_.active())
    {
        const scalar d = drag_.parcels().drag_diameter(2*sphere.radius);
        const powder::Grain grain{d, sphere.mass/sphere_volume(sphere.radius)};
        drag.coefficient *= filter_.factor(i, sphere.voidFraction, grain, sphere.rho);
    }
    return drag;
}


void Foam::gasParticleCoupling::setCoefficients(const volVectorField& U)
{
    startExchange(U);
    const scalarField rho(rhoAtParticles());
    const auto particles = engine_->particles();
    const auto velocity = engineView(particles.velocity, particles.count);
    const auto position = engineView(particles.position, particles.count);
    coefficient_.setSize(particles.count);
    sourceCoefficient_.setSize(particles.count);
    transmittedVolume_.setSize(particles.count);
    forAll(coefficient_, i)
    {
        const scalar slip = mag(gasAt_.velocity()[i] - velocity[i]);
        setCoefficient
        (
            i,
            {gasAt_.voidFraction()[i], slip, particles.radius[i], rho[i], particles.mass[i]},
            position[i]
        );
    }
    monitor_.endStep();
    if (bound_.on())
    {
        bound_.endStep();
    }
}


void Foam::gasParticleCoupling::setCoefficient
(
    const label i,
    const particleDrag::DragConditions& sphere,
    const vector& position
)
{
    const scalar dt = mesh_.time().deltaTValue();
    const scalar mass = sphere.mass;
    const scalar volume = sphere_volume(sphere.radius);
    const scalar added = liquid_.addedMass(sphere.rho, volume);
    const auto [b, reynolds] = dragOn(i, sphere);
    coefficient_[i] = b;
    if (liquid_.active())
    {
        setLiquid(i, sphere, b);
    }
    sourceCoefficient_[i] = liquid::source_coefficient(b, mass, added, dt, response_.free);
    const bool transmits = hasLastGradient_ && form_.shares_pressure;
    transmittedVolume_[i] = transmits ? liquid::transmitted_volume(b, mass, added, volume, dt) : 0;
    monitor_.add
    ({
        position,
        sphere.voidFraction,
        reynolds,
        drag::exchange_step(b, mass + added, dt),
        drag::mass_loading(sphere.voidFraction, mass, volume, sphere.rho)
    });
}


void Foam::gasParticleCoupling::setLiquid(const label i, const particleDrag::DragConditions& sphere, const scalar b)
{
    const scalar added = liquid_.addedMass(sphere.rho, sphere_volume(sphere.radius));
    const scalar inertia =
        liquid::source_inertia(b, sphere.mass, added, mesh_.time().deltaTValue(), response_.free);
    // Quadratic drag is given per slip, and follows it in each step of the particles.
    particleDrag::DragConditions unitSlip(sphere);
    unitSlip.slip = 1;
    const bool quadratic = liquid_.quadratic();
    liquid_.set(i, drag_, sphere, quadratic ? drag_(unitSlip, form_).coefficient : 0, inertia);
    if (quadratic)
    {
        // What is 0 is a particle that has been inserted since.
        coefficient_[i] = VSMALL;
    }
}


void Foam::gasParticleCoupling::setSources(const volVectorField& gradPOverRho)
{
    const scalar dt = mesh_.time().deltaTValue();
    const auto particles = engine_->particles();
    const auto velocity = engineView(particles.velocity, particles.count);

    // The slip is U of the particle's cells less the particle's velocity less the offset.
    const List<vector> deferred(deferredImpulse());
    const vectorField& offset = gasAt_.offset();
    vectorField ofParticles(particles.count);
    forAll(ofParticles, i)
    {
        for (direction d = 0; d < 3; ++d)
        {
            ofParticles[i][d] = drag::explicit_source
            (
                sourceCoefficient_[i],
                velocity[i][d],
                offset[i][d],
                deferred[i][d],
                dt
            );
        }
    }
    const scalarField rate(averaging_.spread(sourceCoefficient_));
    sources_.setDrag(rate, averaging_.spread(ofParticles));
    if (liquid_.active())
    {
        scalarField volumes(mesh_.V());
        volumes *= depthRatio_;
        liquid_.setCells(averaging_, volumes, rho_);
    }
    if (form_.shares_pressure)
    {
        sources_.addPressure(averaging_.spread(transmittedVolume_), gradPOverRho, voidFraction());
    }
}


void Foam::gasParticleCoupling::checkViscousWaves(const volScalarField& nu)
{
    const clockTime timer;
    const auto particles = engine_->particles();
    scalarField volumePerDensity(particles.count);
    scalar ofLightest = 0;
    forAll(volumePerDensity, i)
    {
        const scalar volume = sphere_volume(particles.radius[i]);
        const scalar perDensity = volume/particles.mass[i];
        volumePerDensity[i] = volume*perDensity;
        ofLightest = max(ofLightest, perDensity);
    }
    if (monitor_.cellsMayGrow(ofLightest, voidFraction(), nu))
    {
        scalarField ofCells(averaging_.spread(volumePerDensity));
        forAll(ofCells, celli)
        {
            ofCells[celli] /= cellVolume(mesh_, depthRatio_, celli);
        }
        monitor_.checkCells(ofCells, voidFraction(), nu);
    }
    seconds_.exchange += timer.elapsedTime();
}


Foam::vectorField Foam::gasParticleCoupling::transmittedGradient(const volVectorField& gradP)
{
    if (!form_.shares_pressure)
    {
        return vectorField(engine_->particles().count, Zero);
    }
    return averaging_.gather(sources_.chargedGradient(gradP));
}


Foam::vectorField Foam::gasParticleCoupling::pressureOnParticles(const volVectorField& gradP)
{
    if (form_.shares_pressure)
    {
        return averaging_.gather(gradP.primitiveField());
    }
    vectorField weight(gradP.size());
    forAll(weight, celli)
    {
        weight[celli] = rho_*density_.ratio(celli)*g_;
    }
    return averaging_.gather(weight);
}


void Foam::gasParticleCoupling::setGasOnParticles
(
    const UList<vector>& gasVelocity,
    const UList<vector>& pressureGradient,
    const UList<vector>& transmittedGradient
)
{
    const scalar dt = mesh_.time().deltaTValue();
    const auto velocity = engine_->particles().velocity;
    drag::GasOnParticle* gas = engine_->gas();
    forAll(coefficient_, i)
    {
        gas[i].drag_coefficient = coefficient_[i];
        for (direction d = 0; d < 3; ++d)
        {
            gas[i].drag_impulse[d] =
              - drag::source_impulse(sourceCoefficient_[i], gasVelocity[i][d], velocity[i][d], dt)
              - transmittedVolume_[i]*transmittedGradient[i][d]*dt;
            gas[i].velocity[d] = gasVelocity[i][d];
            gas[i].pressure_gradient[d] = pressureGradient[i][d];
        }
    }
}


void Foam::gasParticleCoupling::setLiquidOnParticles(const volVectorField& U)
{
    drag::GasOnParticle* gas = engine_->gas();
    const auto charge = [gas](const label i, const vector& impulse)
    {
        for (direction d = 0; d < 3; ++d)
        {
            gas[i].drag_impulse[d] -= impulse[d];
        }
    };
    liquid_.give(engine_->liquid(), U.primitiveField(), mesh_.time().deltaTValue(), averaging_, charge);
}
