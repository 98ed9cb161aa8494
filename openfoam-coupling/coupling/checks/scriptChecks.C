// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "Pstream.H"
#include "error.H"

#include "nearest_name.h"

#include "coupling/fromFirstRank.H"
#include "coupling/input/knownEntries.H"
#include "coupling/input/particleScript.H"

#include <algorithm>

using cohesion::coupling::DemEngineSettings;

namespace
{

using namespace Foam;

//- The units that both engines know; what else may follow the word is of other commands.
const Keywords unitStyles{{"lj"}, {"real"}, {"metal"}, {"cgs"}, {"electron"}, {"micro"}, {"nano"}, {"si"}};


//- The units of the script in words, empty where they are SI or the text does not state them
std::string foreignUnits(const particleScript& script)
{
    std::string foreign;
    for (const std::string& style : script.wordsBehind("units"))
    {
        if (style == "si" || style.find('$') != std::string::npos)
        {
            return {};
        }
        foreign = isKnown(unitStyles, style) ? style : foreign;
    }
    // What the engines take by themselves
    const char* const missing = "no command units, and then has units lj";
    return foreign.size() ? "units " + foreign : script.all() ? missing : "";
}


bool hasContacts(const particleScript& script)
{
    const auto styles = script.wordsBehind("pair_style");
    // `pair_style none` is deliberate.
    return styles.size() || !script.all();
}


//- Variables that the case gives and the script does not use, in words
std::string unusedVariables(const particleScript& script, const std::set<std::string>& variables)
{
    std::string unused;
    if (!script.all())
    {
        return unused;
    }
    Keywords used;
    for (const std::string& name : script.variables())
    {
        used.push_back({name});
    }
    for (const std::string& name : variables)
    {
        if (!script.has(name))
        {
            unused += (unused.empty() ? "'" : ", '") + name + "'";
            if (used.size())
            {
                unused += " (the nearest that it uses is '" + std::string(cohesion::nearest_name(used, name)) + "')";
            }
        }
    }
    return unused;
}

} // End anonymous namespace


void Foam::checkScript
(
    const dictionary& dict,
    const DemEngineSettings& settings,
    const std::set<std::string>& variables
)
{
    string units;
    string unused;
    label contacts = true;
    if (Pstream::master())
    {
        const particleScript script(settings.folder, settings.script, settings.variables);
        units = foreignUnits(script);
        unused = unusedVariables(script, variables);
        contacts = hasContacts(script);
    }
    fromFirstRank(units);
    if (units.size())
    {
        FatalIOErrorInFunction(dict)
            << "the particle script " << settings.script.c_str() << " has " << units.c_str()
            << "; OpenFOAM works in SI: use 'units si' in the script" << exit(FatalIOError);
    }
    if (unused.size())
    {
        IOWarningInFunction(dict)
            << "the particle script " << settings.script.c_str() << " does not use the variable " << unused.c_str()
            << ": remove it from 'variables', or correct its name" << endl;
    }
    if (!contacts)
    {
        IOWarningInFunction(dict)
            << "the particle script " << settings.script.c_str() << " has no pair_style: particles do not touch, and"
            << " fall through each other" << nl
            << "    Give the contacts by pair_style and pair_coeff; for particles that never meet, write"
            << " 'pair_style none'" << endl;
    }
}


void Foam::requireBoxOfScript(const dictionary& dict, const polyMesh& mesh, const DemEngineSettings& settings)
{
    // Low and high end of each direction, and whether they are periodic and fixed; empty where the text has no box
    scalarList ends;
    if (Pstream::master())
    {
        const auto box = particleScript(settings.folder, settings.script, settings.variables).box();
        for (direction d = 0; box && d < 3; ++d)
        {
            const auto& [low, high, periodic, fixed] = *box;
            ends.append(scalarList({low[d], high[d], scalar(periodic[d]), scalar(fixed[d])}));
        }
    }
    fromFirstRank(ends);
    if (ends.empty())
    {
        return;
    }
    cohesion::coupling::DemEngine::SimulationBox box;
    for (direction d = 0; d < 3; ++d)
    {
        box.low[d] = ends[4*d];
        box.high[d] = ends[4*d + 1];
        box.periodic[d] = ends[4*d + 2] > 0;
        box.fixed[d] = ends[4*d + 3] > 0;
    }
    requireEndsOfMesh(dict, mesh, box);
}


Foam::scalar Foam::stepOfScript(const DemEngineSettings& settings)
{
    scalar step = 0;
    if (Pstream::master())
    {
        step = particleScript(settings.folder, settings.script, settings.variables).number("timestep").value_or(0);
    }
    fromFirstRank(step);
    return step;
}
