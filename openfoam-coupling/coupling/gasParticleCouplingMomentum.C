// SPDX-License-Identifier: GPL-3.0-or-later
// The momentum that passes between particles and gas in a step: coefficients, sources of the gas, what particles get.
#include "gasParticleCoupling.H"

#include "clockTime.H"

#include "drag/exchange_error.h"
#include "drag/momentum_exchange.h"
#include "liquid/liquid_exchange.h"
#include "sphere.h"

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


void Foam::gasParticleCoupling::setCoefficients(const volVectorField& U)
{
    const scalar dt = mesh_.time().deltaTValue();
    const auto particles = engine_->particles();
    const auto velocity = engineView(particles.velocity, particles.count);
    const auto position = engineView(particles.position, particles.count);
    gasAt_.set(voidFraction_, U, averaging_);
    // The density is that of the particle's cells, with either slip.
    scalarField rho(particles.count, rho_);
    if (density_.ideal())
    {
        rho *= averaging_.gather(density_.ratio().primitiveField());
    }

    const bool mixes = drag_.mixture().mixes;
    if (mixes)
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
    const bool transmits = hasLastGradient_ && !form_.gas_takes_all;
    coefficient_.setSize(particles.count);
    sourceCoefficient_.setSize(particles.count);
    transmittedVolume_.setSize(particles.count);
    forAll(coefficient_, i)
    {
        const scalar voidFraction = gasAt_.voidFraction()[i];
        const scalar slip = mag(gasAt_.velocity()[i] - velocity[i]);
        const scalar radius = particles.radius[i];
        const scalar mass = particles.mass[i];
        const particleDrag::DragConditions sphere{voidFraction, slip, radius, rho[i], mass};
        auto [b, reynolds] = mixes ? drag_(sphere, form_, sizesAt_.around(i)) : drag_(sphere, form_);
        if (bound_.on())
        {
            b *= bound_.factor(i, sphere);
        }
        if (filter_.active())
        {
            const scalar d = drag_.parcels().drag_diameter(2*radius);
            b *= filter_.factor(i, voidFraction, {d, mass/sphere_volume(radius)}, rho[i]);
        }
        coefficient_[i] = b;
        if (liquid_.active())
        {
            setLiquid(i, sphere, b);
        }
        const scalar added = liquid_.addedMass(rho[i], sphere_volume(radius));
        sourceCoefficient_[i] = liquid::source_coefficient(b, mass, added, dt, response_.free);
        transmittedVolume_[i] =
            transmits ? liquid::transmitted_volume(b, mass, added, sphere_volume(radius), dt) : 0;
        monitor_.add
        ({
            position[i],
            voidFraction,
            reynolds,
            drag::exchange_step(b, mass + added, dt),
            drag::mass_loading(voidFraction, mass, sphere_volume(radius), rho[i])
        });
    }
    monitor_.endStep();
    if (bound_.on())
    {
        bound_.endStep();
    }
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


void Foam::gasParticleCoupling::setSources(const volVectorField& gradP)
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
    const vectorField source(averaging_.spread(ofParticles));
    forAll(rate, celli)
    {
        const scalar perGasMass = 1/(volume(celli)*rho_);
        dragRate_.field()[celli] = rate[celli]*perGasMass;
        dragSource_.field()[celli] = source[celli]*perGasMass;
    }
    if (liquid_.active())
    {
        scalarField volumes(mesh_.V());
        volumes *= depthRatio_;
        liquid_.setCells(averaging_, volumes, rho_);
    }
    if (!form_.gas_takes_all)
    {
        setPressureSources(gradP);
    }
}


void Foam::gasParticleCoupling::setPressureSources(const volVectorField& gradP)
{
    const scalarField transmitted(averaging_.spread(transmittedVolume_));
    lastGradP_ = rho_*gradP.primitiveField();
    forAll(transmitted, celli)
    {
        transmittedFraction_[celli] = transmitted[celli]/volume(celli);
        for (direction d = 0; d < 3; ++d)
        {
            dragSource_.field()[celli][d] += drag::last_pressure_on_gas
            (
                transmittedFraction_[celli]/rho_,
                lastGradP_[celli][d],
                response_.free
            );
        }
    }
    transmittedFraction_.correctBoundaryConditions();
    pressureFraction_ = voidFraction_ + transmittedFraction_;
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
    if (monitor_.cellsMayGrow(ofLightest, voidFraction_, nu))
    {
        scalarField ofCells(averaging_.spread(volumePerDensity));
        forAll(ofCells, celli)
        {
            ofCells[celli] /= volume(celli);
        }
        monitor_.checkCells(ofCells, voidFraction_, nu);
    }
    seconds_.exchange += timer.elapsedTime();
}


Foam::vectorField Foam::gasParticleCoupling::transmittedGradient(const volVectorField& gradP)
{
    if (form_.gas_takes_all)
    {
        return vectorField(engine_->particles().count, Zero);
    }
    vectorField gradient(gradP.primitiveField());
    forAll(gradient, celli)
    {
        for (direction d = 0; d < 3; ++d)
        {
            gradient[celli][d] -= drag::last_pressure_on_gas(1, lastGradP_[celli][d], response_.free);
        }
    }
    return averaging_.gather(gradient);
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
    hasLastGradient_ = true;
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
