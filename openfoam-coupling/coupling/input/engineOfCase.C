// SPDX-License-Identifier: GPL-3.0-or-later
#include "engineOfCase.H"

#include "OSspecific.H"
#include "OStringStream.H"
#include "Time.H"

#include "coupling/particles/engineMessages.H"
#include "coupling/restart/completeState.H"
#include "coupling/restart/keptState.H"
#include "dem-engines/load_dem_engine.h"

using namespace cohesion;


namespace
{

//- An entry as the script gets it: numbers with all digits that a case is likely to have
std::string inWords(const Foam::ITstream& entry)
{
    Foam::OStringStream words;
    words.precision(15);
    forAll(entry, k)
    {
        if (k)
        {
            words << ' ';
        }
        const Foam::token& token = entry[k];
        token.isString() ? words.writeQuoted(token.stringToken(), false) : words << token;
    }
    return words.str();
}


//- FatalIOError where a variable has a name that the solver sets
void requireOwnName(const Foam::dictionary& coeffs, const Foam::word& variable)
{
    using namespace Foam;
    if (variable == "restart" || variable == "continued")
    {
        FatalIOErrorInFunction(coeffs)
            << "variables: '" << variable << "' is set by the solver: 'continued' says whether a run of this case is"
            << " continued, and 'restart' is the file of its particles, 'none' in a new run" << nl
            << "    To begin a new run from a file of particles, take another name, for instance 'settled', and"
            << " 'read_restart ${settled}' in the script where the run is not continued" << exit(FatalIOError);
    }
}


//- FatalIOError unless the script is there
void requireScript
(
    const Foam::dictionary& coeffs,
    const Foam::word& name,
    const coupling::DemEngineSettings& settings
)
{
    using namespace Foam;
    const fileName script(settings.script);
    const fileName path(script.isAbsolute() ? script : settings.folder/script);
    if (!isFile(path))
    {
        FatalIOErrorInFunction(coeffs)
            << "script '" << script.c_str() << "' "
            << (isDir(path) ? "is a folder" : "does not exist") << "; name the input script of "
            << name << ", relative to the case folder " << settings.folder.c_str()
            << exit(FatalIOError);
    }
}


//- kept: is released when the engine has an error
coupling::DemEngineSettings readSettings
(
    const Foam::dictionary& coeffs,
    const Foam::word& name,
    const Foam::Time& time,
    const bool continued,
    Foam::keptState& kept
)
{
    using namespace Foam;
    coupling::DemEngineSettings settings;
    settings.folder = time.globalPath();
    // Engines may end the process with an error once they have shown it.
    settings.on_message =
        [show = engineMessages(name), &kept](const coupling::MessageLevel level, const std::string& text)
    {
        show(level, engineErrorText(text));
        if (level == coupling::MessageLevel::error)
        {
            kept.release();
        }
    };
    settings.script = coeffs.get<fileName>("script").expand();
    settings.log = coeffs.getOrDefault<fileName>("log", "log." + name).expand();
    if (continued)
    {
        settings.restart = completeState::restartFile(time);
        settings.log += "." + time.timeName();
    }
    for (const entry& variable : coeffs.subOrEmptyDict("variables"))
    {
        requireOwnName(coeffs, variable.keyword());
        settings.variables[variable.keyword()] = inWords(variable.stream());
    }
    settings.communicator = MPI_COMM_WORLD;
    requireScript(coeffs, name, settings);
    return settings;
}

} // End anonymous namespace


std::string Foam::engineErrorText(const std::string& text)
{
    const bool ofNewRun = text.find("restart file none") != std::string::npos;
    return !ofNewRun ? text : text + "\n    In a new run the variable 'restart', which the solver sets, is 'none': read"
        " it only where 'continued' says so, and give the file that a new run begins from another name";
}


Foam::engineOfCase Foam::readEngine
(
    const dictionary& dict,
    const Time& time,
    const bool continued,
    keptState& kept
)
{
    const word name(dict.get<word>("demEngine"));
    // The name first: a misspelt one is not a missing dictionary.
    const auto& row = coupling::dem_engine(name);
    const dictionary& coeffs = dict.subDict(name + "Coeffs");
    coupling::DemEngineSettings settings(readSettings(coeffs, name, time, continued, kept));
    const std::string library
    (
        coeffs.found("library")
      ? coeffs.get<fileName>("library").expand()
      : fileName(coupling::dem_engine_library(row))
    );
    return {name, library, std::move(settings)};
}
