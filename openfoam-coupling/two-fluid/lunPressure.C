// SPDX-License-Identifier: GPL-3.0-or-later
#include "lunPressure.H"

#include "kinetic_theory/granular_pressure.h"

#include "two-fluid/eachValue.H"

namespace
{

const Foam::kineticTheoryModels::granularPressureModel::addRemovabledictionaryConstructorToTable
<
    Foam::kineticTheoryModels::lunPressure
> added("lun");

} // End anonymous namespace


Foam::tmp<Foam::volScalarField> Foam::kineticTheoryModels::lunPressure::granularPressureCoeff
(
    const volScalarField& alpha1,
    const volScalarField& g0,
    const volScalarField& rho1,
    const dimensionedScalar& e
) const
{
    const auto law = [&](const scalar phi, const scalar radial, const scalar rho)
    {
        return cohesion::kinetic_theory::GranularPressure{rho, e.value()}.over_temperature(phi, radial);
    };
    return eachValue("PsCoeff", dimDensity, law, alpha1, g0, rho1);
}


Foam::tmp<Foam::volScalarField> Foam::kineticTheoryModels::lunPressure::granularPressureCoeffPrime
(
    const volScalarField& alpha1,
    const volScalarField& g0,
    const volScalarField& g0prime,
    const volScalarField& rho1,
    const dimensionedScalar& e
) const
{
    const auto law = [&](const scalar phi, const scalar radial, const scalar slope, const scalar rho)
    {
        return cohesion::kinetic_theory::GranularPressure{rho, e.value()}.slope(phi, radial, slope);
    };
    return eachValue("PsCoeffPrime", dimDensity, law, alpha1, g0, g0prime, rho1);
}
