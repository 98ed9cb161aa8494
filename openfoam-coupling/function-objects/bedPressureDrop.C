// SPDX-License-Identifier: GPL-3.0-or-later
#include "bedPressureDrop.H"

#include "addToRunTimeSelectionTable.H"
#include "surfaceFields.H"
#include "volFields.H"
#include "wordRes.H"

#include "sphere.h"

#include "coupling/fromFirstRank.H"
#include "coupling/sixDigits.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(bedPressureDrop, 0);
    addToRunTimeSelectionTable(functionObject, bedPressureDrop, dictionary);
}
}


Foam::functionObjects::bedPressureDrop::bedPressureDrop
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    particleFunctionObject(name, runTime, dict),
    up_(Zero),
    area_(0),
    over_(0),
    velocity_(0),
    drop_(0),
    lastStep_(0)
{
    read(dict);
    writeCommented(file(), "Time");
    for (const char* column : {"over [s]", "velocity [m/s]", "drop [Pa]", "weight [Pa]", "drop over weight [1]"})
    {
        writeTabbed(file(), column);
    }
    file() << endl;
    active();
}


bool Foam::functionObjects::bedPressureDrop::read(const dictionary& dict)
{
    particleFunctionObject::read(dict);
    warnOfUnknown(dict, {{"inlets"}, {"direction"}});
    if (!present())
    {
        return true;
    }
    up_ = readDirection(dict);
    inlets_ = dict.found("inlets") ? readPatches(dict, "inlets") : labelList();
    setArea(dict);
    return true;
}


Foam::labelList Foam::functionObjects::bedPressureDrop::readPatches
(
    const dictionary& dict,
    const word& entry
) const
{
    const wordRes names(dict.get<wordRes>(entry));
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    DynamicList<label> chosen;
    DynamicList<word> valid;
    string all;
    for (label patchi = 0; patchi < patches.nNonProcessor(); ++patchi)
    {
        if (patches[patchi].coupled())
        {
            continue;
        }
        valid.append(patches[patchi].name());
        all += (all.empty() ? "" : " ") + valid.last();
        if (names.match(valid.last()))
        {
            chosen.append(patchi);
        }
    }
    for (const wordRe& name : names)
    {
        if (!wordRes({name}).matching(valid).size())
        {
            FatalIOErrorInFunction(dict)
                << this->name() << ": " << entry << ": '" << name.c_str() << "' is no patch of the mesh; it has "
                << '(' << all.c_str() << ')' << exit(FatalIOError);
        }
    }
    return labelList(chosen);
}


void Foam::functionObjects::bedPressureDrop::setArea(const dictionary& dict)
{
    // Corners may be written with six digits, and a snapped mesh follows a wall to some per cent.
    constexpr scalar rounding = 1e-3, snapped = 0.05;
    const Column of(column(up_));
    area_ = of.foot;
    if (of.variation() > snapped)
    {
        FatalIOErrorInFunction(dict)
            << name() << ": the mesh is no column of one cross-section along direction " << up_
            << ": its faces that face against it have " << sixDigits(of.foot).c_str() << " m2 as seen"
            << " along it, and its volume over its height is " << of.mean << " m2; give the axis of the"
            << " column as direction. Where the cross-section changes, or the column is periodic along its axis,"
            << " use OpenFOAM's surfaceFieldValue for the drop between patches" << exit(FatalIOError);
    }
    if (of.variation() > rounding)
    {
        area_ = of.mean;
        IOWarningInFunction(dict)
            << name() << ": the cross-section of the mesh varies along direction " << up_ << ": its faces that face"
            << " against it have " << sixDigits(of.foot).c_str() << " m2 as seen along it. The columns refer to the"
            << " mean cross-section, " << sixDigits(of.mean).c_str() << " m2" << endl;
    }
}


void Foam::functionObjects::bedPressureDrop::begin()
{
    lastStep_ = time_.timeIndex();
}


Foam::scalar Foam::functionObjects::bedPressureDrop::superficialVelocity() const
{
    const auto& flux = mesh_.lookupObject<surfaceScalarField>("voidFractionPhi").boundaryField();
    scalarList in(mesh_.boundaryMesh().nNonProcessor(), Zero);
    forAll(in, patchi)
    {
        if (!flux[patchi].coupled())
        {
            in[patchi] = -sum(flux[patchi]);
        }
    }
    Pstream::listCombineGather(in, plusEqOp<scalar>());
    fromFirstRank(in);

    scalar all = 0;
    if (inlets_.size())
    {
        all = sum(scalarList(in, inlets_));
    }
    else
    {
        for (const scalar through : in)
        {
            all += max(through, scalar(0));
        }
    }
    return all/area_;
}


Foam::scalar Foam::functionObjects::bedPressureDrop::meanDensity() const
{
    const gasDensity& density = particles().density();
    const scalar reference = density.reference().value();
    return density.ideal() ? reference*density.ratio().weightedAverage(mesh_.V()).value() : reference;
}


Foam::scalar Foam::functionObjects::bedPressureDrop::drop() const
{
    // The gradient is that of the pressure over the reference density.
    const vectorField& gradP = mesh_.lookupObject<volVectorField>("gradP");
    const scalar risen = gSum(mesh_.V()*(gradP & up_))*particles().density().reference().value();
    const scalar gas = meanDensity()*gSum(mesh_.V())*(particles().g() & up_);
    return (gas - risen)/area_;
}


Foam::scalar Foam::functionObjects::bedPressureDrop::weight() const
{
    scalar volume = 0;
    for (const scalar radius : particles().radii())
    {
        volume += cohesion::sphere_volume(radius);
    }
    reduce(volume, sumOp<scalar>());
    const scalar mass = gSum(particles().masses()) - meanDensity()*volume;
    return mass*(particles().g() & -up_)/(area_*particles().depthRatio());
}


bool Foam::functionObjects::bedPressureDrop::execute()
{
    if (!active() || time_.timeIndex() == lastStep_)
    {
        return true;
    }
    lastStep_ = time_.timeIndex();
    const scalar dt = time_.deltaTValue();
    over_ += dt;
    velocity_ += superficialVelocity()*dt;
    drop_ += drop()*dt;
    return true;
}


bool Foam::functionObjects::bedPressureDrop::write()
{
    if (!active() || !(over_ > 0))
    {
        return true;
    }
    const scalar pressure = drop_/over_;
    const scalar carried = weight();
    // Along a horizontal axis, and without particles, there is no weight to be carried.
    const vector& g = particles().g();
    const bool heavy = mag(g & up_) > 1e-9*mag(g) && mag(carried) > 0;

    writeCurrentTime(file());
    file() << tab << over_ << tab << velocity_/over_ << tab << pressure << tab << carried << tab;
    heavy ? file() << pressure/carried : file() << "nan";
    file() << endl;
    over_ = velocity_ = drop_ = 0;
    return true;
}
