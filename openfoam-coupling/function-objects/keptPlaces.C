// SPDX-License-Identifier: GPL-3.0-or-later
#include "keptPlaces.H"

#include "ListListOps.H"
#include "ListOps.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "UIndirectList.H"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <limits>
#include <string>

namespace
{

//- What all ranks have, one after the other, on the first rank
template<class Type>
Foam::List<Type> gathered(const Foam::UList<Type>& mine)
{
    Foam::List<Foam::List<Type>> parts(Foam::Pstream::nProcs());
    parts[Foam::Pstream::myProcNo()] = mine;
    Foam::Pstream::gatherList(parts);
    return Foam::ListListOps::combine<Foam::List<Type>>(parts, Foam::accessOp<Foam::List<Type>>());
}

} // End anonymous namespace


Foam::keptPlaces::keptPlaces(const fileName& folder)
:
    folder_(folder),
    time_(0)
{}


Foam::label Foam::keptPlaces::index(const label id) const
{
    const auto found = std::lower_bound(ids_.begin(), ids_.end(), id);
    return found != ids_.end() && *found == id ? label(found - ids_.begin()) : -1;
}


void Foam::keptPlaces::take
(
    const scalar time,
    const word& timeName,
    const UList<int>& ids,
    const UList<point>& places
)
{
    labelList mine(ids.size());
    std::copy(ids.begin(), ids.end(), mine.begin());
    const labelList all(gathered<label>(mine));
    const List<point> allPlaces(gathered<point>(places));
    labelList order;
    sortedOrder(all, order);
    time_ = time;
    ids_ = UIndirectList<label>(all, order);
    places_ = UIndirectList<point>(allPlaces, order);
    if (Pstream::master())
    {
        write(timeName);
    }
    Pstream::scatter(ids_);
    Pstream::scatter(places_);
}


void Foam::keptPlaces::write(const word& timeName) const
{
    mkDir(folder_);
    const fileName file(folder_/timeName);
    const fileName unfinished(file + ".unfinished");
    std::ofstream os(unfinished);
    os << std::setprecision(std::numeric_limits<scalar>::max_digits10);
    os << "# Time " << time_ << ", " << ids_.size() << " particles: number, x, y, z [m]\n";
    forAll(ids_, i)
    {
        const point& place = places_[i];
        os << ids_[i] << ' ' << place.x() << ' ' << place.y() << ' ' << place.z() << '\n';
    }
    os.close();
    // Under its name it is whole.
    if (!os || !mv(unfinished, file))
    {
        FatalErrorInFunction
            << "cannot write the particles' places to " << file << exit(FatalError);
    }
}


std::optional<Foam::scalar> Foam::keptPlaces::timeOf(const fileName& file)
{
    std::ifstream is(file);
    std::string mark, word;
    scalar time = 0;
    is >> mark >> word >> time;
    return is && mark == "#" && word == "Time" ? std::optional(time) : std::nullopt;
}


void Foam::keptPlaces::read(const fileName& file)
{
    std::ifstream is(file);
    std::string words;
    label n = 0;
    is >> words >> words >> time_ >> words >> n;
    std::getline(is, words);
    ids_.setSize(n);
    places_.setSize(n);
    forAll(ids_, i)
    {
        is >> ids_[i] >> places_[i].x() >> places_[i].y() >> places_[i].z();
    }
    if (!is)
    {
        FatalErrorInFunction
            << file << " does not hold the places of " << n << " particles; remove it, and the run"
            << " begins with the particles as they are" << exit(FatalError);
    }
}


bool Foam::keptPlaces::recall(const scalar time)
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
    Pstream::scatter(found);
    Pstream::scatter(time_);
    Pstream::scatter(ids_);
    Pstream::scatter(places_);
    return found;
}


void Foam::keptPlaces::forgetEarlier() const
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
