// SPDX-License-Identifier: GPL-3.0-or-later
#include "suspendedWeight.H"

#include "fvMatrices.H"
#include "uniformDimensionedFields.H"
#include "volFields.H"

namespace Foam
{
namespace fv
{
    defineTypeName(suspendedWeight);
    option::addRemovabledictionaryConstructorToTable<suspendedWeight> suspendedWeightAdded;
}
}


Foam::fv::suspendedWeight::suspendedWeight
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh),
    gravity_("gravity", dimAcceleration, coeffs_.get<vector>("gravity")),
    phases_(coeffs_.get<Pair<word>>("phases"))
{
    const auto* g = mesh.time().findObject<uniformDimensionedVectorField>("g");
    if (!g)
    {
        g = mesh.findObject<uniformDimensionedVectorField>("g");
    }
    if (g && mag(g->value()) > 0)
    {
        FatalIOErrorInFunction(dict)
            << "suspendedWeight brings the gravity of the box itself, and constant/g is " << g->value()
            << ": set it to (0 0 0)" << exit(FatalIOError);
    }
    for (const word& phase : phases_)
    {
        fieldNames_.append(IOobject::groupName("U", phase));
    }
    applied_.setSize(fieldNames_.size(), false);
}


std::pair<Foam::dimensionedScalar, Foam::dimensionedVector> Foam::fv::suspendedWeight::means() const
{
    scalar mass = 0;
    vector momentum = Zero;
    for (const word& phase : phases_)
    {
        const auto& alpha = mesh_.lookupObject<volScalarField>(IOobject::groupName("alpha", phase));
        const auto& rho = mesh_.lookupObject<volScalarField>(IOobject::groupName("thermo:rho", phase));
        const auto& U = mesh_.lookupObject<volVectorField>(IOobject::groupName("U", phase));
        const scalarField masses(alpha.primitiveField()*rho.primitiveField()*mesh_.V().field());
        mass += gSum(masses);
        momentum += gSum(masses*U.oldTime().primitiveField());
    }
    return
    {
        dimensionedScalar("density", dimDensity, mass/gSum(mesh_.V())),
        dimensionedVector("velocity", dimVelocity, momentum/mass)
    };
}


void Foam::fv::suspendedWeight::addSup
(
    const volScalarField& alpha,
    const volScalarField& rho,
    fvMatrix<vector>& eqn,
    const label
)
{
    const auto mixture = means();
    eqn += alpha*((rho - mixture.first)*gravity_ - rho*mixture.second/mesh_.time().deltaT());
}
