// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleDrag.H"

#include "coupling/input/selectRow.H"

using namespace cohesion;

namespace
{

drag::DragLaw readLaw(const Foam::dictionary& dict)
{
    const drag::Closure& closure = Foam::selectRow(dict, "drag", drag::closures);
    std::optional<double> exponent;
    if (dict.found("dragExponent"))
    {
        exponent = dict.get<Foam::scalar>("dragExponent");
    }
    try
    {
        return drag::DragLaw
        (
            closure,
            dict.getOrDefault<Foam::scalar>("dragFactor", 1),
            exponent
        );
    }
    catch (const InvalidParameter& error)
    {
        FatalIOErrorInFunction(dict) << error.what() << Foam::exit(Foam::FatalIOError);
        throw;
    }
}

} // End anonymous namespace


Foam::particleDrag::particleDrag(const dictionary& dict, const scalar mu)
:
    law_(readLaw(dict)),
    mu_(mu)
{}
