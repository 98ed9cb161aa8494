// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the coupling: reads the dictionary, starts the engine, checks that both fit together.
#include "gasParticleCoupling.H"

#include "OSspecific.H"
#include "OStringStream.H"
#include "UPstream.H"

#include "coupling/checks/caseChecks.H"
#include "coupling/input/readPositive.H"
#include "coupling/input/selectRow.H"
#include "coupling/particles/engineMessages.H"
#include "coupling/particles/reportParticles.H"
#include "coupling/restart/completeState.H"
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


//- Explains the file name 'none' in an engine's error: it is the value of the variable restart.
std::string withHint(const std::string& text)
{
    const bool ofNewRun = text.find("restart file none") != std::string::npos;
    return !ofNewRun ? text : text + "\n    In a new run the variable 'restart', which the solver sets, is 'none': read"
        " it only where 'continued' says so, and give the file that a new run begins from another name";
}

} // End anonymous namespace


Foam::gasParticleCoupling::gasParticleCoupling
(
    const fvMesh& mesh,
    const gasDensity& density,
    const scalar mu,
    const vector& g
)
:
    mesh_(mesh),
    dict_(mesh),
    density_(density),
    rho_(requirePositive(dict_, "density of the gas", density.reference().value())),
    g_(g),
    form_(selectRow(dict_, "form", drag::model_forms, "A")),
    drag_(dict_, requirePositive(dict_, "viscosity of the gas", mu)),
    bound_(dict_, drag_),
    filter_(dict_, mesh, mu, mag(g)),
    response_(selectRow(dict_, "response", drag::responses, "held")),
    liquid_(dict_, drag_.closure()),
    gasAt_(dict_),
    depthRatio_(1),
    coupledParticles_
    (
        mesh,
        engine_,
        completeState::isComplete(mesh.time()),
        g_,
        density_,
        depthRatio_,
        [this]() -> particleAveraging&
        {
            locateParticles();
            return averaging_;
        }
    ),
    averaging_(mesh, dict_),
    continued_(coupledParticles_.continued()),
    hasLastGradient_(continued_),
    voidFraction_(mesh, dict_, depthRatio_),
    inlets_(voidFraction()),
    inletVelocities_(voidFraction()),
    monitor_(mesh, density, {drag_.closure(), form_, response_}, liquid_.addedCoefficient()),
    sources_(mesh, depthRatio_, response_, rho_),
    kept_(mesh.time())
{
    // Their factors are on a coefficient b that a quadratic drag has not
    if (drag_.closure().quadratic && (bound_.on() || filter_.active()))
    {
        FatalIOErrorInFunction(dict_)
            << "drag " << drag_.closure().name.data() << " has one coefficient, for bubbles: it goes with neither"
            << " agglomerateDrag nor dragFilter, which are laws of grains" << nl
            << "    Remove the entry, or take another drag" << exit(FatalIOError);
    }
    voidFraction_.requireShares();
    requirePatches(mesh_, dict_);
    setDepthRatio();
    asksForSameGravity(dict_);
    requireEngine();
    gasStep::requireEntries(mesh.time());
    if (!continued_)
    {
        // Until there are particles
        voidFraction_.setEmpty();
    }
    requireShareOfVolume(voidFraction());
}


void Foam::gasParticleCoupling::start(coupledTime& time)
{
    requireStepOfScript(time);
    makeEngine();
    requireSiUnits();
    requireBoxOfMesh(dict_, mesh_, engine_->box());
    places_ = std::make_unique<placesOnMesh>(mesh_, engine_->box());
    if (asksForSameGravity(dict_))
    {
        requireSameGravity(dict_, mesh_, *engine_, g_);
    }
    requireReadState();
    reportParticles(coupledParticles_, rho_, drag_.mixture(), drag_.parcels());
    if (bound_.on())
    {
        startBound();
    }
    step_ = std::make_unique<gasStep>(time, engine_->time_step(), continued_);
    warnOfWideSmoothing(dict_, mesh_, coupledParticles_);
    warnOfSuspensionInSmallCells(dict_, mesh_, coupledParticles_);

    if (!continued_)
    {
        locateParticles();
        setVoidFraction();
    }
    voidFraction().oldTime();
    coupledParticles_.start();
}


void Foam::gasParticleCoupling::setDepthRatio()
{
    if (!dict_.found("depth"))
    {
        return;
    }
    const scalar depth = readPositive(dict_, "depth");
    if (mesh_.nGeometricD() != 2)
    {
        FatalIOErrorInFunction(dict_)
            << "depth = " << depth << " goes with a 2-D mesh, and this one has "
            << mesh_.nGeometricD() << " dimensions: remove the entry"
            << exit(FatalIOError);
    }
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh_.geometricD()[d] < 0)
        {
            depthRatio_ = depth/mesh_.bounds().span()[d];
        }
    }
}


