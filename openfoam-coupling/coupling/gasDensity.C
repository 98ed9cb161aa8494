// SPDX-License-Identifier: GPL-3.0-or-later
#include "gasDensity.H"

#include "selectRow.H"

#include <array>

using cohesion::gas::IdealGas;

namespace
{

struct Density
{
    std::string_view name;
    bool ideal;
};

constexpr std::array densities{Density{"constant", false}, Density{"idealGas", true}};


std::optional<IdealGas> readLaw(const Foam::dictionary& dict)
{
    if (!Foam::selectRow(dict, "density", densities, "constant").ideal)
    {
        return {};
    }
    const Foam::dictionary& coeffs = dict.subDict("idealGas");
    try
    {
        const IdealGas law
        (
            coeffs.get<Foam::scalar>("pressure"),
            coeffs.get<Foam::scalar>("temperature"),
            coeffs.get<Foam::scalar>("molWeight")
        );
        if (dict.found("rho"))
        {
            FatalIOErrorInFunction(dict)
                << "rho is given, and the density of an idealGas follows from its pressure, temperature and"
                << " molWeight: it is " << law.density() << " kg/m3; remove the entry rho"
                << Foam::exit(Foam::FatalIOError);
        }
        return law;
    }
    catch (const cohesion::InvalidParameter& error)
    {
        FatalIOErrorInFunction(coeffs) << error.what() << Foam::exit(Foam::FatalIOError);
        throw;
    }
}

} // End anonymous namespace


Foam::gasDensity::gasDensity
(
    const dictionary& transportProperties,
    const volScalarField& p
)
:
    p_(p),
    law_(readLaw(transportProperties)),
    reference_
    (
        ideal()
      ? dimensionedScalar("rho", dimDensity, law_->density())
      : dimensionedScalar("rho", dimDensity, transportProperties)
    )
{
    if (ideal())
    {
        Info<< "Ideal gas of " << reference_.value() << " kg/m3 where p is 0, sound at "
            << law_->sound_speed() << " m/s" << nl << endl;
        ratio_.reset
        (
            new volScalarField
            (
                IOobject
                (
                    "densityRatio",
                    p.time().timeName(),
                    p.mesh(),
                    IOobject::NO_READ,
                    IOobject::AUTO_WRITE
                ),
                1 + compressibility()*p
            )
        );
    }
}


void Foam::gasDensity::correct()
{
    if (ideal())
    {
        ratio_() = 1 + compressibility()*p_;
    }
}


void Foam::gasDensity::refuseVacuum() const
{
    if (!ideal())
    {
        return;
    }
    const scalar lowest = gMin(ratio_().primitiveField());
    if (!(lowest > 0))
    {
        FatalErrorInFunction
            << "the density of the gas has fallen to " << lowest*reference_.value() << " kg/m3, which no"
            << " ideal gas can have: the flow wants a lower pressure than there is. Look at what draws the"
            << " gas, at the reference pressure in constant/transportProperties and at deltaT"
            << exit(FatalError);
    }
}
