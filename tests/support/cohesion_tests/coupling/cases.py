# SPDX-License-Identifier: BSD-3-Clause
"""The column, a case of few cells that most tests of the coupling change and run, and what cohesiveBedFoam says in its
log. The environment may name the particle engine, COHESION_ENGINE: lammps unless given. Scripts of the engines have
their names as ending."""

import functools
import os
import re
import shutil
from pathlib import Path

from cohesion_studies.foam_case import FoamCase, environment
from cohesion_tests import SOURCE

COUPLING, CONTROL = "constant/couplingProperties", "system/controlDict"
ENGINES = ("lammps", "liggghts")
ENGINE = os.environ.get("COHESION_ENGINE", ENGINES[0])
COLUMN = Path(__file__).resolve().parent / "column"
BED = SOURCE / "examples/fluidised-bed"


class ColumnCase(FoamCase):
    """Entries of its dictionaries are set by what is appended to them."""

    def set(self, file, entry, value):
        """As of FoamCase, without the start of a program: "a/b/c" is the entry c of the dictionary b in a."""
        *dictionaries, name = re.findall(r'"[^"]*"|[^/]+', entry)
        text = f"{name} {value};"
        for dictionary in reversed(dictionaries):
            text = f"{dictionary} {{ {text} }}"
        append(self, file, text)

    meshes = None  # those made before, and their output: files by their place, by the text of their dictionaries

    def mesh(self):
        """As of FoamCase; a mesh that has been made of the same dictionaries is copied."""
        made_of = "".join((self.folder / "system" / file).read_text() for file in ("blockMeshDict", "controlDict"))
        mesh = self.folder / "constant/polyMesh"
        if made_of in self.meshes:
            mesh.mkdir(exist_ok=True)
            for place, content in self.meshes[made_of].items():
                (self.folder / place).write_bytes(content)
            shutil.copytree(self.folder / "0.orig", self.folder / "0", dirs_exist_ok=True)
        else:
            super().mesh()
            self.meshes[made_of] = {file.relative_to(self.folder): file.read_bytes()
                                    for file in (*mesh.iterdir(), self.log("blockMesh"))}


class Columns:
    """Makes column cases, fresh, in folders of their own within `work`; with the programs of the build folder `build`.
    What makes a case of its own takes one of these, or what does the same, as `column`."""

    def __init__(self, build, work):
        self.build, self.work, self.meshes = build, Path(work), {}

    @functools.cached_property
    def environment(self):
        return environment(self.build)

    def __call__(self, name, engine=ENGINE):
        case = ColumnCase(COLUMN, self.work / name, self.environment, overwrite=True)
        case.meshes = self.meshes
        if engine != ENGINES[0]:
            case.set(COUPLING, "demEngine", engine)
        return case


def append(case, file, text):
    """Adds to a dictionary: OpenFOAM takes the last of equal entries and merges equal dictionaries."""
    with open(case.folder / file, "a") as dictionary:
        dictionary.write(text + "\n")


def edit(case, file, old, new):
    """Replaces a text that a file of the case must have."""
    path = case.folder / file
    text = path.read_text()
    assert old in text, f"{file} has no '{old}'"
    path.write_text(text.replace(old, new))


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
    edit(case, "system/blockMeshDict",
         "    sides   { type wall;  faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); }",
         "    sides   { type wall; faces ((0 1 5 4) (2 3 7 6)); }\n"
         "    left    { type cyclic; neighbourPatch right; faces ((3 0 4 7)); }\n"
         "    right   { type cyclic; neighbourPatch left; faces ((1 2 6 5)); }")
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
