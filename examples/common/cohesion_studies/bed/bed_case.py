# SPDX-License-Identifier: BSD-3-Clause
"""The case of a bed with parameters of its own, made of examples/fluidised-bed/case; and the run of it as a job."""

import json
import re
import shutil
from pathlib import Path

from cohesion_studies import case_job, foam_case, package_tree
from cohesion_studies.bed import figures, geometry
from cohesion_studies.bed.geometry import Geometry
from cohesion_studies.case_job import MARK
from cohesion_studies.foam_case import FoamCase
from cohesion_studies.job_pool import Job, RunError
from cohesion_studies.study_table import number


CASE = package_tree.EXAMPLES / "fluidised-bed/case"
ENGINES = ("lammps", "liggghts")
SCHEDULES = ("short", "brief", "thesis")  # of the gas velocity
GEOMETRY = ("across", "up")  # cells, of constant/bed; `width` is a variable of the script too
COUPLING, CONTROL = "constant/couplingProperties", "system/controlDict"
ENTRIES = {"voidFraction": COUPLING, "smoothingWidth": COUPLING, "deltaT": CONTROL}  # that a bed may have of its own
DERIVED = ("plugin", "seed", "node")  # variables that no row of a table gives


def case_word(parser):
    """--case."""
    parser.add_argument("--case", type=Path, metavar="FOLDER",
                        help="your own copy of the case, changed, in place of that of the example")


def use(case):
    """Beds are made of the folder `case` from here on, when it is given."""
    global CASE
    if case is not None:
        if not (case / COUPLING).is_file():
            raise RunError(f"--case '{case}' is no case of a bed: it has no {COUPLING}")
        CASE = case.resolve()


def in_case(entry):
    """Value of one of ENTRIES in the case; None when it has none."""
    found = re.search(rf"^{entry}\s+([^;\s]+);", (CASE / ENTRIES[entry]).read_text(), re.M)
    return number(found[1]) if found else None


def parameters(engine):
    """Those that a bed may have of its own, with what they are in the case: engine, schedule, ENTRIES, cells and the
    variables of its script."""
    text = (CASE / COUPLING).read_text()
    block = re.search(rf"^{engine}Coeffs\s*\{{.*?variables\s*\{{(.*?)\}}", text, re.M | re.S)[1]
    variables = dict(re.findall(r"^\s*(\w+)\s+([^;\s]+);", block, re.M))
    bed = Geometry.read(CASE)
    return {"engine": engine, "schedule": "short", **{name: in_case(name) or 0 for name in ENTRIES},
            **{name: getattr(bed, name) for name in GEOMETRY},
            **{name: number(value) for name, value in variables.items() if name not in DERIVED}}


def geometry_of(given):
    """That of a bed with the parameters `given`. Raises GeometryError."""
    bed = Geometry.read(CASE)
    return Geometry(**{name: given.get(name, getattr(bed, name)) for name in ("width", *GEOMETRY)})


def schedule_file(given):
    """In the case; the shortened one is the schedule that it runs with."""
    name = given.get("schedule", "short")
    return "constant/schedule" + ("" if name == "short" else f".{name}")


def make_case(folder, given, env):
    """The case of the parameters `given`: "engine", and of parameters() and the variables of the engine's script any
    (a smoothingWidth of 0 is none)."""
    case = FoamCase(CASE, folder, env, overwrite=True)
    (case.folder / MARK).write_text(json.dumps(given))
    engine, bed = given["engine"], geometry_of(given)
    case.set(COUPLING, "demEngine", engine)
    # Other files include these two: first of all.
    if schedule_file(given) != "constant/schedule":
        shutil.copy(case.folder / schedule_file(given), case.folder / "constant/schedule")
    if bed != Geometry.read(CASE):
        (case.folder / geometry.FILE).write_text(bed.text())
        case.set(COUPLING, f"{engine}Coeffs/variables/node", f"{bed.node:.9g}")
    for name, value in given.items():
        if name in ENTRIES:
            if value and value != in_case(name):
                case.set(ENTRIES[name], name, value)
        elif name not in ("engine", "schedule", *GEOMETRY):
            case.set(COUPLING, f"{engine}Coeffs/variables/{name}", value)
    case.mesh()
    (case.folder / "case.foam").touch()  # what ParaView opens
    return case


def work(given):
    """How long a bed takes, in the units of others: particles times their steps."""
    end = float(re.search(r"^endTime\s+([\d.]+);", (CASE / schedule_file(given)).read_text(), re.M)[1])
    known = parameters(given["engine"])
    return end * given.get("width", known["width"]) / given.get("dt", known["dt"])


class BedRun(Job):
    """One bed: its case, made anew when it starts. `mark`: fingerprint()."""

    def __init__(self, folder, given, env, mark):
        super().__init__(folder, {**given, "fingerprint": mark}, work(given), figures.programs())
        self.given, self.env = given, env

    def start(self):
        self.case = make_case(self.folder, self.given, self.env)
        return self.case.start()

    def figures(self):
        return figures.single(figures.evaluate(self.folder))

    def share(self):
        progress = self.case.progress()
        return progress[0] if progress else 0.0

    def tail(self):
        return self.case.tail()


def fingerprint(build, env):
    """Of all that a run depends on, programs included: tells an earlier run of the same. What reads its figures is not
    in it: figures.programs()."""
    own = [*(module.__file__ for module in (geometry, foam_case)), __file__]
    return case_job.fingerprint(CASE, build, env, own)
