// SPDX-License-Identifier: GPL-3.0-or-later
#include "couplingDictionary.H"

#include "IFstream.H"
#include "OStringStream.H"
#include "Pstream.H"
#include "Time.H"

#include "nearest_name.h"

#include "coupling/fromFirstRank.H"
#include "coupling/input/knownEntries.H"
#include "dem-engines/load_dem_engine.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace
{

using Foam::Keyword;
using Foam::Keywords;
using Foam::isKnown;
using Foam::isMisspelt;
using Foam::list;

//- What the coupling reads, but for the dictionaries of the engines
const Keywords keywords
{
    {"demEngine"}, {"form"}, {"drag"}, {"dragFactor"}, {"dragExponent"}, {"dragCoefficient"}, {"dragMixture"},
    {"agglomerateDrag"}, {"dragFilter"}, {"coarseGraining"}, {"addedMass"}, {"lift"}, {"liftCoefficient"}, {"response"},
    {"slip"}, {"voidFraction"}, {"smoothingWidth"}, {"minVoidFraction"}, {"depth"}, {"particleGravity"}
};

//- What it reads of the dictionary of an engine
const Keywords engineKeywords{{"script"}, {"log"}, {"variables"}, {"library"}};


//- A dictionary's file as it was written: macros and directives are not carried out
Foam::dictionary asWritten(const Foam::fileName& file)
{
    const int before = Foam::entry::disableFunctionEntries;
    Foam::entry::disableFunctionEntries = 1;
    Foam::IFstream stream(file);
    const Foam::dictionary written(stream);
    Foam::entry::disableFunctionEntries = before;
    return written;
}


//- Whether the text refers to a name by $name, ${name} or $:name
bool isReferenced(const std::string& text, const std::string& name)
{
    for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$', at + 1))
    {
        const std::size_t start = text.find_first_not_of("{:.", at + 1);
        if (start == std::string::npos || text.compare(start, name.size(), name) != 0)
        {
            continue;
        }
        const std::size_t end = start + name.size();
        if (end == text.size() || !(std::isalnum(text[end]) || text[end] == '_'))
        {
            return true;
        }
    }
    return false;
}


//- Whether a pattern, "(lammps|liggghts)Coeffs", is for a known word
bool matches(const Foam::keyType& pattern, const Keywords& table)
{
    return std::any_of(table.begin(), table.end(), [&](const Keyword& word) { return pattern.match(word.name); });
}


//- The entries of a dictionary of the file that are not known, in words
struct UnknownEntries
{
    std::string misspelt;
    std::string unread;     // of the file itself, and not referred to in it

    UnknownEntries() = default;

    UnknownEntries
    (
        const Foam::dictionary& dict,
        const Foam::dictionary& written,
        const std::string& text,
        const Keywords& table
    )
    {
        for (const Foam::entry& entry : dict)
        {
            const Foam::keyType& key = entry.keyword();
            const bool here = written.found(key, Foam::keyType::LITERAL);
            if (isKnown(table, key) || (key.isPattern() && matches(key, table)) || (here && isReferenced(text, key)))
            {
                continue;
            }
            const std::string nearest(cohesion::nearest_name(table, key));
            const bool wrong = isMisspelt(key, nearest);
            if (wrong || here)
            {
                std::string& names = wrong ? misspelt : unread;
                names += (names.empty() ? "" : ", ") + Foam::unknownEntry(key, nearest);
            }
        }
    }
};


//- FatalIOError where an entry is misspelt; a warning where nothing reads one
void reportUnknown(const Foam::dictionary& dict, const UnknownEntries& unknown, const Keywords& table)
{
    Foam::string misspelt(unknown.misspelt);
    Foam::fromFirstRank(misspelt);
    if (misspelt.size())
    {
        FatalIOErrorInFunction(dict)
            << "unknown entry " << misspelt.c_str() << Foam::nl
            << "    Known are " << list(table).c_str() << Foam::nl
            << "    Entries of your own may have such names here if a $ takes them up here"
            << Foam::exit(Foam::FatalIOError);
    }
    if (unknown.unread.size())
    {
        IOWarningInFunction(dict)
            << "unknown entry " << unknown.unread.c_str() << ": nothing reads it, and no $ takes it up here"
            << Foam::nl << "    Known are " << list(table).c_str() << Foam::endl;
    }
}

} // End anonymous namespace


Foam::couplingDictionary::couplingDictionary(const objectRegistry& mesh)
:
    IOdictionary
    (
        IOobject
        (
            "couplingProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    )
{
    requireKnownEntries();
}


void Foam::couplingDictionary::requireKnownEntries()
{
    // All ranks call it: some of OpenFOAM's file handlers communicate.
    const fileName file(filePath());
    OStringStream text;
    if (Pstream::master())
    {
        written_ = asWritten(file);
        written_.write(text, false);
    }
    const auto require = [&](const dictionary& dict, const dictionary& writtenDict, const Keywords& table)
    {
        const bool first = Pstream::master();
        reportUnknown(dict, first ? UnknownEntries(dict, writtenDict, text.str(), table) : UnknownEntries(), table);
    };

    Keywords all(keywords);
    for (const auto& engine : cohesion::coupling::dem_engines)
    {
        all.push_back({std::string(engine.name) + "Coeffs"});
    }
    require(*this, written_, all);
    for (const auto& engine : cohesion::coupling::dem_engines)
    {
        const word coeffs(std::string(engine.name) + "Coeffs");
        require(subOrEmptyDict(coeffs), written_.subOrEmptyDict(coeffs), engineKeywords);
    }
}


std::set<std::string> Foam::couplingDictionary::ownVariables(const word& engine) const
{
    const auto variables = [&](const dictionary& dict)
    {
        return dict.subOrEmptyDict(engine + "Coeffs").subOrEmptyDict("variables");
    };
    const dictionary carriedOut(variables(*this));
    std::set<std::string> names;
    for (const entry& variable : variables(written_))
    {
        // Directives are entries of the file alone.
        if (carriedOut.found(variable.keyword(), keyType::LITERAL))
        {
            names.insert(variable.keyword());
        }
    }
    return names;
}
