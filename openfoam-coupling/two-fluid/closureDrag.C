// SPDX-License-Identifier: GPL-3.0-or-later
#include "closureDrag.H"

#include "phasePair.H"

#include "coupling/input/knownEntries.H"
#include "coupling/input/readDragLaw.H"
#include "two-fluid/addRows.H"
#include "two-fluid/eachValue.H"

namespace
{

using namespace Foam;

template<std::size_t Row>
struct rowDrag
:
    dragModels::closureDrag
{
    rowDrag(const dictionary& dict, const phasePair& pair, const bool registerObject)
    :
        closureDrag(cohesion::drag::closures[Row], dict, pair, registerObject)
    {}
};

template<std::size_t Row>
struct closureEntry
{
    using type = dragModel::addRemovabledictionaryConstructorToTable<rowDrag<Row>>;

    static constexpr std::string_view name()
    {
        return cohesion::drag::closures[Row].name;
    }
};

//- What the model reads, and what the solver does of any model of drag
const Keywords words
{
    {"type"}, {"dragFactor"}, {"dragExponent"}, {"dragCoefficient"}, {"filter"}, {"swarmCorrection"}, {"residualRe"},
    {"residualAlpha"}
};

const addRows<closureEntry, cohesion::drag::closures.size()> added;

} // End anonymous namespace


Foam::dragModels::closureDrag::closureDrag
(
    const cohesion::drag::Closure& closure,
    const dictionary& dict,
    const phasePair& pair,
    const bool registerObject
)
:
    dragModel(dict, pair, registerObject),
    law_(readDragLaw(dict, closure)),
    filter_(dict, pair)
{
    warnOfUnknownEntries(dict, words);
}


Foam::tmp<Foam::volScalarField> Foam::dragModels::closureDrag::CdRe() const
{
    const phaseModel& gas = pair_.continuous();
    const scalar leastGas = gas.residualAlpha().value();
    const auto scaled = [&](const scalar solid, const scalar slip, const scalar d, const scalar rho, const scalar mu)
    {
        const scalar voidFraction = max(1 - solid, leastGas);
        return law_.per_solid_volume(voidFraction, slip, d, rho, mu)*sqr(d)/(0.75*mu);
    };
    tmp<volScalarField> drag = eachValue
    (
        "CdRe",
        dimless,
        scaled,
        pair_.dispersed(),
        pair_.magUr()(),
        pair_.dispersed().d()(),
        gas.rho(),
        gas.mu()()
    );
    if (filter_.active())
    {
        drag.ref() *= filter_.factor(pair_);
    }
    return drag;
}
