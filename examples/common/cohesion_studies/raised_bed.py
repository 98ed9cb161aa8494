# SPDX-License-Identifier: BSD-3-Clause
"""A bed of a powder as cohesion-powder writes it, through which the gas is raised evenly and then held."""

import json
import tempfile
from pathlib import Path

from cohesion_studies import foam_results, raised_gas
from cohesion_studies.foam_case import FoamCase
from cohesion_studies.job_pool import Job, digest_of

MARK = "settings.json"  # in the folder of a case that was made here: it may be made anew
WRITTEN = 5  # times of a run at which fields and particles are written


class RaisedBed(Job):
    """`options`: of cohesion-powder, {word: value}; `course`: `fastest` [m/s], to which the superficial velocity is raised
    from rest in the time `ramp` [s], and `hold` [s], how long it is held there; `engine`: of the particles."""

    def __init__(self, folder, kind, env, powder, options, course, work=1.0, engine="lammps"):
        self.kind, self.env, self.powder, self.course, self.engine = kind, env, powder, course, engine
        self.options = {**options, "--engine": engine}
        super().__init__(folder, {**self.options, **course, **self.others(), "program": digest_of([powder.file])},
                         work=work * (course["ramp"] + course["hold"]),
                         readers=digest_of([raised_gas.__file__, foam_results.__file__]))

    def others(self):
        """What the run depends on besides, for the settings of a kind that changes the case."""
        return {}

    def change(self):
        """The case `self.case` before its mesh is made."""

    def start(self):
        with tempfile.TemporaryDirectory() as scratch:
            written = Path(scratch) / "case"
            self.powder.write(written, self.options)
            self.case = FoamCase(written, self.folder, self.env, overwrite=True)
        (self.folder / MARK).write_text(json.dumps(self.settings))
        fastest, ramp, end = self.course["fastest"], self.course["ramp"], self.course["ramp"] + self.course["hold"]
        self.case.set("0.orig/U", "boundaryField/plate/superficialVelocity",
                      f"table ((0 (0 0 0)) ({ramp} (0 0 {fastest})) ({end} (0 0 {fastest})))")
        self.case.set("0.orig/U", "internalField", "uniform (0 0 0)")
        self.case.set("system/controlDict", "endTime", end)
        self.case.set("system/controlDict", "writeInterval", end / WRITTEN)
        self.change()
        self.case.mesh()
        (self.folder / "case.foam").touch()  # what ParaView opens
        return self.case.start()

    def figures(self):
        found = raised_gas.figures(self.folder, self.options, self.course["ramp"])
        known = self.powder.values({**self.options, "--void-fraction": found["void_fraction"]})
        return {**found, "U_mf_of_the_closure": known["u_mf_beetstra"],
                "U_mf_over_closure": found["U_mf"] / known["u_mf_beetstra"]}

    def share(self):
        progress = self.case.progress()
        return progress[0] if progress else 0.0

    def tail(self):
        return self.case.tail()
