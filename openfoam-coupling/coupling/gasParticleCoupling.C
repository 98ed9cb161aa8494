// SPDX-License-Identifier: GPL-3.0-or-later
// One gas step of the coupling, and its output.
#include "gasParticleCoupling.H"

#include "clockTime.H"

#include "sphere.h"

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


void Foam::gasParticleCoupling::fetchParticles()
{
    const auto particles = engine_->particles();
    exchange_.locate(view(particles.position, particles.count));
    velocity_ = exchange_.toGas(view(particles.velocity, particles.count));
    radius_ = exchange_.toGas(view(particles.radius, particles.count));
}


void Foam::gasParticleCoupling::setVoidFraction()
{
    std::vector<double> solid(mesh_.nCells(), 0.0);
    forAll(radius_, i)
    {
        deposit_(exchange_.cells()[i], sphere_volume(radius_[i]), solid);
    }

    scalarField& voidFraction = voidFraction_.primitiveFieldRef();
    forAll(voidFraction, celli)
    {
        voidFraction[celli] =
            void_fraction::void_fraction(solid[celli], mesh_.V()[celli], depthRatio_);
    }
    const label densest = voidFraction.size() ? findMin(voidFraction) : -1;
    const bool tooDense = densest >= 0 && voidFraction[densest] < minVoidFraction_;
    if (returnReduce(tooDense, orOp<bool>()))
    {
        reportTooDense(tooDense ? densest : -1);
    }
    voidFraction_.correctBoundaryConditions();
}


void Foam::gasParticleCoupling::reportTooDense(const label celli) const
{
    scalar lowest = celli >= 0 ? voidFraction_[celli] : GREAT;
    const scalar mine = lowest;
    reduce(lowest, minOp<scalar>());
    point where = mine == lowest ? mesh_.C()[celli] : point::max;
    reduce(where, minOp<point>());

    FatalIOErrorInFunction(dict_)
        << "the cell at " << where << " has a void fraction of " << lowest
        << ", less than minVoidFraction = " << minVoidFraction_ << nl
        << "    Cells of a few particle diameters cure it; nothing is clipped"
        << exit(FatalIOError);
    std::abort();
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
    const List<vector> pending(exchange_.toGas(pendingImpulse()));
    if (gasAt_.interpolated())
    {
        const auto particles = engine_->particles();
        const auto position = exchange_.toGas(view(particles.position, particles.count));
        gasAt_.interpolate(voidFraction_, U, exchange_.cells(), position);
    }

    coefficient_.setSize(radius_.size());
    scalarField& rate = dragRate_.field();
    vectorField& source = dragSource_.field();
    rate = 0;
    source = Zero;
    forAll(radius_, i)
    {
        const label celli = exchange_.cells()[i];
        // The slip is U of the cell less this.
        const vector velocity = velocity_[i] - gasAt_.offset(i);
        coefficient_[i] = drag_.coefficient
        (
            gasAt_.voidFraction(i, voidFraction_[celli]),
            mag(U[celli] - velocity),
            radius_[i]
        );
        const scalar perGasMass = 1/(volume(celli)*rho_);
        rate[celli] += coefficient_[i]*perGasMass;
        source[celli] += (coefficient_[i]*velocity - pending[i]/dt)*perGasMass;
    }
    drag_.endStep(radius_.size());
}


void Foam::gasParticleCoupling::depositParticles(const volVectorField& U)
{
    const clockTime timer;
    fetchParticles();
    setVoidFraction();
    setDrag(U);
    seconds_.exchange += timer.elapsedTime();
}


void Foam::gasParticleCoupling::handOver
(
    const UList<scalar>& coefficient,
    const UList<vector>& gasVelocity,
    const UList<vector>& gradP,
    const UList<vector>& charged
)
{
    drag::GasOnParticle* gas = engine_->gas();
    forAll(coefficient, i)
    {
        gas[i].drag_coefficient = coefficient[i];
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

    const labelList& cells = exchange_.cells();
    vectorField gasVelocity(cells.size());
    forAll(cells, i)
    {
        gasVelocity[i] = U[cells[i]] + gasAt_.offset(i);
    }
    const vectorField charged(coefficient_*(gasVelocity - velocity_)*dt);
    const vector pendingBefore = sum(pendingImpulse());
    handOver
    (
        exchange_.toEngine<scalar>(coefficient_),
        exchange_.toEngine<vector>(gasVelocity),
        exchange_.toEngine<vector>(vectorField(gradP.primitiveField(), cells)),
        exchange_.toEngine<vector>(charged)
    );
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
    fetchParticles();
    const auto particles = engine_->particles();
    const label n = particles.count;
    writeParticleCloud
    (
        mesh_,
        exchange_.cells(),
        exchange_.toGas(view(particles.position, n)),
        velocity_,
        radius_,
        exchange_.toGas(view(particles.id, n))
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
