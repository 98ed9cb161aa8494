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


//- What is unknown in a dictionary of the file, in words; nothing if all is known
std::string unknown
(
    const Foam::dictionary& dict,
    const Foam::dictionary& written,
    const std::string& text,
    const Words& table
)
{
    std::string refused;
    for (const Foam::entry& entry : dict)
    {
        const std::string name = entry.keyword();
        if (known(table, name))
        {
            continue;
        }
        const std::string nearest(cohesion::nearest_name(table, name));
        const bool ours =
            written.found(name, Foam::keyType::LITERAL)
          ? takenUp(text, name)
          : cohesion::letters_apart(name, nearest) > 1;
        if (!ours)
        {
            refused += (refused.empty() ? "'" : ", '") + name + "' (the nearest known one is '" + nearest + "')";
        }
    }
    return refused;
}


std::string list(const Words& table)
{
    std::string names;
    for (const Word& word : table)
    {
        names += (names.empty() ? "" : ", ") + word.name;
    }
    return names;
}


void refuse(const Foam::dictionary& dict, Foam::string refused, const Words& table)
{
    Foam::Pstream::scatter(refused);
    if (refused.size())
    {
        FatalIOErrorInFunction(dict)
            << "unknown entry " << refused.c_str() << Foam::nl
            << "    Known are " << list(table).c_str() << Foam::nl
            << "    Entries of your own may stand here if a $ takes them up here, or in a file that is included"
            << Foam::exit(Foam::FatalIOError);
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
        refuse(dict, Pstream::master() ? unknown(dict, writtenDict, text.str(), table) : "", table);
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
