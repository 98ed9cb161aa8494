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

#include <algorithm>
#include <string>

namespace
{

//- Whether a file that OpenFOAM has written is whole: where it begins with OpenFOAM's banner it ends with a line like
//  that. fieldAverage does not say whether it could write, and nothing says what fails as a file is closed.
bool isWhole(const Foam::fileName& path)
{
    Foam::IFstream file(path);
    std::string begin;
    std::string end;
    std::string block(1 << 16, 0);
    while (file.good() && file.stdStream().read(&block[0], block.size()).gcount() > 0)
    {
        end.append(block, 0, file.stdStream().gcount());
        begin = begin.empty() ? end.substr(0, 4) : begin;
        end.erase(0, end.size() - std::min<std::size_t>(end.size(), 100));
    }
    end.erase(end.find_last_not_of('\n') + 1);
    return begin.size() && (begin != "/*--" || (end.size() > 5 && end.compare(end.size() - 5, 5, "** //") == 0));
}

//- Whether the files of this rank in a time folder are whole, with the state of the function objects
bool areWhole(const Foam::fileName& folder)
{
    bool whole = true;
    for (const Foam::fileName& part : {folder, folder/"uniform", folder/"uniform/functionObjects"})
    {
        for (const Foam::fileName& name : Foam::readDir(part, Foam::fileName::FILE))
        {
            whole = whole && isWhole(part/name);
        }
    }
    return whole;
}

} // End anonymous namespace


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
    // All ranks take part in each: none is left out where another failed.
    const bool stateWritten = writeFunctionObjectState(time);
    const bool timeWritten = time.writeTimeDict();
    const objectRegistry& registry = time;
#if OPENFOAM >= 2012
    const bool fieldsWritten = registry.objectRegistry::writeObject(time.writeStreamOption(), true);
#else
    const bool fieldsWritten = registry.objectRegistry::writeObject
    (
        time.writeFormat(), IOstream::currentVersion, time.writeCompression(), true
    );
#endif
    return stateWritten && timeWritten && fieldsWritten && areWhole(time.timePath());
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
