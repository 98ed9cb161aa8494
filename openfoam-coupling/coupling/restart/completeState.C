// SPDX-License-Identifier: GPL-3.0-or-later
#include "completeState.H"

#include "IFstream.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "argList.H"
#include "dictionary.H"

#include "coupling/fromFirstRank.H"
#include "keptState.H"

#include <algorithm>
#include <string>

namespace
{

Foam::fileName markOf(const Foam::fileName& path, const Foam::instant& when)
{
    return path/when.name()/Foam::completeState::marker;
}

//- The time folders after a time in the folder `path` of the case, or of the rank, the earliest first
Foam::DynamicList<Foam::instant> laterTimes(const Foam::fileName& path, const Foam::scalar time)
{
    Foam::DynamicList<Foam::instant> later;
    for (const Foam::instant& when : Foam::Time::findTimes(path))
    {
        if (when.name() != "constant" && when.value() > time)
        {
            later.append(when);
        }
    }
    return later;
}

Foam::DynamicList<Foam::instant> laterTimes(const Foam::Time& time)
{
    return laterTimes(time.path(), time.startTime().value() + 0.5*time.deltaTValue());
}

//- Whether a folder holds fields that a case begins with: a run makes the folder 'uniform' before it writes a field.
//  A case at 0 begins anew, wherever its fields are from.
bool isInitial(const Foam::fileName& path, const Foam::instant& when)
{
    const bool isWritten = when.value() != 0 && Foam::isDir(path/when.name()/"uniform");
    return Foam::isFile(path/when.name()/"U", true) && !isWritten;
}

//- The times of initial fields by the first rank's folders, the same on all ranks
Foam::DynamicList<Foam::instant> initialTimes(const Foam::fileName& path)
{
    Foam::DynamicList<Foam::instant> initial;
    // All ranks call it: some of OpenFOAM's file handlers communicate.
    const Foam::DynamicList<Foam::instant> all(laterTimes(path, -Foam::GREAT));
    if (Foam::Pstream::master())
    {
        for (const Foam::instant& when : all)
        {
            if (isInitial(path, when))
            {
                initial.append(when);
            }
        }
    }
    Foam::fromFirstRank(initial);
    return initial;
}

//- The complete times by the first rank's folders, the same on all ranks
Foam::DynamicList<Foam::instant> completeTimes(const Foam::fileName& path)
{
    Foam::DynamicList<Foam::instant> complete;
    // All ranks call it: some of OpenFOAM's file handlers communicate.
    const Foam::DynamicList<Foam::instant> all(laterTimes(path, -Foam::GREAT));
    if (Foam::Pstream::master())
    {
        for (const Foam::instant& when : all)
        {
            if (Foam::isFile(markOf(path, when)))
            {
                complete.append(when);
            }
        }
    }
    Foam::fromFirstRank(complete);
    return complete;
}

//- Whether system/controlDict asks for the latest time, found without a Time: that one would stop where the ranks
//  differ in their latest folder, as they may after a run was killed in a step that is written
bool startsFromLatest(const Foam::argList& args)
{
    Foam::label latest = 0;
    Foam::IFstream file(args.globalPath()/"system"/Foam::Time::controlDictName);
    if (file.good())
    {
        latest =
            Foam::dictionary(file).getOrDefault<Foam::word>("startFrom", "latestTime") == "latestTime";
    }
    Foam::fromFirstRank(latest);
    return latest;
}

Foam::fileName asideName(const Foam::fileName& path, const Foam::instant& when, const Foam::label copy)
{
    const Foam::fileName name(path/("incomplete-" + when.name()));
    return copy > 1 ? Foam::fileName(name + "." + Foam::name(copy)) : name;
}

//- Renames the folders, to names that none has had before on any rank
void setAside(const Foam::fileName& path, const Foam::UList<Foam::instant>& folders)
{
    const auto taken = [&](const Foam::label copy)
    {
        bool any = false;
        for (const Foam::instant& when : folders)
        {
            any = any || Foam::exists(asideName(path, when, copy));
        }
        return Foam::returnReduce(any, Foam::orOp<bool>());
    };
    Foam::label copy = 1;
    while (taken(copy))
    {
        ++copy;
    }
    for (const Foam::instant& when : folders)
    {
        if (!Foam::mv(path/when.name(), asideName(path, when, copy)))
        {
            FatalErrorInFunction
                << "cannot rename " << path/when.name() << ", an incomplete time, to "
                << asideName(path, when, copy) << Foam::exit(Foam::FatalError);
        }
    }
}

} // End anonymous namespace


