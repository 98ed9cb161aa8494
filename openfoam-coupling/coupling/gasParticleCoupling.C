// SPDX-License-Identifier: GPL-3.0-or-later
// One gas step of the coupling, and its output.
#include "gasParticleCoupling.H"

#include "clockTime.H"

#include "sphere.h"
#include "void_fraction/void_fraction.h"

#include "writeParticleCloud.H"

using namespace cohesion;

namespace
{

//- The engine's arrays as OpenFOAM's, in place. UList has no form for constant data; none of the
//  views of constant data is written to.
Foam::UList<Foam::vector> view(const double (*rows)[3], const Foam::label n)
{
    static_assert(sizeof(Foam::vector) == sizeof(rows[0]), "OpenFOAM must use double precision");
    return {reinterpret_cast<Foam::vector*>(const_cast<double (*)[3]>(rows)), n};
}

template<class Type>
Foam::UList<Type> view(const Type* values, const Foam::label n)
{
    return {const_cast<Type*>(values), n};
}

} // End anonymous namespace


void Foam::gasParticleCoupling::locateParticles()
{
    const auto particles = engine_->particles();
    averaging_.exchange().locate
    (
        view(particles.position, particles.count),
        view(particles.radius, particles.count)
    );
}


void Foam::gasParticleCoupling::setVoidFraction()
{
    const auto particles = engine_->particles();
    scalarField volumes(particles.count);
    forAll(volumes, i)
    {
        volumes[i] = sphere_volume(particles.radius[i]);
    }
    const scalarField solid(averaging_.spread(volumes));

    scalarField& voidFraction = voidFraction_.primitiveFieldRef();
    forAll(voidFraction, celli)
    {
        voidFraction[celli] =
            void_fraction::void_fraction(solid[celli], mesh_.V()[celli], depthRatio_);
    }
    refuseTooDense();
    voidFraction_.correctBoundaryConditions();
}


void Foam::gasParticleCoupling::refuseTooDense() const
{
    label tooDense = 0;
    scalar excess = 0;
    scalar lowest = GREAT;
    point where = point::max;
    forAll(voidFraction_, celli)
    {
        if (voidFraction_[celli] < minVoidFraction_)
        {
            ++tooDense;
            excess += (minVoidFraction_ - voidFraction_[celli])*volume(celli);
            if (voidFraction_[celli] < lowest)
            {
                lowest = voidFraction_[celli];
                where = mesh_.C()[celli];
            }
        }
    }
    if (!returnReduce(tooDense, sumOp<label>()))
    {
        return;
    }
    const scalar mine = lowest;
    reduce(tooDense, sumOp<label>());
    reduce(excess, sumOp<scalar>());
    reduce(lowest, minOp<scalar>());
    where = mine == lowest ? where : point::max;
    reduce(where, minOp<point>());
    const auto particles = engine_->particles();
    scalar all = 0;
    for (label i = 0; i < particles.count; ++i)
    {
        all += sphere_volume(particles.radius[i]);
    }
    reduce(all, sumOp<scalar>());

    FatalIOErrorInFunction(dict_)
        << tooDense << " cells have a void fraction below minVoidFraction = " << minVoidFraction_
        << "; the lowest is " << lowest << ", of the cell at " << where << nl
        << "    The solid beyond the limit is " << excess << " m3, " << 100*excess/all
        << " % of all particles; nothing is clipped. Cells of a few particle diameters cure it,"
        << " voidFraction sphereOverlap, or a smoothingWidth" << exit(FatalIOError);
}


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


void Foam::gasParticleCoupling::setDrag(const volVectorField& U)
{
    const scalar dt = mesh_.time().deltaTValue();
    const auto particles = engine_->particles();
    const auto velocity = view(particles.velocity, particles.count);
    gasAt_.set(voidFraction_, U, averaging_);

    coefficient_.setSize(particles.count);
    forAll(coefficient_, i)
    {
        coefficient_[i] = drag_.coefficient
        (
            gasAt_.voidFraction()[i],
            mag(gasAt_.velocity()[i] - velocity[i]),
            particles.radius[i]
        );
    }
    drag_.endStep(particles.count);

    // The slip is U of the particle's cells less the particle's velocity less the offset.
    const vectorField charge
    (
        coefficient_*(velocity - gasAt_.offset()) - vectorField(pendingImpulse())/dt
    );
    const scalarField rate(averaging_.spread(coefficient_));
    const vectorField source(averaging_.spread(charge));
    forAll(rate, celli)
    {
        const scalar perGasMass = 1/(volume(celli)*rho_);
        dragRate_.field()[celli] = rate[celli]*perGasMass;
        dragSource_.field()[celli] = source[celli]*perGasMass;
    }
}


void Foam::gasParticleCoupling::depositParticles(const volVectorField& U)
{
    const clockTime timer;
    locateParticles();
    setVoidFraction();
    setDrag(U);
    seconds_.exchange += timer.elapsedTime();
}


