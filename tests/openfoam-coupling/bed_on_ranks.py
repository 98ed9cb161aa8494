# SPDX-License-Identifier: BSD-3-Clause
"""The cohesive bed in a quarter of its width, 0.02 s on 1 and on 2 ranks, cells cut across the height and particles
along it: same number of particles, same bed height, same pressure drop. Both start from one settled packing:
pouring is chaotic, and its round-off would be compared instead."""

import re
import subprocess
import unittest

from cohesion_studies.bed import analyse
from cohesion_studies.foam_case import FoamCase, environment
from cohesion_tests.coupling.cases import BED
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.narrow_bed import SHARE, make_narrow

SETTINGS = {"plugin": "cohesionplugin.so", "A": 7.49e-19, "dt": 1.125e-5, "node": 3.333e-3, "seed": 4711,
            "width": 0.08 / SHARE}
COMPARED = ("time", "velocity", "drop", "weight", "height")


def settle(env, work):
    """Pours and settles on one rank; returns the data file of the packing."""
    work.mkdir(parents=True, exist_ok=True)
    script = (BED / "case/bed.lmp").read_text() + "\nwrite_data settled.data\n"
    (work / "pour.lmp").write_text(script)
    command = ["lmp-cohesion", "-in", "pour.lmp", "-screen", "none"]
    for name, value in dict(SETTINGS, settle=0.15).items():
        command += ["-var", name, str(value)]
    subprocess.run(command, cwd=work, env=env, check=True)
    return work / "settled.data"


def run(env, packing, work, ranks):
    case = FoamCase(BED / "case", work / f"ranks-{ranks}", env, overwrite=True)
    make_narrow(case.folder)
    script = (BED / "case/bed.lmp").read_text()
    poured = re.search(r"^region       box.*^displace_atoms.*?$", script, re.M | re.S)
    (case.folder / "bed.lmp").write_text(
        script.replace(poured.group(0), f"read_data {packing} nocoeff"))
    case.set("constant/couplingProperties", "lammpsCoeffs/variables/A", SETTINGS["A"])
    case.set("constant/couplingProperties", "lammpsCoeffs/variables/settle", 0)
    # Below minimum fluidisation: the packing stays, so that round-off does not grow into chaos.
    (case.folder / "constant/schedule").write_text(
        "superficialVelocity table ((0 (0 0.5 0)) (1 (0 0.5 0)));\nendTime 0.0199;\n")
    # The meshes of the ranks are written and read again: all digits, and as sharp a pressure.
    case.set("system/controlDict", "writePrecision", 16)
    for solver in ("p", "pFinal"):
        case.set("system/fvSolution", f"solvers/{solver}/tolerance", 1e-13)
        case.set("system/fvSolution", f"solvers/{solver}/relTol", 0)
    case.mesh()
    case.solve(ranks=ranks)
    found = analyse.read_traces(case.folder)
    traces = {name: getattr(found, name)[-1] for name in COMPARED}
    log = (case.folder / "log.lammps").read_text()
    atoms = re.findall(r"^\s*\d+\s+(\d+)\s+\S+\s*$", log, re.M)[-1]
    return int(atoms), traces


class BedOnRanks(CoupledTestCase):
    def test_same_on_two_ranks(self):
        env = environment(self.build)
        packing = settle(env, self.work)
        (n1, t1), (n2, t2) = (run(env, packing, self.work, ranks) for ranks in (1, 2))
        self.expect_equal("particles on 2 ranks", n2, n1)
        self.expect_equal("particles", n1, 1000)
        # The pressure is solved to 1e-13 of the sum of its fluxes in each of 44 steps; a factor 1e4 is
        # left for growth in the packing. Weight and height are printed in steps of 1e-7.
        tolerance = 44 * 1e-13 * 1e4
        printed = {"weight": 1.01e-7, "height": 1.01e-7}
        for what in COMPARED:
            self.expect_near(f"{what}, 2 ranks against 1", t2[what], t1[what],
                             tolerance * abs(t1[what]) + printed.get(what, 0))
        self.expect_true("the gas presses", t1["drop"] > 100)


if __name__ == "__main__":
    unittest.main()
