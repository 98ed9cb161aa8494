# SPDX-License-Identifier: BSD-3-Clause
"""A run of OpenFOAM's twoPhaseEulerFoam with the two-fluid models of this package, in a case folder of its own."""

import json
import re
import subprocess

from cohesion_studies import package_tree
from cohesion_studies.build_summary import missing
from cohesion_studies.case_job import MARK
from cohesion_studies.foam_case import FoamCase
from cohesion_studies.job_pool import Job, RunError, dies_with_us, digest_of

SOLVER, LIBRARY = "twoPhaseEulerFoam", "openfoam/libcohesionTwoFluid.so"


def require_library(build):
    """Raises RunError where the models have not been built."""
    reason = missing(package_tree.tree(build), LIBRARY, "two-fluid models")
    if reason:
        raise RunError(reason)


class TwoFluidJob(Job):
    """`kind`, `env`, `settings`, `readers` and `work` as in CaseJob, `end` the time that it simulates [s]. To be defined
    by a kind of run: change(), solid(), figures()."""

    case = None

    def __init__(self, folder, kind, env, build, template, settings, end, readers, work=1.0):
        self.kind, self.env, self.template, self.end = kind, env, template, end
        mark = digest_of([*template.rglob("*"), package_tree.tree(build) / LIBRARY])
        super().__init__(folder, {**settings, "time": end, "fingerprint": mark}, work=work,
                         readers=digest_of([module.__file__ for module in readers]))

    def change(self):
        """What the settings change of the case, by case.edit(), before its mesh is made."""

    def solid(self):
        """Solid fraction at the start in each cell, in OpenFOAM's order of rows of columns; any shape."""
        raise NotImplementedError

    def prepare(self):
        self.case = FoamCase(self.template, self.folder, self.env, overwrite=True)
        (self.folder / MARK).write_text(json.dumps(self.settings))
        self.change()
        self.case.mesh()
        self.fill()
        (self.folder / "case.foam").touch()

    def fill(self):
        solid = self.solid().ravel()
        for name, values in (("alpha.air", 1 - solid), ("alpha.particles", solid)):
            file = self.folder / "0" / name
            words = f"nonuniform List<scalar> {len(values)} ({' '.join(f'{value:.8g}' for value in values)})"
            file.write_text(re.sub(r"internalField uniform \d;", f"internalField {words};", file.read_text()))

    def start(self):
        self.prepare()
        with open(self.case.log(SOLVER), "w") as log:
            return subprocess.Popen(dies_with_us([SOLVER]), cwd=self.folder, env=self.case.env, stdout=log, stderr=log,
                                    stdin=subprocess.DEVNULL)

    def share(self):
        with open(self.case.log(SOLVER), "rb") as log:
            log.seek(0, 2)
            log.seek(max(0, log.tell() - 4000))
            found = re.findall(r"^Time = (\S+)", log.read().decode(errors="replace"), re.M)
        return float(found[-1]) / self.end if found else 0.0

    def tail(self):
        return self.case.tail(SOLVER)
