// SPDX-License-Identifier: GPL-3.0-or-later
#include "storedPositions.H"

#include "ListListOps.H"
#include "ListOps.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "UIndirectList.H"

#include "coupling/fromFirstRank.H"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <limits>
#include <string>

namespace
{

//- The lists of all ranks, one after the other, on the first rank
template<class Type>
Foam::List<Type> gathered(const Foam::UList<Type>& mine)
{
    Foam::List<Foam::List<Type>> parts(Foam::Pstream::nProcs());
    parts[Foam::Pstream::myProcNo()] = mine;
    Foam::Pstream::gatherList(parts);
    return Foam::ListListOps::combine<Foam::List<Type>>(parts, Foam::accessOp<Foam::List<Type>>());
}

} // End anonymous namespace


Foam::storedPositions::storedPositions(const fileName& folder)
:
    folder_(folder),
    time_(0)
{}


Foam::label Foam::storedPositions::index(const label id) const
{
    const auto found = std::lower_bound(ids_.begin(), ids_.end(), id);
    return found != ids_.end() && *found == id ? label(found - ids_.begin()) : -1;
}


void Foam::storedPositions::store
(
    const scalar time,
    const word& timeName,
    const UList<int>& ids,
    const UList<point>& positions
)
{
    labelList mine(ids.size());
    std::copy(ids.begin(), ids.end(), mine.begin());
    const labelList all(gathered<label>(mine));
    const List<point> allPositions(gathered<point>(positions));
    labelList order;
    sortedOrder(all, order);
    time_ = time;
    ids_ = UIndirectList<label>(all, order);
    positions_ = UIndirectList<point>(allPositions, order);
    if (Pstream::master())
    {
        write(timeName);
    }
    fromFirstRank(ids_);
    fromFirstRank(positions_);
}


void Foam::storedPositions::write(const word& timeName) const
{
    mkDir(folder_);
    const fileName file(folder_/timeName);
    const fileName unfinished(file + ".unfinished");
    std::ofstream os(unfinished);
    os << std::setprecision(std::numeric_limits<scalar>::max_digits10);
    os << "# Time " << time_ << ", " << ids_.size() << " particles: number, x, y, z [m]\n";
    forAll(ids_, i)
    {
        const point& at = positions_[i];
        os << ids_[i] << ' ' << at.x() << ' ' << at.y() << ' ' << at.z() << '\n';
    }
    os.close();
    // Under its final name the file is whole.
    if (!os || !mv(unfinished, file))
    {
        FatalErrorInFunction
            << "cannot write the particles' places to " << file << exit(FatalError);
    }
}


std::optional<Foam::scalar> Foam::storedPositions::timeOf(const fileName& file)
{
    std::ifstream is(file);
    std::string mark, word;
    scalar time = 0;
    is >> mark >> word >> time;
    return is && mark == "#" && word == "Time" ? std::optional(time) : std::nullopt;
}


void Foam::storedPositions::read(const fileName& file)
{
    std::ifstream is(file);
    std::string words;
    label n = 0;
    is >> words >> words >> time_ >> words >> n;
    std::getline(is, words);
    ids_.setSize(n);
    positions_.setSize(n);
    forAll(ids_, i)
    {
        is >> ids_[i] >> positions_[i].x() >> positions_[i].y() >> positions_[i].z();
    }
    if (!is)
    {
        FatalErrorInFunction
            << file << " does not hold the places of " << n << " particles; remove it, and the run"
            << " begins with the particles as they are" << exit(FatalError);
    }
}


bool Foam::storedPositions::restore(const scalar time)
{
    label found = 0;
    if (Pstream::master())
    {
        fileName last;
        for (const fileName& name : readDir(folder_, fileName::FILE))
        {
            const fileName file(folder_/name);
            const auto then = timeOf(file);
            if (name.hasExt("unfinished") || (then && *then > time))
            {
                rm(file);
            }
            else if (then && (last.empty() || *then > timeOf(last)))
            {
                last = file;
            }
        }
        found = !last.empty();
        if (found)
        {
            read(last);
        }
    }
    fromFirstRank(found);
    fromFirstRank(time_);
    fromFirstRank(ids_);
    fromFirstRank(positions_);
    return found;
}


void Foam::storedPositions::removeEarlier() const
{
    if (Pstream::master())
    {
        for (const fileName& name : readDir(folder_, fileName::FILE))
        {
            const auto then = timeOf(folder_/name);
            if (then && *then < time_)
            {
                rm(folder_/name);
            }
        }
    }
}
