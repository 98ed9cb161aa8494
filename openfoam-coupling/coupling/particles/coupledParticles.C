// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupledParticles.H"

#include "Time.H"

#include "coupling/exchange/meshCells.H"

namespace Foam
{
    defineTypeNameAndDebug(coupledParticles, 0);
}


Foam::coupledParticles::coupledParticles
(
    const polyMesh& mesh,
    const std::unique_ptr<cohesion::coupling::DemEngine>& engine,
    const bool continued,
    const vector& g,
    const gasDensity& density,
    const scalar& depthRatio,
    std::function<particleAveraging&()> locatedAveraging
)
:
    regIOobject(IOobject(typeName, mesh.time().timeName(), mesh)),
    engine_(engine),
    continued_(continued),
    g_(g),
    density_(density),
    depthRatio_(depthRatio),
    locatedAveraging_(std::move(locatedAveraging))
{}


void Foam::coupledParticles::whenPresent(std::function<void()> task) const
{
    waiting_.push_back(std::move(task));
}


void Foam::coupledParticles::start()
{
    for (const auto& task : waiting_)
    {
        task();
    }
    waiting_.clear();
}


Foam::UList<Foam::point> Foam::coupledParticles::positions() const
{
    const auto particles = engine_->particles();
    return engineView(particles.position, particles.count);
}


Foam::List<Foam::vector> Foam::coupledParticles::images() const
{
    const auto box = engine_->box();
    FixedList<bool, 3> periodic;
    vector periods;
    for (direction d = 0; d < 3; ++d)
    {
        periodic[d] = box.periodic[d];
        periods[d] = box.high[d] - box.low[d];
    }
    return meshCells::images(periodic, periods);
}


Foam::UList<Foam::vector> Foam::coupledParticles::velocities() const
{
    const auto particles = engine_->particles();
    return engineView(particles.velocity, particles.count);
}


Foam::UList<Foam::scalar> Foam::coupledParticles::radii() const
{
    const auto particles = engine_->particles();
    return engineView(particles.radius, particles.count);
}


Foam::UList<Foam::scalar> Foam::coupledParticles::masses() const
{
    const auto particles = engine_->particles();
    return engineView(particles.mass, particles.count);
}


Foam::UList<int> Foam::coupledParticles::ids() const
{
    const auto particles = engine_->particles();
    return engineView(particles.id, particles.count);
}


Foam::List<bool> Foam::coupledParticles::inserted() const
{
    const auto* gas = engine_->gas();
    List<bool> inserted(engine_->particles().count);
    forAll(inserted, i)
    {
        // A particle that was there at the beginning of the step has been given a coefficient, which is never 0.
        inserted[i] = gas[i].drag_coefficient == 0;
    }
    return inserted;
}


Foam::coupledParticles::GasImpulse Foam::coupledParticles::gasImpulse() const
{
    const auto felt = engine_->gas_impulse();
    return
    {
        vector(felt.drag[0], felt.drag[1], felt.drag[2]),
        vector(felt.pressure[0], felt.pressure[1], felt.pressure[2])
    };
}
