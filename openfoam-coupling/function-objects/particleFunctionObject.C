// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleFunctionObject.H"

#include "Time.H"
#include "fvMesh.H"
#include "volFields.H"

namespace
{

//- What OpenFOAM reads of any function object, and of one that writes a file
const Foam::Keywords ofAll
{
    {"type"}, {"libs"}, {"functionObjectLibs"}, {"region"}, {"enabled"}, {"log"}, {"errors"}, {"timeStart"},
    {"timeEnd"}, {"executeControl"}, {"executeInterval"}, {"writeControl"}, {"writeInterval"}, {"outputControl"},
    {"outputInterval"}, {"controlMode"}, {"triggerStart"}, {"triggerEnd"}, {"deltaTCoeff"}, {"nStepsToStartTimeChange"},
    {"writePrecision"}, {"writeToFile"}, {"useUserTime"}, {"useNamePrefix"}, {"updateHeader"}
};

} // End anonymous namespace


Foam::functionObjects::particleFunctionObject::particleFunctionObject
(
    const word& name,
    const Time& runTime,
    const dictionary& dict,
    const bool table
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile
    (
        mesh_,
        name,
        dict.get<word>("type"),
        dict,
        table && mesh_.foundObject<coupledParticles>(coupledParticles::typeName)
    ),
    particles_(mesh_.cfindObject<coupledParticles>(coupledParticles::typeName)),
    timeStart_(-VGREAT)
{
    if (particles_ && !particles_->present())
    {
        particles_->whenPresent([this]() { active(); });
    }
    if (!particles_)
    {
        IOWarningInFunction(dict)
            << name << " does nothing: it needs the particles of a running cohesiveBedFoam" << endl;
    }
}


Foam::vector Foam::functionObjects::particleFunctionObject::readDirection(const dictionary& dict) const
{
    vector direction = particles_ ? -particles_->g() : vector(0, 0, 1);
    const bool given = dict.readIfPresent("direction", direction);
    if (mag(direction) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << name() << ": " << (given ? "direction = (0 0 0)" : "direction is missing and gravity is 0")
            << "; give the direction in which heights are measured, for instance (0 0 1)"
            << exit(FatalIOError);
    }
    // In messages 0 has no sign.
    return direction/mag(direction) + vector(Zero);
}


Foam::functionObjects::particleFunctionObject::Column Foam::functionObjects::particleFunctionObject::column
(
    const vector& up
) const
{
    scalar foot = 0;
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (!patch.coupled())
        {
            foot += sum(max(-(patch.Sf() & up), scalar(0)));
        }
    }
    reduce(foot, sumOp<scalar>());
    const scalarField corners(mesh_.points() & up);
    return {foot, gSum(mesh_.V().field())/(gMax(corners) - gMin(corners))};
}


void Foam::functionObjects::particleFunctionObject::warnOfUnknown(const dictionary& dict, const Keywords& own)
{
    Keywords words(own);
    words.insert(words.end(), ofAll.begin(), ofAll.end());
    warnOfUnknownEntries(dict, words);
}


bool Foam::functionObjects::particleFunctionObject::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    timeStart_ = -VGREAT;
    if (dict.readIfPresent("timeStart", timeStart_))
    {
        timeStart_ = time_.userTimeToTime(timeStart_);
    }
    return true;
}


bool Foam::functionObjects::particleFunctionObject::active()
{
    const bool active = particles_ && particles_->present() && time_.value() >= timeStart_ - 0.5*time_.deltaTValue();
    if (active && !begun_)
    {
        begun_ = true;
        begin();
    }
    return active;
}


bool Foam::functionObjects::particleFunctionObject::execute()
{
    active();
    return true;
}
