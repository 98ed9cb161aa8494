// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleFields.H"

#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"
#include "zeroGradientFvPatchFields.H"

#include "sphere.h"

#include "coupling/exchange/cellVolume.H"
#include "coupling/exchange/particleAveraging.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(particleFields, 0);
    addToRunTimeSelectionTable(functionObject, particleFields, dictionary);
}
}


namespace
{

using namespace Foam;

template<class Type>
GeometricField<Type, fvPatchField, volMesh> zeroField
(
    const word& name,
    const fvMesh& mesh,
    const dimensionSet& dimensions
)
{
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject(name, mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE),
        mesh,
        dimensioned<Type>(dimensions, Zero),
        zeroGradientFvPatchField<Type>::typeName
    );
}

} // End namespace


Foam::functionObjects::particleFields::particleFields
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    particleFunctionObject(name, runTime, dict, false),
    volumeFraction_(zeroField<scalar>("particleVolumeFraction", mesh_, dimless)),
    numberDensity_(zeroField<scalar>("particleNumberDensity", mesh_, dimless/dimVolume)),
    momentum_(zeroField<vector>("particleMomentum", mesh_, dimVelocity)),
    velocity_(zeroField<vector>("particleVelocity", mesh_, dimVelocity)),
    granularTemperature_(zeroField<scalar>("granularTemperature", mesh_, sqr(dimVelocity))),
    diameter_(zeroField<scalar>("particleDiameter", mesh_, dimLength))
{
    read(dict);
    warnOfUnknown(dict, {});
    active();
}


template<class What>
void Foam::functionObjects::particleFields::forEachField(const What& what)
{
    what(volumeFraction_);
    what(numberDensity_);
    what(momentum_);
    what(velocity_);
    what(granularTemperature_);
    what(diameter_);
}


void Foam::functionObjects::particleFields::begin()
{
    compute();
}


bool Foam::functionObjects::particleFields::execute()
{
    if (active())
    {
        compute();
    }
    return true;
}


bool Foam::functionObjects::particleFields::write()
{
    if (active())
    {
        forEachField([](const auto& field) { field.write(); });
    }
    return true;
}


void Foam::functionObjects::particleFields::compute()
{
    particleAveraging& averaging = particles().locatedAveraging();
    const UList<scalar> radii(particles().radii());
    const UList<vector> velocities(particles().velocities());
    scalarField volume(radii.size()), energy(radii.size()), perDiameter(radii.size());
    vectorField momentum(radii.size());
    forAll(radii, i)
    {
        volume[i] = cohesion::sphere_volume(radii[i]);
        momentum[i] = volume[i]*velocities[i];
        energy[i] = volume[i]*magSqr(velocities[i]);
        perDiameter[i] = volume[i]/(2*radii[i]);
    }
    const scalarField volumes(averaging.spread(volume));
    const scalarField numbers(averaging.spread(scalarField(radii.size(), 1)));
    const vectorField momenta(averaging.spread(momentum));
    const scalarField energies(averaging.spread(energy));
    const scalarField perDiameters(averaging.spread(perDiameter));
    forAll(volumes, celli)
    {
        const scalar cell = cellVolume(mesh_, particles().depthRatio(), celli);
        // Smoothing leaves rounding in cells without particles.
        const bool empty = volumes[celli] <= SMALL*cell;
        const vector mean = empty ? vector::zero : momenta[celli]/volumes[celli];
        volumeFraction_[celli] = volumes[celli]/cell;
        numberDensity_[celli] = numbers[celli]/cell;
        momentum_[celli] = empty ? vector::zero : momenta[celli]/cell;
        velocity_[celli] = mean;
        granularTemperature_[celli] =
            empty ? 0 : max(energies[celli]/volumes[celli] - magSqr(mean), scalar(0))/3;
        diameter_[celli] = empty ? 0 : volumes[celli]/perDiameters[celli];
    }
    forEachField([](auto& field) { field.correctBoundaryConditions(); });
}
