// SPDX-License-Identifier: GPL-3.0-or-later
#include "bedHeight.H"

#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

#include "bed/surface.h"

#include "coupling/fromFirstRank.H"
#include "coupling/input/readPositive.H"
#include "coupling/sixDigits.H"

#include <limits>
#include <vector>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(bedHeight, 0);
    addToRunTimeSelectionTable(functionObject, bedHeight, dictionary);
}
}


Foam::functionObjects::bedHeight::bedHeight
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    particleFunctionObject(name, runTime, dict),
    up_(Zero),
    bottom_(0),
    top_(0),
    layers_(0),
    limit_(0),
    restHeight_(0)
{
    read(dict);
    writeCommented(file(), "Time");
    writeTabbed(file(), "mean [m]");
    if (restHeight_ > 0)
    {
        writeTabbed(file(), "expansion [1]");
    }
    writeTabbed(file(), "surface [m]");
    writeTabbed(file(), "highest [m]");
    file() << endl;
    active();
}


bool Foam::functionObjects::bedHeight::read(const dictionary& dict)
{
    particleFunctionObject::read(dict);
    warnOfUnknown(dict, {{"layers"}, {"limit"}, {"restHeight"}, {"direction"}});
    up_ = readDirection(dict);
    layers_ = dict.get<label>("layers");
    limit_ = dict.getOrDefault<scalar>("limit", 0.75);
    restHeight_ = dict.found("restHeight") ? readPositive(dict, "restHeight") : 0;
    if (layers_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << name() << ": layers = " << layers_ << ": must be at least 1" << exit(FatalIOError);
    }
    if (!(limit_ > 0 && limit_ < 1))
    {
        FatalIOErrorInFunction(dict)
            << name() << ": limit = " << limit_ << ": must lie between 0 and 1" << exit(FatalIOError);
    }
    sortCells(dict);
    warnOfChangingSection(dict);
    return true;
}


void Foam::functionObjects::bedHeight::sortCells(const dictionary& dict)
{
    const scalarField corners(mesh_.points() & up_);
    bottom_ = gMin(corners);
    top_ = gMax(corners);

    layer_.setSize(mesh_.nCells());
    volumes_ = scalarList(layers_, Zero);
    forAll(layer_, celli)
    {
        const scalar height = (mesh_.C()[celli] & up_) - bottom_;
        layer_[celli] = min(label(height/(top_ - bottom_)*layers_), layers_ - 1);
        volumes_[layer_[celli]] += mesh_.V()[celli];
    }
    Pstream::listCombineGather(volumes_, plusEqOp<scalar>());
    fromFirstRank(volumes_);
    const label empty = volumes_.find(0);
    if (empty >= 0)
    {
        FatalIOErrorInFunction(dict)
            << name() << ": layers = " << layers_ << ": layer " << empty + 1 << " from the bottom, "
            << (top_ - bottom_)/layers_ << " m thick, holds no cell's centre; take layers that are"
            << " not thinner than cells" << exit(FatalIOError);
    }
}


void Foam::functionObjects::bedHeight::warnOfChangingSection(const dictionary& dict) const
{
    constexpr scalar some = 0.05;
    const Column of(column(up_));
    if (of.foot > 0 && of.variation() > some)
    {
        IOWarningInFunction(dict)
            << name() << ": the cross-section of the mesh changes along direction " << up_ << ": its faces that face"
            << " against it have " << sixDigits(of.foot).c_str() << " m2 as seen along it, and its volume over its"
            << " height is " << sixDigits(of.mean).c_str() << " m2. There 'mean' and 'expansion', which refer to a"
            << " column of one cross-section, are no height of the bed; use 'surface'. Heights begin at the lowest"
            << " point of the mesh, at " << bottom_ << " m" << endl;
    }
}


void Foam::functionObjects::bedHeight::begin()
{
    if (atStart() && !continued())
    {
        write();
    }
}


Foam::scalar Foam::functionObjects::bedHeight::meanHeight() const
{
    const UList<point> positions(particles().positions());
    const UList<scalar> masses(particles().masses());
    scalar moment = 0;
    scalar mass = 0;
    forAll(positions, i)
    {
        moment += masses[i]*((positions[i] & up_) - bottom_);
        mass += masses[i];
    }
    reduce(moment, sumOp<scalar>());
    reduce(mass, sumOp<scalar>());
    return mass > 0 ? 2*moment/mass : std::numeric_limits<scalar>::quiet_NaN();
}


Foam::scalar Foam::functionObjects::bedHeight::surfaceHeight() const
{
    const volScalarField& voidFraction = mesh_.lookupObject<volScalarField>("voidFraction");
    scalarList gas(layers_, Zero);
    forAll(layer_, celli)
    {
        gas[layer_[celli]] += voidFraction[celli]*mesh_.V()[celli];
    }
    Pstream::listCombineGather(gas, plusEqOp<scalar>());
    fromFirstRank(gas);

    std::vector<double> voidFractions;
    forAll(gas, layer)
    {
        voidFractions.push_back(gas[layer]/volumes_[layer]);
    }
    return cohesion::bed::surface_height(voidFractions, 0, (top_ - bottom_)/layers_, limit_);
}


Foam::scalar Foam::functionObjects::bedHeight::highest() const
{
    const UList<point> positions(particles().positions());
    const UList<scalar> radii(particles().radii());
    scalar highest = -VGREAT;
    forAll(positions, i)
    {
        highest = max(highest, (positions[i] & up_) + radii[i]);
    }
    reduce(highest, maxOp<scalar>());
    return highest > -VGREAT ? highest - bottom_ : std::numeric_limits<scalar>::quiet_NaN();
}


bool Foam::functionObjects::bedHeight::write()
{
    if (!active())
    {
        return true;
    }
    const scalar mean = meanHeight();
    const scalar surface = surfaceHeight();
    const scalar top = highest();

    writeCurrentTime(file());
    file() << tab << mean;
    if (restHeight_ > 0)
    {
        file() << tab << mean/restHeight_;
    }
    file() << tab << surface << tab << top << endl;
    return true;
}
