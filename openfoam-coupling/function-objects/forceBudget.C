// SPDX-License-Identifier: GPL-3.0-or-later
#include "forceBudget.H"

#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(forceBudget, 0);
    addToRunTimeSelectionTable(functionObject, forceBudget, dictionary);
}
}


Foam::functionObjects::forceBudget::forceBudget
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    particleFunctionObject(name, runTime, dict),
    before_(0),
    momentumBefore_(Zero),
    impulse_{Zero, Zero},
    lastStep_(0)
{
    read(dict);
    writeCommented(file(), "Time");
    writeTabbed(file(), "over [s]");
    for (const char* force : {"gravity", "drag", "pressure", "others", "gain"})
    {
        for (direction d = 0; d < 3; ++d)
        {
            writeTabbed(file(), string(force) + ' ' + vector::componentNames[d] + " [N]");
        }
    }
    file() << endl;
    active();
}


Foam::vector Foam::functionObjects::forceBudget::momentum() const
{
    const UList<vector> velocities(particles().velocities());
    const UList<scalar> masses(particles().masses());
    vector sum = Zero;
    forAll(masses, i)
    {
        sum += masses[i]*velocities[i];
    }
    return returnReduce(sum, sumOp<vector>());
}


Foam::scalar Foam::functionObjects::forceBudget::mass() const
{
    return gSum(particles().masses());
}


void Foam::functionObjects::forceBudget::restart()
{
    before_ = time_.value();
    momentumBefore_ = momentum();
    impulse_ = {Zero, Zero};
}


void Foam::functionObjects::forceBudget::begin()
{
    restart();
    lastStep_ = time_.timeIndex();
}


bool Foam::functionObjects::forceBudget::execute()
{
    if (!active() || time_.timeIndex() == lastStep_)
    {
        return true;
    }
    if (time_.timeIndex() != lastStep_ + 1)
    {
        FatalErrorInFunction
            << name() << ": the gas step " << lastStep_ + 1 << " was left out, and the forces in it are"
            << " not known: let it be executed in every step, without executeControl and"
            << " executeInterval, and set the rows by writeControl and writeInterval"
            << exit(FatalError);
    }
    lastStep_ = time_.timeIndex();
    const auto felt = particles().gasImpulse();
    impulse_.drag += felt.drag;
    impulse_.pressure += felt.pressure;
    return true;
}


bool Foam::functionObjects::forceBudget::write()
{
    const scalar over = time_.value() - before_;
    if (!active() || !(over > 0))
    {
        return true;
    }
    const vector gravity = mass()*particles().g();
    const vector drag = returnReduce(impulse_.drag, sumOp<vector>())/over;
    const vector pressure = returnReduce(impulse_.pressure, sumOp<vector>())/over;
    const vector gain = (momentum() - momentumBefore_)/over;
    const vector others = gain - gravity - drag - pressure;

    writeCurrentTime(file());
    file() << tab << over;
    for (const vector& force : {gravity, drag, pressure, others, gain})
    {
        for (direction d = 0; d < 3; ++d)
        {
            file() << tab << force[d];
        }
    }
    file() << endl;
    restart();
    return true;
}
