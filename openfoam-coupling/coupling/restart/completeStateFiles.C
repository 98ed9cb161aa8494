// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a complete time, beside the fields, and its mark.
#include "completeState.H"

#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "dictionary.H"

#include "coupling/fromFirstRank.H"
#include "functionObjectState.H"


Foam::fileName Foam::completeState::restartFile(const Time& time)
{
    fileName file(time.timePath()/"uniform/particles.restart");
    fromFirstRank(file);
    return file;
}


Foam::fileName Foam::completeState::engineFile(const Time& time)
{
    fileName file(time.path()/"particles.restart");
    fromFirstRank(file);
    return file;
}


bool Foam::completeState::writeFields(const Time& time)
{
    writeFunctionObjectState(time);
    const objectRegistry& registry = time;
    return
        time.writeTimeDict()
#if OPENFOAM >= 2012
     && registry.objectRegistry::writeObject(time.writeStreamOption(), true);
#else
     && registry.objectRegistry::writeObject
        (
            time.writeFormat(), IOstream::currentVersion, time.writeCompression(), true
        );
#endif
}


void Foam::completeState::mark
(
    const Time& time,
    const int64_t engineSteps,
    const bool written,
    const std::optional<scalar> writtenFrom
)
{
    const fileName from(engineFile(time));
    const fileName to(restartFile(time));
    // This waits for all ranks.
    bool complete = returnReduce(written, andOp<bool>());
    if (complete && Pstream::master())
    {
        const fileName marked(time.timePath()/marker);
        const fileName part(marked + ".part");
        mkDir(marked.path());
        complete = mv(from, to);
        {
            OFstream file(part);
            file.precision(17);
            file.writeEntry("engineSteps", engineSteps);
            if (writtenFrom)
            {
                file.writeEntry("writtenFrom", *writtenFrom);
            }
            file.flush();
            complete = complete && file.good();
        }
        complete = complete && mv(part, marked);
    }
    if (!returnReduce(complete, andOp<bool>()))
    {
        FatalErrorInFunction
            << "time " << time.timeName() << " could not be written in full and stays without '"
            << marker << "'" << nl
            << "    See whether the disk is full and the case's folder can be written to; 'startFrom"
            << " latestTime;' in system/controlDict then continues from the last complete time"
            << exit(FatalError);
    }
}


Foam::scalar Foam::completeState::writtenFrom(const Time& time)
{
    scalar from = time.startTime().value();
    if (isComplete(time) && Pstream::master())
    {
        IFstream file(time.timePath()/marker);
        dictionary(file).readIfPresent("writtenFrom", from);
    }
    fromFirstRank(from);
    return from;
}


int64_t Foam::completeState::engineSteps(const Time& time)
{
    int64_t steps = 0;
    if (Pstream::master())
    {
        IFstream file(time.timePath()/marker);
        steps = dictionary(file).get<int64_t>("engineSteps");
    }
    fromFirstRank(steps);
    return steps;
}
