// SPDX-License-Identifier: GPL-3.0-or-later
#include "keptState.H"

#include "IFstream.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "dictionary.H"
#include "fileOperation.H"

#include "coupling/fromFirstRank.H"
#include "completeState.H"

#include <cstdio>

namespace
{

//- The share of the time that keeping states may take
constexpr Foam::scalar share = 0.01;

const char* const folder = "kept";

//- Removes a folder if it is there: OpenFOAM warns of one that is not. What is left of it after a kill is not complete.
void remove(const Foam::fileName& path)
{
    if (Foam::isDir(path))
    {
        Foam::rm(path/Foam::completeState::marker);
        Foam::rmDir(path);
    }
}

//- The time of the state that is kept in a folder, without a name where there is none
Foam::instant timeOf(const Foam::fileName& kept)
{
    const Foam::fileName time(kept/"uniform/time");
    if (!Foam::isFile(time))
    {
        return Foam::instant(-Foam::GREAT, "");
    }
    Foam::IFstream file(time);
    const Foam::dictionary entries(file);
    return Foam::instant(entries.get<Foam::scalar>("value"), entries.get<Foam::word>("name"));
}

//- The latest time of those that the ranks keep, without a name where there is none. Ranks differ where a run was
//  killed as it renamed the folders.
Foam::instant latestOfRanks(const Foam::instant& mine)
{
    Foam::List<Foam::instant> all(Foam::Pstream::nProcs());
    all[Foam::Pstream::myProcNo()] = mine;
    Foam::Pstream::gatherList(all);
    Foam::instant latest(mine);
    for (const Foam::instant& one : all)
    {
        if (one.value() > latest.value())
        {
            latest = one;
        }
    }
    Foam::fromFirstRank(latest);
    return latest;
}

} // End anonymous namespace


Foam::keptState::keptState(const Time& time)
:
    time_(time),
    // Each rank must have a folder of its own.
    possible_(fileHandler().type() == "uncollated")
{}


Foam::fileName Foam::keptState::folderIn(const fileName& path)
{
    return path/folder;
}


void Foam::keptState::restore(const fileName& path, const UList<instant>& complete)
{
    const fileName kept(folderIn(path));
    const instant mine(timeOf(kept));
    const instant latest(latestOfRanks(mine));
    if (latest.name().empty() || (complete.size() && complete.last().value() > latest.value()))
    {
        return;
    }
    const fileName time(path/latest.name());
    const bool isKept = mine.name() == latest.name();
    bool whole = isKept ? !exists(time) : isDir(time);
    if (Pstream::master())
    {
        whole = whole && isFile((isKept ? kept : time)/completeState::marker);
    }
    if (!returnReduce(whole, andOp<bool>()))
    {
        return;
    }
    if (isKept && std::rename(kept.c_str(), time.c_str()) != 0)
    {
        FatalErrorInFunction
            << "cannot rename " << kept << ", the last complete state, to " << time << exit(FatalError);
    }
    // No rank goes on before all have the time.
    returnReduce(label(0), sumOp<label>());
    Info<< "The last complete state is that of time " << latest.name() << ", which an earlier run had in the folder '"
        << folder << "': the run continues from it" << nl
        << "    To begin anew remove '" << folder << "' and all time folders but that of the initial fields; to"
        << " continue from a written time remove " << latest.name() << nl << endl;
}


Foam::List<Foam::keptState::Folders> Foam::keptState::everyones() const
{
    const fileName root(time_.globalPath());
    List<Folders> all(Pstream::parRun() ? Pstream::nProcs() : 1);
    forAll(all, rank)
    {
        const fileName own(Pstream::parRun() ? root/("processor" + Foam::name(rank)) : root);
        all[rank] = Folders{own/folder, own/name_};
    }
    return all;
}


bool Foam::keptState::due() const
{
    // What has been written as a time already needs no keeping.
    label due = possible_ && since_.elapsedTime()*share >= cost_ && !exists(time_.timePath());
    fromFirstRank(due);
    return due;
}


void Foam::keptState::keep(const std::function<void()>& write)
{
    const clockTime timer;
    try
    {
        write();
    }
    catch (...)
    {
        remove(time_.timePath());
        throw;
    }
    const fileName kept(time_.path()/folder);
    remove(kept);
    std::rename(time_.timePath().c_str(), kept.c_str());
    name_ = time_.timeName();
    cost_ = timer.elapsedTime();
    since_ = clockTime();
}


void Foam::keptState::drop()
{
    remove(time_.path()/folder);
    name_.clear();
    since_ = clockTime();
}


void Foam::keptState::end()
{
    if (name_.size())
    {
        drop();
    }
}


void Foam::keptState::release()
{
    if (name_.empty())
    {
        return;
    }
    // Another rank may do the same meanwhile: the first one does it.
    bool first = false;
    for (const Folders& folders : everyones())
    {
        first = std::rename(folders.kept.c_str(), folders.time.c_str()) == 0 || first;
    }
    if (first)
    {
        Serr<< nl << "The last complete state, that of time " << name_ << ", has been written: 'startFrom latestTime;'"
            << " in system/controlDict continues from it" << nl << endl;
    }
    name_.clear();
}
