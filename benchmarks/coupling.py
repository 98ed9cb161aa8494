# SPDX-License-Identifier: BSD-3-Clause
"""Feature x cost when off x cost when on of the gas: cohesiveBedFoam on falling spheres, in instructions per
gas step and sphere; beside the particle engine alone."""
import re
import tempfile
from pathlib import Path

from build_folder import Missing, side_by_side
from cohesion_studies.foam_case import FoamCase, environment
from cohesion_tests import instruction_count
from cohesion_tests.coupling.cases import COLUMN, COUPLING, script_file, use_script
from cohesion_tests.progress import Progress

GAS_STEP, SUB_STEPS = 1e-4, 10
CELLS = "(6 6 20)"  # of 1 cm: five diameters, five spheres each
TURBULENCE = ("FoamFile { version 2.0; format ascii; class dictionary; object turbulenceProperties; }\n"
              "simulationType laminar;\n")

# feature: entries when off, entries when on; {} is what a case is that names none
FEATURES = {
    "form B": ({"form": "A"}, {"form": "B"}),
    "slip interpolated": ({"slip": "cell"}, {"slip": "interpolated"}),
    "response free": ({"response": "held"}, {"response": "free"}),
    "dragFactor": ({"dragFactor": "1"}, {"dragFactor": "0.9"}),
    "drag beetstra for syamlalOBrien": (None, {"drag": "beetstra"}),
    "kernel dividedVolume for particleCentre": (None, {"voidFraction": "dividedVolume"}),
    "kernel sphereOverlap for particleCentre": (None, {"voidFraction": "sphereOverlap"}),
    "smoothing over 3 diameters": (None, {"smoothingWidth": "6e-3"}),
    "smoothing and sphereOverlap": (None, {"smoothingWidth": "6e-3", "voidFraction": "sphereOverlap"}),
    "turbulence models, laminar": (None, {"turbulence": TURBULENCE}),
    "adjusted gas step": ({"adjustTimeStep": "no"}, {"adjustTimeStep": "yes"}),
}


def add_words(parser):
    parser.add_argument("--feature", help="those alone whose name has this in it", default="")
    parser.add_argument("--engine", choices=("lammps", "liggghts"), default="lammps")
    parser.add_argument("--steps", type=int, default=4, help="gas steps")


def small(words):
    words.steps, words.feature = 2, "slip"


def case_of(programs, folder, entries, engine, steps):
    case = FoamCase(COLUMN, Path(folder) / "case", environment(programs.build), overwrite=True)
    block = case.folder / "system/blockMeshDict"
    block.write_text(block.read_text().replace("(3 3 10)", CELLS))
    case.set(COUPLING, "demEngine", engine)
    use_script(case, "swarm", engine)
    for entry, value in (("endTime", steps * GAS_STEP), ("deltaT", GAS_STEP), ("writeInterval", 1)):
        case.set("system/controlDict", entry, value)
    for entry, value in entries.items():
        if entry == "turbulence":
            (case.folder / "constant/turbulenceProperties").write_text(value)
            transport = case.folder / "constant/transportProperties"
            transport.write_text(transport.read_text() + "transportModel Newtonian;\n")
            schemes = case.folder / "system/fvSchemes"
            schemes.write_text(re.sub(r"divSchemes\s*{", "divSchemes { div(((voidFraction*nuEff)*dev2(T(grad(U)"
                                      ")))) Gauss linear;", schemes.read_text()))
        elif entry == "adjustTimeStep":
            case.set("system/controlDict", entry, value)
            case.set("system/controlDict", "maxDeltaT", GAS_STEP)
        else:
            case.set(COUPLING, entry, value)
    case.mesh()
    return case


def spheres(case, engine):
    log = (case.folder / f"log.{engine}").read_text()
    return int(re.findall(r"Created (\d+) atoms", log)[0])


def coupled(programs, entries, engine, steps):
    """Instructions per gas step and sphere, number of spheres."""
    def counted(gas_steps):
        with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
            case = case_of(programs, folder, entries, engine, gas_steps)
            return instruction_count.of_command(["cohesiveBedFoam"], case.folder, case.env), spheres(case, engine)

    (start, number), (end, _) = side_by_side([lambda n=n: counted(n) for n in (steps, 2 * steps)])
    return (end - start) / steps / number, number


def alone(programs, engine, number, steps):
    """The same particle script without gas, in steps of the gas."""
    text = "".join(line + "\n" if not line.startswith("include") else
                   (COLUMN / line.split()[1]).read_text()
                   for line in (COLUMN / script_file("swarm", engine)).read_text().splitlines())
    text = text.replace("${dt}", str(GAS_STEP / SUB_STEPS)) + "run ${steps}\n"
    text = "\n".join(line for line in text.splitlines() if not line.startswith("fix gas")) + "\n"
    return SUB_STEPS * programs.count_per_step(engine + "+", text, SUB_STEPS, steps * SUB_STEPS) / number


def rows(programs, words):
    if not (programs.build / "openfoam/cohesiveBedFoam").is_file():
        raise Missing(f"{programs.build} has no cohesiveBedFoam: build the package with OpenFOAM first")
    chosen = {name: cases for name, cases in FEATURES.items() if words.feature in name}
    progress = Progress(2 + 2 * len(chosen))
    plain, number = coupled(programs, {}, words.engine, words.steps)
    progress.add(1)
    engine = alone(programs, words.engine, number, words.steps)
    progress.add(1)
    yield "| feature | off | on | **off/without** | on/without |"
    yield "|---|---|---|---|---|"
    yield f"| particles of {words.engine} alone, without gas | {engine:.0f} |  | {engine / plain:.3f} |  |"
    yield f"| reference: {number} spheres, {SUB_STEPS} particle steps to a gas step | {plain:.0f} |  | 1 |  |"
    for name, cases in chosen.items():
        cells = []
        for entries in cases:
            cells.append(None if entries is None else
                         coupled(programs, entries, words.engine, words.steps)[0])
            progress.add(1)
        yield (f"| {name} | " + " | ".join("" if c is None else f"{c:.0f}" for c in cells) + " | "
               + " | ".join("" if c is None else f"{c / plain:.3f}" for c in cells) + " |")
