// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the coupling: reads the dictionary, starts the engine, checks that both fit together.
#include "gasParticleCoupling.H"

#include "UPstream.H"

#include "coupling/checks/caseChecks.H"
#include "coupling/input/engineOfCase.H"
#include "coupling/input/readPositive.H"
#include "coupling/input/selectRow.H"
#include "coupling/particles/reportParticles.H"
#include "coupling/restart/completeState.H"
#include "dem-engines/load_dem_engine.h"

using namespace cohesion;


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

    if (!continued_)
    {
        locateParticles();
        setVoidFraction();
    }
    warnOfWideSmoothing(dict_, mesh_, coupledParticles_);
    warnOfSuspensionInSmallCells(dict_, mesh_, coupledParticles_);
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


void Foam::gasParticleCoupling::requireEngine()
{
    try
    {
        const engineOfCase engine(readEngine(dict_, mesh_.time(), continued_, kept_));
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
    const scalar step = continued_ ? 0 : stepOfScript(readEngine(dict_, mesh_.time(), continued_, kept_).settings);
    if (step > 0 && !time.controlDict().getOrDefault("adjustTimeStep", false))
    {
        const gasStep trial(time, step, continued_);
    }
}


void Foam::gasParticleCoupling::makeEngine()
{
    try
    {
        const auto [name, library, settings] = readEngine(dict_, mesh_.time(), continued_, kept_);
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
        FatalIOErrorInFunction(dict_) << engineErrorText(error.what()).c_str() << exit(FatalIOError);
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
    warnOfLostGasState(dict_, *engine_);
}
