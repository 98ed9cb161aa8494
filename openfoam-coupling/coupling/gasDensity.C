// SPDX-License-Identifier: GPL-3.0-or-later
#include "gasDensity.H"

#include "coupling/input/selectRow.H"

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
    constexpr const char* entries =
        "idealGas { pressure [Pa], the absolute one where p is 0; temperature [K]; molWeight [kg/kmol]; }";
    if (!Foam::selectRow(dict, "density", densities, "constant").ideal)
    {
        if (dict.found("idealGas") && !dict.found("density"))
        {
            FatalIOErrorInFunction(dict)
                << "idealGas is given, and without the entry density it is not used: add 'density idealGas;'"
                << " and remove rho, or add 'density constant;'" << Foam::exit(Foam::FatalIOError);
        }
        return {};
    }
    const Foam::dictionary& coeffs = dict.subOrEmptyDict("idealGas");
    for (const char* entry : {"pressure", "temperature", "molWeight"})
    {
        if (!coeffs.found(entry))
        {
            FatalIOErrorInFunction(dict)
                << "density idealGas needs " << entry << ": " << entries << Foam::exit(Foam::FatalIOError);
        }
    }
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
        requirePositive();
    }
}


void Foam::gasDensity::correct()
{
    if (ideal())
    {
        ratio_() = 1 + compressibility()*p_;
    }
}


void Foam::gasDensity::requirePositive() const
{
    if (!ideal())
    {
        return;
    }
    scalar lowest = gMin(ratio_().primitiveField());
    // Patches between ranks, of which each has others, come last.
    label patch = -1;
    for (const auto& values : ratio_().boundaryField())
    {
        const scalar there = values.coupled() || values.empty() ? GREAT : min(values);
        if (there < lowest)
        {
            lowest = there;
            patch = values.patch().index();
        }
    }
    const scalar mine = lowest;
    reduce(lowest, minOp<scalar>());
    patch = mine == lowest ? patch : -1;
    reduce(patch, maxOp<label>());
    if (!(lowest > 0))
    {
        const scalar vacuum = -1/compressibility().value();
        const word where(patch < 0 ? "in cells" : "on patch " + p_.mesh().boundary()[patch].name(), false);
        FatalErrorInFunction
            << "p = " << vacuum*(1 - lowest) << ' ' << where.c_str() << " at time " << p_.time().timeName()
            << ": the density of the gas would be " << lowest*reference_.value() << " kg/m3, which no ideal"
            << " gas can have; p must be above " << vacuum << ". Look at what draws the gas, at 0/p, at the"
            << " reference pressure in constant/transportProperties and at deltaT" << exit(FatalError);
    }
}
