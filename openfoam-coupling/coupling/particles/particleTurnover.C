// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleTurnover.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include "drag/particle_drag.h"
#include "sphere.h"

#include "coupling/sixDigits.H"
#include "engineView.H"

using cohesion::coupling::DemEngine;

namespace
{

//- The particles of this rank, and those of them that were inserted: number [1] and mass [kg]
struct Count
{
    Foam::vector2D all = Foam::Zero;
    Foam::vector2D inserted = Foam::Zero;

    explicit Count(DemEngine& engine)
    {
        const auto particles = engine.particles();
        const auto* gas = engine.gas();
        for (int i = 0; i < particles.count; ++i)
        {
            const Foam::vector2D one(1, particles.mass[i]);
            all += one;
            if (gas[i].drag_coefficient == 0)
            {
                inserted += one;
            }
        }
    }
};


//- What the gas is yet to be charged with, of the particles of this rank [N s]
Foam::vector deferredImpulse(DemEngine& engine)
{
    Foam::vector sum = Foam::Zero;
    const auto* gas = engine.gas();
    const int count = engine.particles().count;
    for (int i = 0; i < count; ++i)
    {
        sum += Foam::dragImpulse(gas[i]);
    }
    return sum;
}


//- What the pressure gives to the particles of this rank in a gas step dt [N s]
Foam::vector pressureImpulse(DemEngine& engine, const Foam::scalar dt)
{
    Foam::vector sum = Foam::Zero;
    const auto* gas = engine.gas();
    const auto particles = engine.particles();
    for (int i = 0; i < particles.count; ++i)
    {
        const Foam::scalar volume = cohesion::sphere_volume(particles.radius[i]);
        for (Foam::direction d = 0; d < 3; ++d)
        {
            sum[d] += cohesion::drag::pressure_force(volume, gas[i].pressure_gradient[d])*dt;
        }
    }
    return sum;
}

} // End anonymous namespace


void Foam::particleTurnover::start(DemEngine& engine, const scalar dt)
{
    before_ = Count(engine).all;
    expected_ = pressureImpulse(engine, dt) - deferredImpulse(engine);
}


void Foam::particleTurnover::end(DemEngine& engine)
{
    const Count now(engine);
    Amount inserted = now.inserted;
    // On one rank this includes those that have gone to another: only the sum of all ranks counts.
    Amount removed = before_ - (now.all - now.inserted);
    undelivered_ = Zero;
    const Amount numbers(returnReduce(Amount(inserted.x(), removed.x()), sumOp<Amount>()));
    if (numbers == Amount::zero)
    {
        return;
    }
    reduce(inserted, sumOp<Amount>());
    reduce(removed, sumOp<Amount>());
    Info<< "Particles";
    if (inserted.x() > 0)
    {
        inserted_ += inserted;
        Info<< ", " << inserted.x() << " came (" << sixDigits(inserted.y()).c_str() << " kg)";
    }
    if (removed.x() > 0)
    {
        removed_ += removed;
        const auto felt = engine.gas_impulse();
        for (direction d = 0; d < 3; ++d)
        {
            undelivered_[d] = expected_[d] - felt.drag[d] - felt.pressure[d];
        }
        undelivered_ += deferredImpulse(engine);
        reduce(undelivered_, sumOp<vector>());
        Info<< ", " << removed.x() << " went (" << sixDigits(removed.y()).c_str() << " kg) before they had felt "
            << sixDigits(undelivered_).c_str() << " N s of what the gas gave them";
    }
    Info<< endl;
}


void Foam::particleTurnover::report(DemEngine& engine) const
{
    if (inserted_.x() > 0 || removed_.x() > 0)
    {
        const Amount all(returnReduce(Count(engine).all, sumOp<Amount>()));
        Info<< nl << "Particles in this run" << nl
            << "    came    " << inserted_.x() << ", " << sixDigits(inserted_.y()).c_str() << " kg" << nl
            << "    went    " << removed_.x() << ", " << sixDigits(removed_.y()).c_str() << " kg" << nl
            << "    at end  " << all.x() << ", " << sixDigits(all.y()).c_str() << " kg" << endl;
    }
}
