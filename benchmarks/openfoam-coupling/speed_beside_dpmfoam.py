#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Seconds of cohesiveBedFoam beside OpenFOAM's own DPMFoam: same mesh, gas step, spheres and drag
closure, contacts with friction in both, about as many particle steps (DPMFoam chooses its own). Both on
one core, alternately; processor time, as the clock of a busy machine says little. And the memory of each per
sphere: what the largest resident size grows by with ten times as many layers; of cohesiveBedFoam also where it neither
writes nor keeps a state.

    speed_beside_dpmfoam.py BUILD WORK [REPEATS] [--csv FILE]

A program and no test: a time has no right value."""

import functools
import os
import re
import statistics
import subprocess

from cohesion_studies.foam_case import CaseError
from cohesion_tests import csv_table, measuring_program
from cohesion_tests.coupling.cases import Columns

STEPS, DT = 50, 1e-4
# Spheres of 2 mm on a lattice, nearly touching, that fall together
SPACING, LAYERS, PER_EDGE, D = 2.05e-3, 3, 29, 2e-3
# DPMFoam compares all spheres of neighbouring cells: cells of few spheres are its choice.
CELLS = "(12 12 40)"
# For the memory: ten times the spheres, a tenth of the steps
MANY, FEW = 10 * LAYERS, STEPS // 10

HEADER = """FoamFile {{ version 2.0; format ascii; class {}; object {}; }}
"""
CLOUD = """
solution
{
    active true; coupled true; transient yes; cellValueSourceCorrection off;
    interpolationSchemes { rho.air cell; U.air cell; mu.air cell; }
    integrationSchemes { U Euler; }
    sourceTerms { schemes { U semiImplicit 1; } }
}
constantProperties
{
    parcelTypeId 1; rhoMin 1e-15; minParcelMass 1e-15; rho0 1000; youngsModulus 1e8; poissonsRatio 0.35;
    constantVolume false; alphaMax 0.99;
}
subModels
{
    particleForces { ErgunWenYuDrag { alphac alpha.air; } gravity; }
    injectionModels
    {
        model1
        {
            type manualInjection; massTotal 0; parcelBasisType fixed; nParticle 1; SOI 0;
            positionsFile "positions"; U0 (0 0 0);
            sizeDistribution { type fixedValue; fixedValueDistribution { value 2e-3; } }
        }
    }
    dispersionModel none; heatTransferModel none; surfaceFilmModel none; radiation off;
    stochasticCollisionModel none;
    patchInteractionModel localInteraction;
    localInteractionCoeffs { patches ( ".*" { type rebound; e 0.97; mu 0.3; } ); }
    collisionModel pairCollision;
    pairCollisionCoeffs
    {
        maxInteractionDistance 2e-3; writeReferredParticleCloud no;
        pairModel pairSpringSliderDashpot;
        pairSpringSliderDashpotCoeffs
        {
            useEquivalentSize no; alpha 0.02; b 1.5; mu 0.3; cohesionEnergyDensity 0;
            collisionResolutionSteps 12;
        }
        wallModel wallSpringSliderDashpot;
        wallSpringSliderDashpotCoeffs
        {
            useEquivalentSize no; collisionResolutionSteps 12; youngsModulus 1e8; poissonsRatio 0.35;
            alpha 0.02; b 1.5; mu 0.3; cohesionEnergyDensity 0;
        }
        U U.air;
    }
}
cloudFunctions {}
"""
U_AIR = """
dimensions [0 1 -1 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{
    bottom { type fixedValue; value uniform (0 0 0); }
    sides  { type slip; }
    top    { type pressureInletOutletVelocity; phi phi.air; value uniform (0 0 0); }
}
"""


def positions(layers=LAYERS):
    first = SPACING / 2
    return [(first + i * SPACING, first + j * SPACING, first + k * SPACING)
            for k in range(layers) for j in range(PER_EDGE) for i in range(PER_EDGE)]


def used(case, program, *arguments):
    """Processor time of a program of the case, start and reading included [s], and its largest resident size
    [bytes]."""
    with open(case.log(program), "w") as log:
        process = subprocess.Popen([program, *arguments], cwd=case.folder, env=case.env, stdout=log, stderr=log)
        _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) != 0:
        raise CaseError(f"{program} failed in {case.folder}:\n" + case.tail(program))
    return usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss


def seconds(case, program):
    return used(case, program)[0]


def prepare(case, steps):
    block = case.folder / "system/blockMeshDict"
    block.write_text(block.read_text().replace("(3 3 10)", CELLS))
    for entry, value in (("endTime", steps * DT), ("deltaT", DT), ("writeInterval", steps * DT)):
        case.set("system/controlDict", entry, value)


def ours(column, layers=LAYERS, steps=STEPS, states=True):
    """Seconds, bytes, share of the exchange [%], particle steps. `states`: whether it writes and keeps some."""
    case = column("cohesiveBedFoam")
    coupling = "constant/couplingProperties"
    case.set(coupling, "drag", "ergunWenYu")
    case.set(coupling, "minVoidFraction", 0.01)  # spheres by their centres, as DPMFoam takes them
    case.set(coupling, "lammpsCoeffs/script", '"$FOAM_CASE/swarm.lmp"')
    script = case.folder / "swarm.lmp"
    text = script.read_text()
    for line, new in (("region +inside", f"region inside block 0 0.0595 0 0.0595 0 {layers * SPACING}"),
                      ("lattice", f"lattice sc {SPACING} origin 0.5 0.5 0.5"), ("velocity", "")):
        text = re.sub(f"^{line} .*$", new, text, flags=re.M)
    script.write_text(text)
    prepare(case, steps)
    if not states:
        case.set("system/controlDict", "writeInterval", 1)
    case.mesh()
    # With this file handler the solver keeps none.
    time, memory = used(case, "cohesiveBedFoam", *([] if states else ["-fileHandler", "masterUncollated"]))
    log = case.log("cohesiveBedFoam").read_text()
    share = float(re.search(r"^    exchange +\S+ s, (\S+) %", log, re.M)[1])
    made = re.findall(r"Created (\d+) atoms", (case.folder / "log.lammps").read_text())
    assert int(made[0]) == len(positions(layers)), made
    return time, memory, share, steps * round(DT / 1e-5)


def theirs(column, layers=LAYERS, steps=STEPS):
    case = column("DPMFoam")
    folder = case.folder
    (folder / "constant/kinematicCloudProperties").write_text(
        HEADER.format("dictionary", "kinematicCloudProperties") + CLOUD)
    (folder / "constant/transportProperties").write_text(
        HEADER.format("dictionary", "transportProperties")
        + "continuousPhase air; rho.air 1.205; transportModel Newtonian; nu 1.452282e-5;\n")
    (folder / "constant/turbulenceProperties.air").write_text(
        HEADER.format("dictionary", "turbulenceProperties") + "simulationType laminar;\n")
    (folder / "constant/positions").write_text(
        HEADER.format("vectorField", "positions")
        + "(\n" + "\n".join("({} {} {})".format(*p) for p in positions(layers)) + "\n)\n")
    (folder / "0.orig/U.air").write_text(HEADER.format("volVectorField", "U.air") + U_AIR)
    for file, old, new in (
            ("system/fvSchemes", "div(voidFractionPhi,U)", "div(alphaPhi.air,U.air)"),
            ("system/fvSchemes", "div(((voidFraction*nu)*dev2(T(grad(U)))))",
             "div(((alpha.air*nuEff.air)*dev2(T(grad(U.air)))))"),
            ("system/fvSolution", '"p.*"', '"(p|kinematicCloud:theta).*"')):
        path = folder / file
        path.write_text(path.read_text().replace(old, new))
    prepare(case, steps)
    case.mesh()
    time, memory = used(case, "DPMFoam")
    log = case.log("DPMFoam").read_text()
    assert re.findall(r"Current number of parcels += (\d+)", log)[-1] == str(len(positions(layers)))
    cycles = re.findall(r"(\d+) move-collide subCycles", log)
    return time, memory, None, sum(map(int, cycles))


# Of coupled_speed.csv: cases of the speed, cases and programs of the memory
CASES = {"cohesiveBedFoam": "{} falling spheres of 2 mm, cells of 5 mm: cohesiveBedFoam, {} particle steps",
         "DPMFoam": "the same case, gas step and closure in OpenFOAM's DPMFoam, {1} particle steps"}
MEMORY = {"cohesiveBedFoam with LAMMPS, states written": ours,
          "cohesiveBedFoam with LAMMPS, no state written or kept": functools.partial(ours, states=False),
          "DPMFoam": theirs}


def main():
    parser = measuring_program.coupling_parser(__doc__, table=True)
    parser.add_argument("repeats", type=int, nargs="?", default=3, help="(%(default)s)")
    args = parser.parse_args()
    column = Columns(args.build, args.work)
    results = {"cohesiveBedFoam": [], "DPMFoam": []}
    for _ in range(args.repeats):
        results["cohesiveBedFoam"].append(ours(column))
        results["DPMFoam"].append(theirs(column))
    n = len(positions())
    medians = {}
    for name, runs in results.items():
        time, steps = statistics.median(r[0] for r in runs), runs[0][3]
        medians[name] = time
        csv_table.enter_quantities(args.csv, "speed", CASES[name].format(n, steps), {"seconds": f"{time:.1f}"})
        print(f"{name}: {n} spheres, {STEPS} gas steps, {steps} particle steps: {time:.2f} s "
              f"({', '.join(f'{r[0]:.2f}' for r in runs)}), {time / (STEPS * DT):.0f} s per simulated "
              f"second, {1e6 * time / (n * steps):.2f} us per sphere and particle step")
    exchange = statistics.median(r[2] for r in results["cohesiveBedFoam"])
    print(f"ratio of the times: {medians['DPMFoam'] / medians['cohesiveBedFoam']:.1f}; "
          f"share of the exchange in cohesiveBedFoam: {exchange:.0f} %")
    for name, program in MEMORY.items():
        few, many = program(column, steps=FEW), program(column, layers=MANY, steps=FEW)
        extra = len(positions(MANY)) - n
        csv_table.enter_quantities(args.csv, "memory", name, {
            "bytes per additional sphere": f"{(many[1] - few[1]) / extra:.0f}"})
        print(f"{name}: {few[1] / 2**20:.0f} MB with {n} spheres, {many[1] / 2**20:.0f} MB with {n + extra}: "
              f"{(many[1] - few[1]) / extra:.0f} bytes per sphere"
              + (f"; share of the exchange {many[2]:.0f} %" if many[2] is not None else ""))


if __name__ == "__main__":
    main()
