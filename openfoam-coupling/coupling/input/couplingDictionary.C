// SPDX-License-Identifier: GPL-3.0-or-later
#include "couplingDictionary.H"

#include "IFstream.H"
#include "OStringStream.H"
#include "Pstream.H"
#include "Time.H"

#include "dem-engines/load_dem_engine.h"
#include "nearest_name.h"

#include <array>
#include <cctype>
#include <vector>

namespace
{

struct Word
{
    std::string name;
};

using Words = std::vector<Word>;

//- What the coupling reads, but for the dictionaries of the engines
const Words words
{
    {"demEngine"}, {"form"}, {"drag"}, {"dragFactor"}, {"dragExponent"}, {"response"}, {"slip"},
    {"voidFraction"}, {"smoothingWidth"}, {"minVoidFraction"}, {"depth"}, {"particleGravity"}
};

//- What it reads of the dictionary of an engine
const Words wordsOfEngine{{"script"}, {"log"}, {"variables"}, {"library"}};


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


//- Whether $name, ${name} or $:name stands in the text
bool takenUp(const std::string& text, const std::string& name)
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


bool known(const Words& table, const std::string& name)
{
    return std::any_of(table.begin(), table.end(), [&](const Word& word) { return word.name == name; });
}


//- Whether a pattern, "(lammps|liggghts)Coeffs", is for a known word
bool matches(const Foam::keyType& pattern, const Words& table)
{
    return std::any_of(table.begin(), table.end(), [&](const Word& word) { return pattern.match(word.name); });
}


//- Whether a name is one letter off a known one, or its case; of a long one two letters. Short words that mean
//  something else are as near as that: 'step' and 'slip'.
bool misspelt(const std::string& name, const std::string& nearest)
{
    return cohesion::letters_apart(name, nearest) <= (nearest.size() < 6 ? 1 : 2);
}


//- What is unknown in a dictionary of the file, in words
struct Unknown
{
    std::string misspelt;
    std::string unread;     // of the file itself, and not taken up in it

    Unknown() = default;

    Unknown
    (
        const Foam::dictionary& dict,
        const Foam::dictionary& written,
        const std::string& text,
        const Words& table
    )
    {
        for (const Foam::entry& entry : dict)
        {
            const Foam::keyType& key = entry.keyword();
            const bool here = written.found(key, Foam::keyType::LITERAL);
            if (known(table, key) || (key.isPattern() && matches(key, table)) || (here && takenUp(text, key)))
            {
                continue;
            }
            const std::string nearest(cohesion::nearest_name(table, key));
            const bool wrong = ::misspelt(key, nearest);
            if (wrong || here)
            {
                std::string& names = wrong ? misspelt : unread;
                names += (names.empty() ? "'" : ", '") + key + "' (the nearest known one is '" + nearest + "')";
            }
        }
    }
};


std::string list(const Words& table)
{
    std::string names;
    for (const Word& word : table)
    {
        names += (names.empty() ? "" : ", ") + word.name;
    }
    return names;
}


void refuse(const Foam::dictionary& dict, const Unknown& unknown, const Words& table)
{
    Foam::string misspelt(unknown.misspelt);
    Foam::Pstream::scatter(misspelt);
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
    refuseUnknown();
}


void Foam::couplingDictionary::refuseUnknown() const
{
    // On all ranks: some of OpenFOAM's file handlers ask each other.
    const fileName file(filePath());
    dictionary written;
    OStringStream text;
    if (Pstream::master())
    {
        written = asWritten(file);
        written.write(text, false);
    }
    const auto refuseOther = [&](const dictionary& dict, const dictionary& writtenDict, const Words& table)
    {
        refuse(dict, Pstream::master() ? Unknown(dict, writtenDict, text.str(), table) : Unknown(), table);
    };

    Words all(words);
    for (const auto& engine : cohesion::coupling::dem_engines)
    {
        all.push_back({std::string(engine.name) + "Coeffs"});
    }
    refuseOther(*this, written, all);
    for (const auto& engine : cohesion::coupling::dem_engines)
    {
        const word coeffs(std::string(engine.name) + "Coeffs");
        refuseOther(subOrEmptyDict(coeffs), written.subOrEmptyDict(coeffs), wordsOfEngine);
    }
}
