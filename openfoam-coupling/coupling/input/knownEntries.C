// SPDX-License-Identifier: GPL-3.0-or-later
#include "knownEntries.H"

#include "dictionary.H"
#include "error.H"

#include "nearest_name.h"

#include <algorithm>

namespace Foam
{

namespace
{

//- Words of fewer letters are not compared: 'mu' is as near to 'nu' as a misspelt one.
constexpr std::size_t shortest = 4;


//- FoamFile and patterns are none.
template<class Wanted>
std::string entriesThat(const dictionary& dict, const Keywords& table, const Wanted& wanted)
{
    std::string names;
    for (const entry& each : dict)
    {
        const keyType& key = each.keyword();
        if (key.isPattern() || key == "FoamFile" || isKnown(table, key))
        {
            continue;
        }
        const std::string nearest(cohesion::nearest_name(table, key));
        if (wanted(key, nearest))
        {
            names += (names.empty() ? "" : ", ") + unknownEntry(key, nearest);
        }
    }
    return names;
}

} // End anonymous namespace


bool isKnown(const Keywords& table, const std::string& name)
{
    return std::any_of(table.begin(), table.end(), [&](const Keyword& word) { return word.name == name; });
}


bool isMisspelt(const std::string& name, const std::string& nearest)
{
    return cohesion::letters_apart(name, nearest) <= (nearest.size() < 6 ? 1 : 2);
}


std::string unknownEntry(const std::string& name, const std::string& nearest)
{
    return "'" + name + "' (the nearest known one is '" + nearest + "')";
}


std::string list(const Keywords& table)
{
    std::string names;
    for (const Keyword& word : table)
    {
        names += (names.empty() ? "" : ", ") + word.name;
    }
    return names;
}


void warnOfUnknownEntries(const dictionary& dict, const Keywords& table)
{
    const std::string unknown(entriesThat(dict, table, [](const auto&, const auto&) { return true; }));
    if (unknown.size())
    {
        IOWarningInFunction(dict)
            << "unknown entry " << unknown.c_str() << ": nothing reads it" << nl << "    Known are "
            << list(table).c_str() << endl;
    }
}


void warnOfMisspeltEntries(const dictionary& dict, const Keywords& table, const Keywords& exempt)
{
    const auto wanted = [&](const std::string& name, const std::string& nearest)
    {
        return name.size() >= shortest && !isKnown(exempt, name) && isMisspelt(name, nearest);
    };
    const std::string misspelt(entriesThat(dict, table, wanted));
    if (misspelt.size())
    {
        IOWarningInFunction(dict)
            << "unknown entry " << misspelt.c_str() << ": nothing of cohesiveBedFoam reads it" << endl;
    }
}

} // End namespace Foam
