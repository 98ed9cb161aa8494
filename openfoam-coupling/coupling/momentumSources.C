// SPDX-License-Identifier: GPL-3.0-or-later
#include "momentumSources.H"

#include "zeroGradientFvPatchFields.H"

#include "coupling/exchange/cellVolume.H"

using namespace cohesion;


Foam::momentumSources::momentumSources
(
    const fvMesh& mesh,
    const scalar& depthRatio,
    const drag::Response& response,
    const scalar rho
)
:
    mesh_(mesh),
    depthRatio_(depthRatio),
    response_(response),
    rho_(rho),
    transmittedFraction_
    (
        IOobject("transmittedFraction", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    pressureFraction_
    (
        IOobject("pressureFraction", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1)
    ),
    dragRate_
    (
        IOobject("dragRate", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero)
    ),
    dragSource_
    (
        IOobject("dragSource", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimAcceleration, Zero)
    )
{}


void Foam::momentumSources::setDrag(const scalarField& rate, const vectorField& source)
{
    forAll(rate, celli)
    {
        const scalar perGasMass = 1/(cellVolume(mesh_, depthRatio_, celli)*rho_);
        dragRate_.field()[celli] = rate[celli]*perGasMass;
        dragSource_.field()[celli] = source[celli]*perGasMass;
    }
}


void Foam::momentumSources::addPressure
(
    const scalarField& transmitted,
    const volVectorField& gradPOverRho,
    const volScalarField& voidFraction
)
{
    lastGradP_ = rho_*gradPOverRho.primitiveField();
    forAll(transmitted, celli)
    {
        transmittedFraction_[celli] = transmitted[celli]/cellVolume(mesh_, depthRatio_, celli);
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
    pressureFraction_ = voidFraction + transmittedFraction_;
}


Foam::vectorField Foam::momentumSources::chargedGradient(const volVectorField& gradP) const
{
    vectorField gradient(gradP.primitiveField());
    forAll(gradient, celli)
    {
        for (direction d = 0; d < 3; ++d)
        {
            gradient[celli][d] -= drag::last_pressure_on_gas(1, lastGradP_[celli][d], response_.free);
        }
    }
    return gradient;
}
