// SPDX-License-Identifier: GPL-3.0-or-later
#include "gidaspowTransport.H"

#include "kinetic_theory/gidaspow.h"

#include "two-fluid/eachValue.H"

namespace
{

using namespace Foam::kineticTheoryModels;
using cohesion::kinetic_theory::Gidaspow;

const viscosityModel::addRemovabledictionaryConstructorToTable<gidaspowViscosity> viscosityAdded("gidaspow");
const conductivityModel::addRemovabledictionaryConstructorToTable<gidaspowConductivity> conductivityAdded("gidaspow");

} // End anonymous namespace


Foam::tmp<Foam::volScalarField> Foam::kineticTheoryModels::gidaspowViscosity::nu
(
    const volScalarField& alpha1,
    const volScalarField& Theta,
    const volScalarField& g0,
    const volScalarField&,
    const volScalarField& da,
    const dimensionedScalar& e
) const
{
    // Kinematic: of a material of density 1
    const auto law = [&](const scalar phi, const scalar theta, const scalar radial, const scalar d)
    {
        return Gidaspow{1, d, e.value()}.viscosity(phi, radial, theta);
    };
    return eachValue("nu", dimViscosity, law, alpha1, Theta, g0, da);
}


Foam::tmp<Foam::volScalarField> Foam::kineticTheoryModels::gidaspowConductivity::kappa
(
    const volScalarField& alpha1,
    const volScalarField& Theta,
    const volScalarField& g0,
    const volScalarField& rho1,
    const volScalarField& da,
    const dimensionedScalar& e
) const
{
    const auto law = [&]
    (
        const scalar phi,
        const scalar theta,
        const scalar radial,
        const scalar rho,
        const scalar d
    )
    {
        return Gidaspow{rho, d, e.value()}.conductivity(phi, radial, theta);
    };
    return eachValue("kappa", dimDynamicViscosity, law, alpha1, Theta, g0, rho1, da);
}
