// SPDX-License-Identifier: GPL-3.0-or-later
#include "keptState.H"

#include "OSspecific.H"
#include "Pstream.H"
#include "Time.H"
#include "fileOperation.H"

#include "coupling/fromFirstRank.H"

#include <cstdio>

namespace
{

//- The share of the time that keeping states may take
constexpr Foam::scalar share = 0.01;

const char* const folder = "kept";

//- Removes a folder if it is there: OpenFOAM warns of one that is not.
void remove(const Foam::fileName& path)
{
    if (Foam::isDir(path))
    {
        Foam::rmDir(path);
    }
}

} // End anonymous namespace


Foam::keptState::keptState(const Time& time)
:
    time_(time),
    // Each rank must have a folder of its own.
    possible_(fileHandler().type() == "uncollated")
{
    remove(time_.path()/folder);
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
    if (name_.size())
    {
        remove(time_.path()/folder);
        name_.clear();
    }
    since_ = clockTime();
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