coupling::DemEngineSettings Foam::gasParticleCoupling::engineSettings(const word& name)
{
    const dictionary& coeffs = dict_.subDict(name + "Coeffs");
    coupling::DemEngineSettings settings;
    settings.folder = mesh_.time().globalPath();
    // Engines may end the process with an error once they have shown it.
    settings.on_message =
        [show = engineMessages(name), &kept = kept_](const coupling::MessageLevel level, const std::string& text)
    {
        show(level, withHint(text));
        if (level == coupling::MessageLevel::error)
        {
            kept.release();
        }
    };
    settings.script = coeffs.get<fileName>("script").expand();
    settings.log = coeffs.getOrDefault<fileName>("log", "log." + name).expand();
    if (continued_)
    {
        settings.restart = completeState::restartFile(mesh_.time());
        settings.log += "." + mesh_.time().timeName();
    }
    for (const entry& variable : coeffs.subOrEmptyDict("variables"))
    {
        requireOwnName(coeffs, variable.keyword());
        settings.variables[variable.keyword()] = inWords(variable.stream());
    }
    settings.communicator = MPI_COMM_WORLD;

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
    return settings;
}


Foam::gasParticleCoupling::EngineOfCase Foam::gasParticleCoupling::engineOfCase()
{
    const word name(dict_.get<word>("demEngine"));
    // The name first: a misspelt one is not a missing dictionary.
    const auto& row = coupling::dem_engine(name);
    coupling::DemEngineSettings settings(engineSettings(name));
    const dictionary& coeffs = dict_.subDict(name + "Coeffs");
    const std::string library
    (
        coeffs.found("library")
      ? coeffs.get<fileName>("library").expand()
      : fileName(coupling::dem_engine_library(row))
    );
    return {name, library, std::move(settings)};
}


void Foam::gasParticleCoupling::requireEngine()
{
    try
    {
        const EngineOfCase engine(engineOfCase());
        checkScript(dict_.subDict(engine.name + "Coeffs"), engine.settings, dict_.ownVariables(engine.name));
        if (!continued_)
        {
            requireBoxOfScript(dict_, mesh_, engine.settings);
        }
    }
    catch (const std::exception& error)
    {
        FatalIOErrorInFunction(dict_) << error.what() << exit(FatalIOError);
    }
}


void Foam::gasParticleCoupling::requireStepOfScript(coupledTime& time)
{
    const scalar step = continued_ ? 0 : stepOfScript(engineOfCase().settings);
    if (step > 0 && !time.controlDict().getOrDefault("adjustTimeStep", false))
    {
        const gasStep trial(time, step, continued_);
    }
}


void Foam::gasParticleCoupling::makeEngine()
{
    try
    {
        const auto [name, library, settings] = engineOfCase();
        if (!Pstream::parRun())
        {
            // The engine needs MPI, which a serial OpenFOAM leaves alone.
            UPstream::initNull();
        }
        Info<< "Particle engine " << name << " runs " << settings.script.c_str() << ", log in "
            << settings.log.c_str() << endl;
        engine_.reset(coupling::load_dem_engine(library)(settings));
        if (!liquid_.active())
        {
            engine_->without_liquid();
        }
    }
    catch (const std::exception& error)
    {
        FatalIOErrorInFunction(dict_) << withHint(error.what()).c_str() << exit(FatalIOError);
    }
}


void Foam::gasParticleCoupling::startBound()
{
    try
    {
        bound_.start(*engine_);
    }
    catch (const std::exception& error)
    {
        FatalIOErrorInFunction(dict_) << error.what() << exit(FatalIOError);
    }
}


void Foam::gasParticleCoupling::requireSiUnits() const
{
    if (engine_->units() != "si")
    {
        FatalIOErrorInFunction(dict_)
            << "the particle script has units " << engine_->units().c_str()
            << "; OpenFOAM works in SI: use 'units si' in the script" << exit(FatalIOError);
    }
}


void Foam::gasParticleCoupling::requireReadState() const
{
    if (!continued_)
    {
        return;
    }
    const int64_t stepsThen = completeState::engineSteps(mesh_.time());
    if (engine_->steps_done() != stepsThen)
    {
        FatalIOErrorInFunction(dict_)
            << "the run continues at time " << mesh_.time().timeName() << ", where the particles had done "
            << stepsThen << " steps, but after the particle script they"
            << " have done " << int64_t(engine_->steps_done()) << nl
            << "    Let the script read their state when there is one: "
            << engine_->restart_hint().c_str() << ", and set no time step number after that."
            << " To begin anew with the gas of that time, remove its folder 'uniform'"
            << exit(FatalIOError);
    }
}
