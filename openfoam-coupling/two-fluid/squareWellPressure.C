// SPDX-License-Identifier: GPL-3.0-or-later
#include "squareWellPressure.H"

#include "two-fluid/eachValue.H"

using namespace cohesion::kinetic_theory;

namespace
{

const Foam::kineticTheoryModels::granularPressureModel::addRemovabledictionaryConstructorToTable
<
    Foam::kineticTheoryModels::squareWellPressure
> added("squareWell");

SquareWellGas readGas(const Foam::dictionary& dict)
{
    using Foam::scalar;
    try
    {
        return SquareWellGas
        (
            dict.get<scalar>("wellDepth"),
            dict.get<scalar>("wellRatio"),
            dict.get<scalar>("grainMass")
        );
    }
    catch (const cohesion::InvalidParameter& error)
    {
        FatalIOErrorInFunction(dict) << error.what() << Foam::exit(Foam::FatalIOError);
        throw;
    }
}

} // End anonymous namespace


Foam::kineticTheoryModels::squareWellPressure::squareWellPressure(const dictionary& dict)
:
    granularPressureModel(dict),
    gas_(readGas(dict.optionalSubDict("squareWellCoeffs"))),
    reported_(-1)
{}


const Foam::volScalarField& Foam::kineticTheoryModels::squareWellPressure::temperature
(
    const volScalarField& rho1
) const
{
    return rho1.mesh().lookupObject<volScalarField>(IOobject::groupName("Theta", rho1.group()));
}


void Foam::kineticTheoryModels::squareWellPressure::warn(const word& phase, const scalar e) const
{
    if (gas_.depth() == 0)
    {
        return;
    }
    if (e < 1)
    {
        WarningInFunction
            << "granularPressureModel squareWell of " << phase << " was measured of grains with a restitution of 1, and"
            << " e = " << e << ": pairs that lose energy stay in their wells, and the pressure is lower than this"
            << " model's" << endl;
    }
    if (gas_.lambda() != CohesiveRatio::measured_lambda && gas_.lambda() > 1)
    {
        WarningInFunction
            << "granularPressureModel squareWell of " << phase << " was measured of wells with a wellRatio of "
            << CohesiveRatio::measured_lambda << ", and it is " << gas_.lambda()
            << ": right for few grains, untried for many" << endl;
    }
}


void Foam::kineticTheoryModels::squareWellPressure::report
(
    const volScalarField& alpha1,
    const volScalarField& Theta,
    const word& phase,
    const scalar e
) const
{
    const label step = alpha1.time().timeIndex();
    if (step == reported_)
    {
        return;
    }
    if (reported_ < 0)
    {
        warn(phase, e);
    }
    reported_ = step;
    // Cells and volume of grains: of all, of those too cold, of those too dense
    FixedList<label, 3> cells(Zero);
    FixedList<scalar, 3> grains(Zero);
    forAll(alpha1, i)
    {
        const SquareWellGas::PressureRatio found = gas_.ratio(alpha1[i], Theta[i]);
        const FixedList<bool, 3> counted{true, found.too_cold, found.too_dense};
        forAll(counted, kind)
        {
            if (counted[kind])
            {
                ++cells[kind];
                grains[kind] += max(alpha1[i], scalar(0))*alpha1.mesh().V()[i];
            }
        }
    }
    forAll(cells, kind)
    {
        reduce(cells[kind], sumOp<label>());
        reduce(grains[kind], sumOp<scalar>());
    }
    const auto say = [&](const label kind, const char* what, const scalar end, const char* as)
    {
        if (cells[kind])
        {
            Info<< "squareWell " << phase << ": " << cells[kind] << " of " << cells[0] << " cells, with "
                << grains[kind]/max(grains[0], VSMALL) << " of the grains, " << what << end << as << endl;
        }
    };
    say(1, "are colder than was measured, D/T above ", gas_.largest_depth_over_t(), ": their pressure is that of it");
    say(2, "are denser than was measured, above ", CohesiveRatio::largest_fraction, ": cohesion there as at it");
}


Foam::tmp<Foam::volScalarField> Foam::kineticTheoryModels::squareWellPressure::granularPressureCoeff
(
    const volScalarField& alpha1,
    const volScalarField& g0,
    const volScalarField& rho1,
    const dimensionedScalar& e
) const
{
    const volScalarField& Theta = temperature(rho1);
    report(alpha1, Theta, rho1.group(), e.value());
    const auto law = [&](const scalar phi, const scalar theta, const scalar radial, const scalar rho)
    {
        return GranularPressure{rho, e.value()}.over_temperature(phi, radial, gas_.ratio(phi, theta).cohesion.ratio);
    };
    return eachValue("PsCoeff", dimDensity, law, alpha1, Theta, g0, rho1);
}


Foam::tmp<Foam::volScalarField> Foam::kineticTheoryModels::squareWellPressure::granularPressureCoeffPrime
(
    const volScalarField& alpha1,
    const volScalarField& g0,
    const volScalarField& g0prime,
    const volScalarField& rho1,
    const dimensionedScalar& e
) const
{
    const volScalarField& Theta = temperature(rho1);
    report(alpha1, Theta, rho1.group(), e.value());
    const auto law = [&]
    (
        const scalar phi,
        const scalar theta,
        const scalar radial,
        const scalar radialSlope,
        const scalar rho
    )
    {
        return GranularPressure{rho, e.value()}.slope(phi, radial, radialSlope, gas_.ratio(phi, theta).cohesion);
    };
    return eachValue("PsCoeffPrime", dimDensity, law, alpha1, Theta, g0, g0prime, rho1);
}
