// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleTurnover.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include "drag/particle_drag.h"
#include "sphere.h"

#include "coupling/sixDigits.H"

using cohesion::coupling::DemEngine;

namespace
{

//- The particles of this rank, and those of them that are new: number [1] and mass [kg]
struct Present
{
    Foam::vector2D all = Foam::Zero;
    Foam::vector2D fresh = Foam::Zero;

    explicit Present(DemEngine& engine)
    {
        const auto particles = engine.particles();
        const auto* gas = engine.gas();
        for (int i = 0; i < particles.count; ++i)
        {
            const Foam::vector2D one(1, particles.mass[i]);
            all += one;
            if (gas[i].drag_coefficient == 0)
            {
                fresh += one;
            }
        }
    }
};


//- Of this rank [N s]
Foam::vector pendingImpulse(DemEngine& engine)
{
    Foam::vector sum = Foam::Zero;
    const auto* gas = engine.gas();
    const int count = engine.particles().count;
    for (int i = 0; i < count; ++i)
    {
        const auto& impulse = gas[i].drag_impulse;
        sum += Foam::vector(impulse[0], impulse[1], impulse[2]);
    }
    return sum;
}


//- Of this rank [N s]
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
    before_ = Present(engine).all;
    toFeel_ = pressureImpulse(engine, dt) - pendingImpulse(engine);
}


void Foam::particleTurnover::end(DemEngine& engine)
{
    const Present now(engine);
    Amount came = now.fresh;
    // On one rank also those that are on another now: what counts is the sum.
    Amount went = before_ - (now.all - now.fresh);
    notFelt_ = Zero;
    const Amount numbers(returnReduce(Amount(came.x(), went.x()), sumOp<Amount>()));
    if (numbers == Amount::zero)
    {
        return;
    }
    reduce(came, sumOp<Amount>());
    reduce(went, sumOp<Amount>());
    Info<< "Particles";
    if (came.x() > 0)
    {
        came_ += came;
        Info<< ", " << came.x() << " came (" << sixDigits(came.y()).c_str() << " kg)";
    }
    if (went.x() > 0)
    {
        went_ += went;
        const auto felt = engine.gas_impulse();
        for (direction d = 0; d < 3; ++d)
        {
            notFelt_[d] = toFeel_[d] - felt.drag[d] - felt.pressure[d];
        }
        notFelt_ += pendingImpulse(engine);
        reduce(notFelt_, sumOp<vector>());
        Info<< ", " << went.x() << " went (" << sixDigits(went.y()).c_str() << " kg) before they had felt "
            << sixDigits(notFelt_).c_str() << " N s of what the gas gave them";
    }
    Info<< endl;
}


void Foam::particleTurnover::report(DemEngine& engine) const
{
    if (came_.x() > 0 || went_.x() > 0)
    {
        const Amount all(returnReduce(Present(engine).all, sumOp<Amount>()));
        Info<< nl << "Particles in this run" << nl
            << "    came    " << came_.x() << ", " << sixDigits(came_.y()).c_str() << " kg" << nl
            << "    went    " << went_.x() << ", " << sixDigits(went_.y()).c_str() << " kg" << nl
            << "    at end  " << all.x() << ", " << sixDigits(all.y()).c_str() << " kg" << endl;
    }
}
