// SPDX-License-Identifier: GPL-3.0-or-later
#include "completeState.H"

#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "argList.H"
#include "dictionary.H"

#include <string>

namespace
{

const char* const mark_ = "uniform/completeState";

Foam::fileName markOf(const Foam::Time& time, const Foam::instant& when)
{
    return time.path()/when.name()/mark_;
}

//- By the first rank's folders, the same on all ranks
Foam::DynamicList<Foam::instant> completeTimes(const Foam::Time& time)
{
    Foam::DynamicList<Foam::instant> complete;
    if (Foam::Pstream::master())
    {
        for (const Foam::instant& when : time.times())
        {
            if (when.name() != time.constant() && Foam::isFile(markOf(time, when)))
            {
                complete.append(when);
            }
        }
    }
    Foam::Pstream::scatter(complete);
    return complete;
}

} // End anonymous namespace


void Foam::completeState::setAsideIncomplete(const argList& args)
{
    const Time time(Time::controlDictName, args);
    if (time.controlDict().getOrDefault<word>("startFrom", "latestTime") != "latestTime")
    {
        return;
    }
    const DynamicList<instant> complete(completeTimes(time));
    const instant last = complete.size() ? complete.last() : instant(0, "0");
    label moved = 0;
    for (const instant& when : time.times())
    {
        if (when.name() != time.constant() && when.value() > last.value()*(1 + SMALL))
        {
            const fileName aside(time.path()/("incomplete-" + when.name()));
            rmDir(aside, true);
            mv(time.path()/when.name(), aside);
            ++moved;
        }
    }
    if (returnReduce(moved, sumOp<label>()))
    {
        Info<< "Time folders after " << last.name() << " are incomplete and now called incomplete-<time>"
            << nl << endl;
    }
}


void Foam::completeState::checkStart(const Time& time)
{
    if (!(time.startTime().value() > 0))
    {
        return;
    }
    const DynamicList<instant> complete(completeTimes(time));
    std::string names = "0";
    for (const instant& when : complete)
    {
        if (mag(when.value() - time.value()) <= 0.5*time.deltaTValue())
        {
            return;
        }
        names += ", " + when.name();
    }
    FatalErrorInFunction
        << "the run would start at time " << time.timeName() << ", where '" << mark_
        << "' is missing: that time has no complete state of gas and particles" << nl
        << "    Complete are " << names.c_str() << ". In system/controlDict use 'startFrom"
        << " latestTime;' for the last complete one, or 'startFrom startTime; startTime 0;'"
        << exit(FatalError);
}


void Foam::completeState::unmarkAll(const Time& time)
{
    if (Pstream::master())
    {
        for (const instant& when : time.times())
        {
            if (when.name() != time.constant())
            {
                rm(markOf(time, when));
            }
        }
    }
}


Foam::fileName Foam::completeState::engineFile(const Time& time)
{
    fileName file(time.timePath()/"uniform/particles.restart");
    if (Pstream::master())
    {
        mkDir(file.path());
    }
    Pstream::scatter(file);
    return file;
}


void Foam::completeState::mark(const Time& time, const label engineSteps)
{
    // All ranks have written all.
    label here = 1;
    reduce(here, sumOp<label>());
    if (Pstream::master())
    {
        const fileName marked(time.timePath()/mark_);
        const fileName written(marked + ".part");
        {
            OFstream file(written);
            file.writeEntry("engineSteps", engineSteps);
        }
        mv(written, marked);
    }
}


Foam::label Foam::completeState::engineSteps(const Time& time)
{
    label steps = 0;
    if (Pstream::master())
    {
        IFstream file(time.timePath()/mark_);
        steps = dictionary(file).get<label>("engineSteps");
    }
    Pstream::scatter(steps);
    return steps;
}
