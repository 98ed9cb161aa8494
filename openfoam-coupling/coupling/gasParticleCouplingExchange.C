// SPDX-License-Identifier: GPL-3.0-or-later
// What passes between particles and gas in a step: coefficients, sources of the gas, what particles get.
#include "gasParticleCoupling.H"

#include "drag/momentum_exchange.h"
#include "sphere.h"

#include "coupling/particles/engineView.H"

using namespace cohesion;


Foam::List<Foam::vector> Foam::gasParticleCoupling::pendingImpulse() const
{
    const drag::GasOnParticle* gas = engine_->gas();
    List<vector> pending(engine_->particles().count);
    forAll(pending, i)
    {
        const auto& impulse = gas[i].drag_impulse;
        pending[i] = vector(impulse[0], impulse[1], impulse[2]);
    }
    return pending;
}


void Foam::gasParticleCoupling::setCoefficients(const volVectorField& U)
{
    const scalar dt = mesh_.time().deltaTValue();
    const auto particles = engine_->particles();
    const auto velocity = engineView(particles.velocity, particles.count);
    const auto position = engineView(particles.position, particles.count);
    gasAt_.set(voidFraction_, U, averaging_);
    // That of the particle's cells, with either slip
    scalarField rho(particles.count, rho_);
    if (density_.ideal())
    {
        rho *= averaging_.gather(density_.ratio().primitiveField());
    }

    drag_.startStep(step_->subSteps());
    coefficient_.setSize(particles.count);
    charged_.setSize(particles.count);
    handedOn_.setSize(particles.count);
    forAll(coefficient_, i)
    {
        const scalar mass = particles.mass[i];
        coefficient_[i] = drag_.coefficient
        (
            gasAt_.voidFraction()[i],
            mag(gasAt_.velocity()[i] - velocity[i]),
            particles.radius[i],
            rho[i]
        )*form_.drag_over_a(gasAt_.voidFraction()[i]);
        charged_[i] = drag_.charged(coefficient_[i], mass, dt);
        handedOn_[i] =
            feltPressure_
          ? drag_.handedOnVolume(coefficient_[i], mass, sphere_volume(particles.radius[i]), dt)
          : 0;
        drag_.lookAtStep
        (
            position[i],
            gasAt_.voidFraction()[i],
            coefficient_[i],
            particles.radius[i],
            mass,
            rho[i],
            dt
        );
    }
    drag_.endStep(particles.count, dt);
}


void Foam::gasParticleCoupling::setSources(const volVectorField& gradP)
{
    const scalar dt = mesh_.time().deltaTValue();
    const auto particles = engine_->particles();
    const auto velocity = engineView(particles.velocity, particles.count);

    // The slip is U of the particle's cells less the particle's velocity less the offset.
    const List<vector> pending(pendingImpulse());
    const vectorField& offset = gasAt_.offset();
    vectorField charge(particles.count);
    forAll(charge, i)
    {
        for (direction d = 0; d < 3; ++d)
        {
            charge[i][d] = drag::source_on_gas
            (
                charged_[i],
                velocity[i][d],
                offset[i][d],
                pending[i][d],
                dt
            );
        }
    }
    const scalarField rate(averaging_.spread(charged_));
    const vectorField source(averaging_.spread(charge));
    forAll(rate, celli)
    {
        const scalar perGasMass = 1/(volume(celli)*rho_);
        dragRate_.field()[celli] = rate[celli]*perGasMass;
        dragSource_.field()[celli] = source[celli]*perGasMass;
    }
    if (form_.gas_takes_all)
    {
        return;
    }
    const scalarField handedOn(averaging_.spread(handedOn_));
    lastGradP_ = rho_*gradP.primitiveField();
    forAll(handedOn, celli)
    {
        handedOnShare_[celli] = handedOn[celli]/volume(celli);
        for (direction d = 0; d < 3; ++d)
        {
            dragSource_.field()[celli][d] += drag::last_pressure_on_gas
            (
                handedOnShare_[celli]/rho_,
                lastGradP_[celli][d],
                drag_.free()
            );
        }
    }
    handedOnShare_.correctBoundaryConditions();
    pressureShare_ = voidFraction_ + handedOnShare_;
}


Foam::vectorField Foam::gasParticleCoupling::chargedGradient(const volVectorField& gradP)
{
    if (form_.gas_takes_all)
    {
        return vectorField(engine_->particles().count, Zero);
    }
    vectorField charged(gradP.primitiveField());
    forAll(charged, celli)
    {
        for (direction d = 0; d < 3; ++d)
        {
            charged[celli][d] -= drag::last_pressure_on_gas(1, lastGradP_[celli][d], drag_.free());
        }
    }
    return averaging_.gather(charged);
}


void Foam::gasParticleCoupling::handOver
(
    const UList<vector>& gasVelocity,
    const UList<vector>& pressureGradient,
    const UList<vector>& chargedGradient
)
{
    const scalar dt = mesh_.time().deltaTValue();
    const auto velocity = engine_->particles().velocity;
    drag::GasOnParticle* gas = engine_->gas();
    feltPressure_ = true;
    forAll(coefficient_, i)
    {
        gas[i].drag_coefficient = coefficient_[i];
        for (direction d = 0; d < 3; ++d)
        {
            gas[i].drag_impulse[d] =
              - drag::impulse_charged(charged_[i], gasVelocity[i][d], velocity[i][d], dt)
              - handedOn_[i]*chargedGradient[i][d]*dt;
            gas[i].velocity[d] = gasVelocity[i][d];
            gas[i].pressure_gradient[d] = pressureGradient[i][d];
        }
    }
}
