# SPDX-License-Identifier: BSD-3-Clause
"""A bed of a powder as cohesion-powder writes it, through which the gas is raised evenly and then held."""

import tempfile
from pathlib import Path

from cohesion_studies import foam_results, raised_gas
from cohesion_studies.case_job import CaseJob
from cohesion_studies.foam_case import FoamCase
from cohesion_studies.job_pool import digest_of

WRITTEN = 5  # times of a run at which fields and particles are written


class RaisedBed(CaseJob):
    """`options`: of cohesion-powder, {word: value}; `course`: `fastest` [m/s], to which the superficial velocity is raised
    from rest in the time `ramp` [s], and `hold` [s], how long it is held there; `engine`: of the particles."""

    def __init__(self, folder, kind, env, powder, options, course, work=1.0, engine="lammps"):
        self.powder, self.course, self.engine = powder, course, engine
        self.options = {**options, "--engine": engine}
        super().__init__(folder, kind, env,
                         {**self.options, **course, **self.others(), "program": digest_of([powder.file])},
                         (raised_gas, foam_results), work=work * (course["ramp"] + course["hold"]))

    def others(self):
        """What the run depends on besides, for the settings of a kind that changes the case."""
        return {}

    def copied(self):
        """As cohesion-powder writes it."""
        with tempfile.TemporaryDirectory() as scratch:
            written = Path(scratch) / "case"
            self.powder.write(written, self.options)
            return FoamCase(written, self.folder, self.env, overwrite=True)

    def change(self):
        fastest, ramp, end = self.course["fastest"], self.course["ramp"], self.course["ramp"] + self.course["hold"]
        self.case.set("0.orig/U", "boundaryField/plate/superficialVelocity",
                      f"table ((0 (0 0 0)) ({ramp} (0 0 {fastest})) ({end} (0 0 {fastest})))")
        self.case.set("0.orig/U", "internalField", "uniform (0 0 0)")
        self.case.set("system/controlDict", "endTime", end)
        self.case.set("system/controlDict", "writeInterval", end / WRITTEN)

    def figures(self):
        found = raised_gas.figures(self.folder, self.options, self.course["ramp"])
        known = self.powder.values({**self.options, "--void-fraction": found["void_fraction"]})
        return {**found, "U_mf_of_the_closure": known["u_mf_beetstra"],
                "U_mf_over_closure": found["U_mf"] / known["u_mf_beetstra"]}
