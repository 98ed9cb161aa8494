// SPDX-License-Identifier: GPL-3.0-or-later
#include "rowRadial.H"

#include "two-fluid/addRows.H"
#include "two-fluid/eachValue.H"

namespace
{

using namespace Foam;
using cohesion::kinetic_theory::radial_functions;

template<std::size_t Row>
struct radialOfRow
:
    kineticTheoryModels::rowRadial
{
    explicit radialOfRow(const dictionary& dict)
    :
        rowRadial(radial_functions[Row], dict)
    {}
};

template<std::size_t Row>
struct radialEntry
{
    using type = kineticTheoryModels::radialModel::addRemovabledictionaryConstructorToTable<radialOfRow<Row>>;

    static constexpr std::string_view name()
    {
        return radial_functions[Row].name;
    }
};

const addRows<radialEntry, radial_functions.size()> added;

} // End anonymous namespace


Foam::kineticTheoryModels::rowRadial::rowRadial
(
    const cohesion::kinetic_theory::RadialFunction& function,
    const dictionary& dict
)
:
    radialModel(dict),
    function_(function)
{
    requireBelowDivergence(dict.get<scalar>("alphaMax"));
}


void Foam::kineticTheoryModels::rowRadial::requireBelowDivergence(const scalar alphaMax) const
{
    if (!(alphaMax < function_.largest_fraction))
    {
        FatalIOErrorInFunction(dict_)
            << "alphaMax = " << alphaMax << ": radialModel " << function_.name.data() << " diverges at a solid fraction"
            << " of " << function_.largest_fraction << ", take an alphaMax below it" << exit(FatalIOError);
    }
}


Foam::tmp<Foam::volScalarField> Foam::kineticTheoryModels::rowRadial::values
(
    const word& name,
    double (*function)(double),
    const volScalarField& alpha,
    const dimensionedScalar& alphaMax
) const
{
    const scalar highest = alphaMax.value();
    // It may have been given anew since the start.
    requireBelowDivergence(highest);
    const auto within = [&](const scalar solid) { return function(min(max(solid, scalar(0)), highest)); };
    return eachValue(name, dimless, within, alpha);
}


Foam::tmp<Foam::volScalarField> Foam::kineticTheoryModels::rowRadial::g0
(
    const volScalarField& alpha,
    const dimensionedScalar&,
    const dimensionedScalar& alphaMax
) const
{
    return values("g0", function_.contact_value, alpha, alphaMax);
}


Foam::tmp<Foam::volScalarField> Foam::kineticTheoryModels::rowRadial::g0prime
(
    const volScalarField& alpha,
    const dimensionedScalar&,
    const dimensionedScalar& alphaMax
) const
{
    return values("g0prime", function_.slope, alpha, alphaMax);
}
