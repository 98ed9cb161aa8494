// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleMovement.H"

#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"

#include "coupling/exchange/meshCells.H"
#include "coupling/input/readPositive.H"

#include <limits>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(particleMovement, 0);
    addToRunTimeSelectionTable(functionObject, particleMovement, dictionary);
}
}


Foam::functionObjects::particleMovement::particleMovement
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    particleFunctionObject(name, runTime, dict),
    interval_(0),
    before_(folder()/"places"),
    images_(1, vector::zero)
{
    read(dict);
    writeCommented(file(), "Time");
    for (const char* column : {"over [s]", "mean [m]", "x rms [m]", "y rms [m]", "z rms [m]", "particles"})
    {
        writeTabbed(file(), column);
    }
    file() << endl;
    active();
}


bool Foam::functionObjects::particleMovement::read(const dictionary& dict)
{
    particleFunctionObject::read(dict);
    warnOfUnknown(dict, {{"interval"}});
    interval_ = readPositive(dict, "interval");
    return true;
}


void Foam::functionObjects::particleMovement::startInterval()
{
    before_.store(time_.value(), time_.timeName(), particles().ids(), particles().positions());
}


void Foam::functionObjects::particleMovement::begin()
{
    images_ = particles().images();
    if (!before_.restore(pastUntil()))
    {
        startInterval();
    }
    Info<< name() << ": the interval begins at " << before_.time() << " s" << endl;
}


void Foam::functionObjects::particleMovement::writeMovement()
{
    const UList<point> positions(particles().positions());
    const UList<int> ids(particles().ids());
    scalar distance = 0;
    vector squares = Zero;
    label n = 0;
    forAll(positions, i)
    {
        const label index = before_.index(ids[i]);
        if (index >= 0)
        {
            vector moved = positions[i] - before_.positions()[index];
            moved += meshCells::minimumImageShift(images_, moved);
            distance += mag(moved);
            squares += cmptMultiply(moved, moved);
            ++n;
        }
    }
    reduce(distance, sumOp<scalar>());
    reduce(squares, sumOp<vector>());
    reduce(n, sumOp<label>());

    const scalar share = n ? 1.0/n : std::numeric_limits<scalar>::quiet_NaN();
    writeCurrentTime(file());
    file() << tab << time_.value() - before_.time() << tab << distance*share;
    for (direction d = 0; d < 3; ++d)
    {
        file() << tab << ::sqrt(squares[d]*share);
    }
    file() << tab << n << endl;
}


bool Foam::functionObjects::particleMovement::execute()
{
    if (!active())
    {
        return true;
    }
    if (time_.value() - before_.time() > interval_ - 0.5*time_.deltaTValue())
    {
        writeMovement();
        startInterval();
    }
    // Up to this time the run is complete: it is not continued from before.
    if (time_.writeTime())
    {
        before_.removeEarlier();
    }
    return true;
}
