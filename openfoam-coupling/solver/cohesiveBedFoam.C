// SPDX-License-Identifier: GPL-3.0-or-later
/*
Application
    cohesiveBedFoam

Description
    Transient solver for the volume-averaged flow of a gas, incompressible or an ideal one of one
    temperature, through particles that a particle engine (LAMMPS, LIGGGHTS) moves. Laminar, or with a
    turbulence model where there is a constant/turbulenceProperties. PIMPLE for the gas, one exchange each way
    per gas step. Sources and constraints by constant/fvOptions, function objects in system/controlDict.

    Forms A and B of the model, src/drag/model_form.h.

Usage
    cohesiveBedFoam [-overwrite] [-parallel]
    cohesiveBedFoam -postProcess [-func name]   // on written results, without particles
    with constant/couplingProperties as described in docs/openfoam-coupling/cohesiveBedFoam.md; continues a run when
    system/controlDict says `startFrom latestTime`
*/

#include "fvCFD.H"
#include "cohesion_version.h"
#include "endWithState.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "fvOptions.H"
#include "gasMass.H"
#include "gasStress.H"
#include "pimpleControl.H"
#include "progress.H"
#include "requireEuler.H"
#include "requireGasEntries.H"
#include "requireParallel.H"
#include "tryTurbulence.H"

#include "coupling/restart/completeState.H"
#include "coupling/restart/coupledTime.H"
#include "coupling/gasParticleCoupling.H"
#include "coupling/checks/requireDimensions.H"
#include "coupling/checks/caseChecks.H"

int main(int argc, char* argv[])
{
    argList::addNote("Gas through the particles of a particle engine");
    argList::addBoolOption("overwrite", "Run although the case already holds results");

    #define NO_CONTROL
    #define CREATE_FIELDS readGas.H
    #define CREATE_FIELDS_2 readVoidFraction.H
    #define CREATE_FIELDS_3 createFlow.H
    #include "postProcess.H"

    #include "setRootCase.H"
    Info<< "Cohesion " COHESION_VERSION << nl;
    requireParallel();
    requireTimes(args);
    completeState::setAsideIncomplete(args);
    Info<< "Create time\n" << endl;
    coupledTime runTime(args);
    completeState::prepareStart(runTime, args.found("overwrite"));
    runTime.writeFrom(completeState::writtenFrom(runTime));
    #include "createMesh.H"

    requireEuler(mesh);
    pimpleControl pimple(mesh);

    #include "readGas.H"
    #include "createCoupling.H"
    if (!hasTimeLeft(runTime, coupling.continued()))
    {
        return 0;
    }
    #include "createFlow.H"
    #include "checkCase.H"
    coupling.start(runTime);
    #include "startFlow.H"
    coupling.checkInlets(U);

    if (!coupling.continued())
    {
        coupling.writeParticles();
    }

    Info<< "\nStarting time loop\n" << endl;

    const progress progress(runTime);
    try
    {
        const thrownErrors thrown;
        while (runTime.run())
        {
            coupling.keepState(runTime);
            #include "CourantNo.H"
            coupling.adjustStep(runTime, CoNum);
            ++runTime;
            Info<< "Time = " << runTime.timeName() << progress << nl;

            coupling.depositParticles(U, gradP);
            if (coupling.checksViscousWaves())
            {
                coupling.checkViscousWaves(stress.viscosity());
            }
            #include "solveGas.H"

            coupling.advanceParticles(U, rho*gradP);

            const bool written = runTime.write();
            if (runTime.writeTime())
            {
                coupling.writeState(written);
            }
            Info<< endl;
        }
    }
    catch (const IOerror& error)
    {
        endWithState(error, coupling.kept());
    }
    catch (const Foam::error& error)
    {
        endWithState(error, coupling.kept());
    }

    coupling.report(progress.elapsed());
    Info<< "End\n" << endl;

    return 0;
}