void Foam::completeState::setAsideIncomplete(const argList& args)
{
    if (!startsFromLatest(args))
    {
        return;
    }
    keptState::restore(args.path(), completeTimes(args.path()));
    const DynamicList<instant> complete(completeTimes(args.path()));
    const DynamicList<instant> initial(initialTimes(args.path()));
    const instant last =
        complete.size() ? complete.last() : initial.size() ? initial.last() : instant(0, "0");
    const DynamicList<instant> later(laterTimes(args.path(), last.value() + SMALL*mag(last.value())));
    const label folders = returnReduce(later.size(), maxOp<label>());
    if (!folders)
    {
        return;
    }
    if (complete.empty() && !args.found("overwrite"))
    {
        FatalErrorInFunction
            << "the case " << args.globalPath() << " has time folders after " << last.name() << ", " << folders
            << " of them, but none with '" << marker << "': no time that a run could be continued from"
            << nl
            << "    Remove them (Allclean), run in a copy of the case, or give the option -overwrite:"
            << " they are then renamed to incomplete-<time>, and the run starts at " << last.name()
            << exit(FatalError);
    }
    setAside(args.path(), later);
    Info<< "Time folders after " << last.name() << " are incomplete and now called incomplete-<time>"
        << nl << endl;
}


void Foam::completeState::prepareStart(const Time& time, const bool overwrite)
{
    requireCompleteStart(time);
    requireTwoKeptTimes(time);
    warnOfFewDigits(time);
    if (overwrite)
    {
        unmarkLaterTimes(time);
    }
    else
    {
        requireNoLaterTimes(time);
    }
}


bool Foam::completeState::isComplete(const Time& time)
{
    // All ranks get what the first one has.
    label complete = isFile(markOf(time.path(), instant(time.value(), time.timeName())));
    fromFirstRank(complete);
    return complete;
}


void Foam::completeState::requireCompleteStart(const Time& time)
{
    const auto atStart = [&](const instant& when)
    {
        return mag(when.value() - time.value()) <= 0.5*time.deltaTValue();
    };
    const DynamicList<instant> complete(completeTimes(time.path()));
    const DynamicList<instant> initial(initialTimes(time.path()));
    const bool begins = std::any_of(initial.begin(), initial.end(), atStart);
    if (begins || std::any_of(complete.begin(), complete.end(), atStart) || time.value() == 0)
    {
        return;
    }
    std::string names;
    for (const instant& when : complete)
    {
        names += (names.empty() ? "" : ", ") + when.name();
    }
    std::string first;
    for (const instant& when : initial)
    {
        first += (first.empty() ? "" : ", ") + when.name();
    }
    label folder = isDir(time.timePath());
    fromFirstRank(folder);
    FatalErrorInFunction
        << "the run would start at time " << time.timeName() << ", where "
        << (folder ? "'" + std::string(marker) + "' is missing: that time has no complete state of gas and particles"
            : std::string("no folder of that name is")).c_str() << nl;
    if (names.size())
    {
        FatalError
            << "    Complete are " << names.c_str() << ": in system/controlDict use 'startFrom latestTime;' for the"
            << " last of them" << nl;
    }
    if (first.size())
    {
        FatalError
            << "    Fields to begin with are at " << first.c_str() << ": use 'startFrom startTime; startTime "
            << initial.first().name().c_str() << ";', or give that folder the name " << time.timeName()
            << " to begin at that time" << nl;
    }
    else
    {
        FatalError
            << "    To begin a case at that time put its fields in a folder " << time.timeName()
            << " without a folder 'uniform'" << nl;
    }
    FatalError<< exit(FatalError);
}


void Foam::completeState::requireTwoKeptTimes(const Time& time)
{
    if (time.controlDict().getOrDefault<label>("purgeWrite", 0) == 1)
    {
        FatalIOErrorInFunction(time.controlDict())
            << "purgeWrite = 1 removes the last complete time before the next one is complete: a run"
            << " that is ended in between could not be continued. Use 2 or more, or 0, which keeps"
            << " all" << exit(FatalIOError);
    }
}


void Foam::completeState::warnOfFewDigits(const Time& time)
{
    if (time.writeFormat() == IOstream::ASCII && IOstream::defaultPrecision() < 17)
    {
        IOWarningInFunction(time.controlDict())
            << "fields are written with " << IOstream::defaultPrecision() << " digits: a run that is"
            << " continued from them differs by that rounding from one that was never stopped. With"
            << " 'writeFormat binary;' or 'writePrecision 17;' it does not" << endl;
    }
}


void Foam::completeState::requireNoLaterTimes(const Time& time)
{
    const DynamicList<instant> later(laterTimes(time));
    const label folders = returnReduce(later.size(), maxOp<label>());
    if (!folders)
    {
        return;
    }
    const scalar first =
        returnReduce(later.size() ? later.first().value() : GREAT, minOp<scalar>());
    const scalar last = returnReduce(later.size() ? later.last().value() : -GREAT, maxOp<scalar>());
    FatalErrorInFunction
        << "the case " << time.path() << " already holds results after the start at "
        << time.timeName() << ", at " << folders << " times from " << Time::timeName(first) << " to "
        << Time::timeName(last) << nl
        << "    Remove them (Allclean), run in a copy of the case, give the option -overwrite,"
        << " or continue them with 'startFrom latestTime;' in system/controlDict"
        << exit(FatalError);
}


void Foam::completeState::unmarkLaterTimes(const Time& time)
{
    const DynamicList<instant> later(laterTimes(time));
    if (Pstream::master())
    {
        for (const instant& when : later)
        {
            rm(markOf(time.path(), when));
        }
        rm(keptState::folderIn(time.path())/marker);
    }
    // No rank writes a time that still has its mark.
    returnReduce(label(0), sumOp<label>());
}
