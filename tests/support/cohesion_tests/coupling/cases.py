# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the coupling share. Every driver is called as
    driver.py BUILD_FOLDER WORK_FOLDER [ENGINE]
and exits non-zero when an expectation failed. ENGINE is the particle engine, lammps unless given; the
scripts of the others have their names as ending."""

import re
import sys
from pathlib import Path

from cohesion_studies.foam_case import FoamCase, environment
from cohesion_tests import SOURCE

COUPLING = "constant/couplingProperties"
ENGINES = ("lammps", "liggghts")
ENGINE = next((word for word in sys.argv[3:] if word in ENGINES), ENGINES[0])
COLUMN = Path(__file__).resolve().parent / "column"
BED = SOURCE / "examples/fluidised-bed"


class Expectations:
    """Prints each expectation; exit() ends the program with their verdict."""

    def __init__(self):
        self.failed = 0

    def below(self, what, found, limit):
        self._report(found < limit, f"{what}: {found:.4g}, must be below {limit:.4g}")

    def near(self, what, found, expected, tolerance):
        self._report(abs(found - expected) <= tolerance,
                     f"{what}: {found:.10g}, expected {expected:.10g} +- {tolerance:.2g}")

    def equal(self, what, found, expected):
        self._report(found == expected, f"{what}: {found!r}, expected {expected!r}")

    def true(self, what, condition):
        self._report(condition, what)

    def _report(self, right, text):
        print(("ok      " if right else "FAILED  ") + text)
        self.failed += not right

    def exit(self):
        sys.exit(1 if self.failed else 0)


def column(work, name, build, engine=ENGINE):
    """The column case, fresh, under work/name."""
    case = FoamCase(COLUMN, Path(work) / name, environment(build), overwrite=True)
    case.set(COUPLING, "demEngine", engine)
    return case


def append(case, file, text):
    """Adds to a dictionary, faster than case.set(): OpenFOAM takes the last of equal entries and merges equal
    dictionaries."""
    with open(case.folder / file, "a") as dictionary:
        dictionary.write(text + "\n")


def script_file(name, engine=ENGINE):
    """Of the script called `name` in column/."""
    return f"{name}.{'lmp' if engine == 'lammps' else engine}"


def use_script(case, name, engine=ENGINE):
    case.set(COUPLING, f"{engine}Coeffs/script", f'"$FOAM_CASE/{script_file(name, engine)}"')


def use_lattice(case, variables):
    """The script lattice.lmp with these variables, {name: value}, all their digits."""
    append(case, COUPLING, f"""lammpsCoeffs
{{
    script "$FOAM_CASE/lattice.lmp";
    variables {{ {' '.join(f'{name} "{value!r}";' for name, value in variables.items())} }}
}}""")


def make_periodic(case):
    """Periodic faces in the place of the column's walls in x."""
    mesh = case.folder / "system/blockMeshDict"
    walls = "    sides   { type wall;  faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); }"
    assert walls in mesh.read_text()
    mesh.write_text(mesh.read_text().replace(
        walls, "    sides   { type wall; faces ((0 1 5 4) (2 3 7 6)); }\n"
               "    left    { type cyclic; neighbourPatch right; faces ((3 0 4 7)); }\n"
               "    right   { type cyclic; neighbourPatch left; faces ((1 2 6 5)); }"))
    for file in (case.folder / "0.orig").iterdir():
        file.write_text(file.read_text().replace(
            "    top ", "    left { type cyclic; }\n    right { type cyclic; }\n    top "))


def disturb(case, script, by, engine=ENGINE):
    """Makes the velocities that a script of a swarm creates larger by the share `by`. What that does to
    the end of a run is a yardstick: two runs that should be the same, but for rounding and for what
    solvers leave, have to be nearer to each other than to the disturbed one. Collisions make both
    differences grow alike."""
    path = case.folder / script_file(script, engine)
    text = path.read_text()
    # A temperature goes with the square of the velocity.
    for words, power in (("create ", 2), ("speed equal ", 1)):
        changed, found = re.subn(
            rf"\b({words})([\d.e+-]+)", lambda m: m[1] + repr(float(m[2]) * (1 + by) ** power), text)
        if found == 1:
            path.write_text(changed)
            return
    raise AssertionError(f"{path} sets no velocities, or not in one place")


def exchange_lines(log):
    """Per gas step: dict of imbalance, solid volume error and the z force of drag and pressure."""
    number = r"([-+.\deE]+)"
    pattern = (rf"Exchange: drag on particles \({number} {number} {number}\) N, pressure "
               rf"\({number} {number} {number}\) N, not yet charged to the gas \([^)]*\) N, "
               rf"imbalance {number}, solid volume error {number}")
    return [
        {"drag": [float(x) for x in m[:3]], "pressure": [float(x) for x in m[3:6]],
         "imbalance": float(m[6]), "volume": float(m[7])}
        for m in re.findall(pattern, log)
    ]


def drag_report(log):
    """Of the table at the end: evaluations of the drag law, and how many were where it was not fitted."""
    found = re.search(r"evaluations +(\S+)\s+outside +(\d\S*),", log)
    return float(found[1]), float(found[2])
