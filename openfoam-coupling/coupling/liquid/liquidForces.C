// SPDX-License-Identifier: GPL-3.0-or-later
#include "liquidForces.H"

#include "fvcGrad.H"

#include "sphere.h"

#include "coupling/input/readPositive.H"
#include "coupling/input/selectRow.H"

using namespace cohesion;

namespace
{

std::optional<liquid::AddedMass> readAddedMass(const Foam::dictionary& dict)
{
    using namespace Foam;
    if (!dict.found("addedMass"))
    {
        return std::nullopt;
    }
    ITstream& words = dict.lookup("addedMass");
    const token first(words);
    if (first.isNumber())
    {
        return liquid::AddedMass(requirePositive(dict, "addedMass", first.number()));
    }
    const Switch on(first.isWord() ? first.wordToken() : word::null, true);
    if (!on.valid())
    {
        FatalIOErrorInFunction(dict)
            << "addedMass is '" << first << "'; it is off, on, or the coefficient C, a number greater than zero"
            << exit(FatalIOError);
    }
    return on ? std::optional<liquid::AddedMass>(std::in_place) : std::nullopt;
}

std::optional<Foam::scalar> readLiftCoefficient(const Foam::dictionary& dict, const liquid::LiftLaw& lift)
{
    using namespace Foam;
    if (!dict.found("liftCoefficient"))
    {
        return std::nullopt;
    }
    if (lift.name != "inviscid")
    {
        FatalIOErrorInFunction(dict)
            << "liftCoefficient goes with 'lift inviscid;', and lift is " << lift.name.data()
            << ": remove the entry, or take that lift" << exit(FatalIOError);
    }
    return readPositive(dict, "liftCoefficient");
}

} // End anonymous namespace


Foam::liquidForces::liquidForces(const dictionary& dict, const drag::Closure& closure)
:
    addedMass_(readAddedMass(dict)),
    lift_(selectRow(dict, "lift", liquid::lift_laws, "none")),
    liftCoefficient_(readLiftCoefficient(dict, lift_)),
    quadratic_(closure.quadratic)
{}


void Foam::liquidForces::start(const label n, const volVectorField& U, particleAveraging& averaging)
{
    inertia_.setSize(n);
    onParticles_.setSize(n);
    velocity_ = U.primitiveField();
    const tmp<volTensorField> gradient(fvc::grad(U));
    // OpenFOAM's gradient has the derivative first.
    advection_ = velocity_ & gradient().primitiveField();
    if (lift_.coefficient)
    {
        vectorField curl(velocity_.size());
        forAll(curl, celli)
        {
            curl[celli] = 2*(*skew(gradient()[celli]));
        }
        vorticity_ = averaging.gather(curl);
    }
}


void Foam::liquidForces::set
(
    const label i,
    const particleDrag& drag,
    const particleDrag::DragConditions& sphere,
    const scalar perSlip,
    const scalar inertia
)
{
    const scalar V = sphere_volume(sphere.radius);
    inertia_[i] = inertia;
    liquid::LiquidOnParticle& row = onParticles_[i];
    row = {};
    row.added_mass = addedMass(sphere.rho, V);
    row.drag_per_slip = perSlip;
    if (lift_.coefficient)
    {
        const liquid::ShearedFlow flow
            {mag(vorticity_[i]), sphere.slip, 2*sphere.radius, sphere.rho, drag.mu()};
        const scalar coefficient = liftCoefficient_ ? *liftCoefficient_ : lift_.coefficient(flow);
        for (direction d = 0; d < 3; ++d)
        {
            row.lift[d] = coefficient*sphere.rho*V*vorticity_[i][d];
        }
    }
}


void Foam::liquidForces::setCells(particleAveraging& averaging, const scalarField& volumes, const scalar rho)
{
    inertiaOfCells_ = averaging.spread(inertia_);
    inertiaOfCells_ /= volumes*rho;
}


void Foam::liquidForces::addTo(fvVectorMatrix& UEqn) const
{
    const fvMesh& mesh = UEqn.psi().mesh();
    const scalar dt = mesh.time().deltaTValue();
    const scalarField& V = mesh.V();
    forAll(V, celli)
    {
        const scalar rate = V[celli]*inertiaOfCells_[celli]/dt;
        UEqn.diag()[celli] += rate;
        UEqn.source()[celli] += rate*(velocity_[celli] - dt*advection_[celli]);
    }
}
