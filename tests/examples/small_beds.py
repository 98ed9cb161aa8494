# SPDX-License-Identifier: BSD-3-Clause
"""Studies with beds of 0.018 s, for tests: such beds have no fluidisation curve, and their figures are made up here.
The folder of the build is the first argument of the test that imports this."""

import contextlib
import io
import re
import shutil
import sys
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

import picture
import run
from cohesion_studies.bed import bed_case, figures
from cohesion_studies.study_table import number

SOURCE = Path(__file__).resolve().parents[2]
BED = SOURCE / "examples/fluidised-bed"

BUILD = Path(sys.argv.pop(1) if len(sys.argv) > 1 else SOURCE / "build").resolve()
SCHEDULE = "superficialVelocity table ((0 (0 1.2 0)) (1 (0 1.2 0)));\nendTime 0.018;\n"


def variables(case, engine="lammps"):
    """Of the particle script, as the case has them."""
    text = (Path(case) / "constant/couplingProperties").read_text()
    block = re.search(rf"{engine}Coeffs.*?variables\s*\{{(.*?)\}}", text, re.S)[1]
    return {name: number(value) for name, value in re.findall(r"(\w+)\s+([^;\s]+);", block)}


def made_up(case):
    """As figures.evaluate(), from the seed."""
    engine = re.search(r"^demEngine\s+(\w+)", (Path(case) / "constant/couplingProperties").read_text(), re.M)[1]
    pair = (variables(case, engine)["seed"], 0.1)
    velocities = types.SimpleNamespace(falling=pair, rising=pair, opening=pair, overshoot=pair)
    return {"velocities": velocities, "plateau": pair, "balance": pair, "void_fraction": pair,
            "mixing": pair, "movement": pair, "plugging": pair[0], "widest_cavity": pair[0],
            "forces": {"sides": pair[0]}, "ergun": pair,
            "noise": pair[0], "exchange_ms": pair[0], "seconds": figures.analyse.solver_seconds(case)}


class SmallBeds(unittest.TestCase):
    """A copy of the case with such a schedule, and the programs with made-up figures."""

    def setUp(self):
        keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(keeper.cleanup)
        self.folder = Path(keeper.name)
        shutil.copytree(BED / "case", self.folder / "case")
        (self.folder / "case/constant/schedule").write_text(SCHEDULE)
        for change in (mock.patch.object(bed_case, "CASE", self.folder / "case"),
                       mock.patch.object(figures, "evaluate", made_up), mock.patch.object(run, "evaluate", made_up),
                       mock.patch.object(picture, "draw")):
            change.start()
            self.addCleanup(change.stop)

    def call(self, program, *words):
        with mock.patch.object(sys, "argv", [program.__name__, *map(str, words), "--build", str(BUILD)]), \
                contextlib.redirect_stdout(io.StringIO()) as output:
            program.main()
        return output.getvalue()