void Foam::gasParticleCoupling::handOver
(
    const UList<vector>& gasVelocity,
    const UList<vector>& gradP,
    const UList<vector>& charged
)
{
    drag::GasOnParticle* gas = engine_->gas();
    forAll(coefficient_, i)
    {
        gas[i].drag_coefficient = coefficient_[i];
        for (direction d = 0; d < 3; ++d)
        {
            gas[i].velocity[d] = gasVelocity[i][d];
            gas[i].pressure_gradient[d] = gradP[i][d];
            gas[i].drag_impulse[d] = -charged[i][d];
        }
    }
}


void Foam::gasParticleCoupling::advanceParticles
(
    const volVectorField& U,
    const volVectorField& gradP
)
{
    clockTime timer;
    const scalar dt = mesh_.time().deltaTValue();

    const auto particles = engine_->particles();
    const vectorField gasVelocity(averaging_.gather(U.primitiveField()) + gasAt_.offset());
    const vectorField charged
    (
        coefficient_*(gasVelocity - view(particles.velocity, particles.count))*dt
    );
    const vector pendingBefore = sum(pendingImpulse());
    handOver(gasVelocity, averaging_.gather(gradP.primitiveField()), charged);
    seconds_.exchange += timer.timeIncrement();

    engine_->advance(subSteps_);
    seconds_.particles += timer.timeIncrement();

    reportBalance(U, gradP, pendingBefore);
    seconds_.exchange += timer.timeIncrement();
}


void Foam::gasParticleCoupling::reportBalance
(
    const volVectorField& U,
    const volVectorField& gradP,
    const vector& pendingBefore
) const
{
    const scalar dt = mesh_.time().deltaTValue();

    // The gas, from the source terms of its own equation
    vector gasDrag = Zero;
    vector gasPressure = Zero;
    scalar solidDeposited = 0;
    forAll(U, celli)
    {
        const scalar solid = (1 - voidFraction_[celli])*volume(celli);
        gasDrag +=
            (dragSource_[celli] - dragRate_[celli]*U[celli])*rho_*volume(celli)*dt;
        gasPressure += solid*gradP[celli]*dt;
        solidDeposited += solid;
    }

    // The particles, from the engine's book of the forces it put on
    const auto particles = engine_->particles();
    const auto felt = engine_->gas_impulse();
    vector drag(felt.drag[0], felt.drag[1], felt.drag[2]);
    vector pressure(felt.pressure[0], felt.pressure[1], felt.pressure[2]);
    vector pending = sum(pendingImpulse()) - pendingBefore;
    scalar solidVolume = 0;
    for (label i = 0; i < particles.count; ++i)
    {
        solidVolume += sphere_volume(particles.radius[i]);
    }

    reduce(gasDrag, sumOp<vector>());
    reduce(gasPressure, sumOp<vector>());
    reduce(drag, sumOp<vector>());
    reduce(pressure, sumOp<vector>());
    reduce(pending, sumOp<vector>());
    reduce(solidDeposited, sumOp<scalar>());
    reduce(solidVolume, sumOp<scalar>());

    const scalar size = mag(drag) + mag(pressure) + VSMALL;
    Info<< "Exchange: drag on particles " << drag/dt << " N, pressure " << pressure/dt
        << " N, not yet charged to the gas " << pending/dt
        << " N, imbalance " << mag(gasDrag + drag - pending + gasPressure + pressure)/size
        << ", solid volume error " << mag(solidDeposited/solidVolume - 1) << endl;
}


// * * * * * * * * * * * * * * * *  Output  * * * * * * * * * * * * * * * * //

void Foam::gasParticleCoupling::writeParticles()
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
    writeParticleCloud
    (
        mesh_,
        labelList(exchange.cells(), centred),
        List<point>(exchange.positions(), centred),
        List<vector>(exchange.toParts(view(particles.velocity, n)), centred),
        List<scalar>(exchange.toParts(view(particles.radius, n)), centred),
        labelList(exchange.toParts(view(particles.id, n)), centred)
    );
}


void Foam::gasParticleCoupling::report(const scalar total) const
{
    drag_.report();

    scalar particles = seconds_.particles;
    scalar exchange = seconds_.exchange;
    reduce(particles, maxOp<scalar>());
    reduce(exchange, maxOp<scalar>());

    const auto row = [total](const char* name, const scalar seconds)
    {
        Info<< "    " << name << seconds << " s, " << 100*seconds/total << " %" << nl;
    };
    Info<< nl << "Where the time went (" << Pstream::nProcs() << " ranks)" << nl;
    row("particles  ", particles);
    row("gas        ", total - particles - exchange);
    row("exchange   ", exchange);
    row("all        ", total);
    Info<< endl;
}
