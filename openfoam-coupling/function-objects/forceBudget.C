// SPDX-License-Identifier: GPL-3.0-or-later
#include "forceBudget.H"

#include "Map.H"
#include "Pstream.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"

#include "coupling/fromFirstRank.H"

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
    weight_(Zero),
    turnover_(Zero),
    number_(0),
    lastStep_(0)
{
    read(dict);
    warnOfUnknown(dict, {});
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


Foam::vectorField Foam::functionObjects::forceBudget::momenta() const
{
    const UList<vector> velocities(particles().velocities());
    const UList<scalar> masses(particles().masses());
    vectorField momenta(masses.size());
    forAll(momenta, i)
    {
        momenta[i] = masses[i]*velocities[i];
    }
    return momenta;
}


Foam::vector Foam::functionObjects::forceBudget::removedMomentum() const
{
    Map<vector> left(2*ids_.size());
    forAll(ids_, i)
    {
        left.insert(ids_[i], momenta_[i]);
    }
    const UList<int> ids(particles().ids());
    const List<bool> inserted(particles().inserted());
    DynamicList<label> elsewhere;
    forAll(ids, i)
    {
        if (!inserted[i] && !left.erase(ids[i]))
        {
            elsewhere.append(ids[i]);
        }
    }
    // Particles that are left have gone to other ranks, or have been removed.
    Pstream::mapCombineGather(left, plusEqOp<vector>());
    fromFirstRank(left);
    vector sum = Zero;
    for (const label id : elsewhere)
    {
        sum -= left[id];
    }
    reduce(sum, sumOp<vector>());
    forAllConstIters(left, one)
    {
        sum += one.val();
    }
    return sum;
}


void Foam::functionObjects::forceBudget::addTurnover()
{
    const List<bool> inserted(particles().inserted());
    const UList<scalar> masses(particles().masses());
    const vectorField now(momenta());
    vector insertedMomentum = Zero;
    scalar stayed = 0;
    label nInserted = 0;
    forAll(inserted, i)
    {
        if (inserted[i])
        {
            ++nInserted;
            insertedMomentum += now[i];
        }
        else
        {
            stayed += masses[i];
        }
    }
    reduce(nInserted, sumOp<label>());
    weight_ += returnReduce(stayed, sumOp<scalar>())*particles().g()*time_.deltaTValue();
    turnover_ += returnReduce(insertedMomentum, sumOp<vector>());
    if (number_ + nInserted > returnReduce(inserted.size(), sumOp<label>()))
    {
        turnover_ -= removedMomentum();
    }
}


void Foam::functionObjects::forceBudget::storeParticles()
{
    ids_ = labelList(particles().ids());
    momenta_ = momenta();
    number_ = returnReduce(ids_.size(), sumOp<label>());
}


void Foam::functionObjects::forceBudget::startRow()
{
    before_ = time_.value();
    momentumBefore_ = gSum(momenta());
    impulse_ = {Zero, Zero};
    weight_ = turnover_ = Zero;
}


void Foam::functionObjects::forceBudget::begin()
{
    startRow();
    storeParticles();
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
    addTurnover();
    storeParticles();
    return true;
}


bool Foam::functionObjects::forceBudget::write()
{
    const scalar over = time_.value() - before_;
    if (!active() || !(over > 0))
    {
        return true;
    }
    const vector gravity = weight_/over;
    const vector drag = returnReduce(impulse_.drag, sumOp<vector>())/over;
    const vector pressure = returnReduce(impulse_.pressure, sumOp<vector>())/over;
    const vector gain = (gSum(momenta()) - momentumBefore_ - turnover_)/over;
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
    startRow();
    return true;
}
