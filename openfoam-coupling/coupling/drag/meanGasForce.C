// SPDX-License-Identifier: GPL-3.0-or-later
#include "meanGasForce.H"

#include "Pstream.H"
#include "ops.H"

#include "drag/particle_drag.h"
#include "sphere.h"

#include "coupling/fromFirstRank.H"
#include "coupling/particles/engineView.H"


Foam::meanGasForce::meanGasForce(cohesion::coupling::DemEngine& engine)
:
    engine_(engine),
    before_(2*engine.particles().count)
{
    const auto particles = engine_.particles();
    const auto* gas = engine_.gas();
    for (label i = 0; i < particles.count; ++i)
    {
        before_.insert(particles.id[i], dragImpulse(gas[i]));
    }
}


Foam::vectorField Foam::meanGasForce::over(const scalar dt)
{
    const auto particles = engine_.particles();
    const auto* gas = engine_.gas();
    vectorField force(particles.count);
    DynamicList<label> arrived;
    forAll(force, i)
    {
        // A particle that was inserted within the step may have the number of one that was removed.
        if (gas[i].drag_coefficient == 0)
        {
            force[i] = Zero;
            continue;
        }
        force[i] = dragImpulse(gas[i])/dt;
        const auto before = before_.find(particles.id[i]);
        if (before.found())
        {
            force[i] -= before.val()/dt;
            before_.erase(before);
        }
        else
        {
            arrived.append(i);
        }
        const scalar volume = cohesion::sphere_volume(particles.radius[i]);
        for (direction d = 0; d < 3; ++d)
        {
            force[i][d] += cohesion::drag::pressure_force(volume, gas[i].pressure_gradient[d]);
        }
    }
    // Particles that are left have gone to other ranks, or have been removed.
    Pstream::mapCombineGather(before_, plusEqOp<vector>());
    fromFirstRank(before_);
    for (const label i : arrived)
    {
        force[i] -= before_.lookup(particles.id[i], Zero)/dt;
    }
    return force;
}
