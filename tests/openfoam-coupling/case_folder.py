# SPDX-License-Identifier: BSD-3-Clause
"""A case that is run from elsewhere, by the option -case, on 1 and 2 ranks: script, log, what the script reads
and writes, and the state that a run is continued from are those of the case, by their names relative to it; the
folder of the caller stays as it was, and the case becomes what it becomes when it is run from inside."""

import shutil
import subprocess
import unittest

from cohesion_tests.coupling.cases import CONTROL, COUPLING, ENGINE, append, script_file
from cohesion_tests.coupling.test_case import CoupledTestCase

HALF, END = 0.001, 0.002  # [s]
# Dumps are opened when they are written, in the folder that the script has gone to.
LINES = """include more.script
shell mkdir dumps
shell cd dumps
dump places all custom ${every} places.*.dump id x y z
"""


def make(column, folder, ranks):
    case = column(f"{folder}/case")
    script = case.folder / script_file("continued")
    script.write_text(script.read_text() + LINES)
    (case.folder / "more.script").write_text("variable every equal 20\n")
    append(case, COUPLING, f'{ENGINE}Coeffs {{ script "{script.name}"; log log.{ENGINE}; }}')
    append(case, CONTROL, f"startFrom latestTime; writeInterval {HALF}; writePrecision 17;")
    case.mesh()
    if ranks > 1:
        case.run("decomposePar")
    return case


def solve(case, ranks, elsewhere):
    """Runs the case and continues it; whether both went well."""
    command = ["mpirun", "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    command += ["cohesiveBedFoam"] + (["-parallel"] if ranks > 1 else [])
    command += ["-case", case.folder.name] if elsewhere else []
    # As a user has it who is in that folder
    folder = case.folder.parent if elsewhere else case.folder
    env = {name: value for name, value in case.env.items() if name != "FOAM_CASE"} | {"PWD": str(folder)}
    for end in (HALF, END):
        append(case, CONTROL, f"endTime {end};")
        found = subprocess.run(command, cwd=folder, env=env, stdin=subprocess.DEVNULL, capture_output=True,
                               text=True)
        if found.returncode != 0:
            print("\n".join((found.stdout + found.stderr).splitlines()[-12:]))
            return False
    return True


def files(folder):
    """Names of all files under the folder, relative to it."""
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())


class CaseFolder(CoupledTestCase):
    def check(self, ranks):
        cases = {elsewhere: make(self.column, f"{ranks}-{elsewhere}", ranks) for elsewhere in (False, True)}
        for elsewhere, case in cases.items():
            place = "elsewhere" if elsewhere else "the case"
            self.expect_true(f"{ranks} ranks: runs and is continued from {place}", solve(case, ranks, elsewhere))
            self.expect_equal(f"{ranks} ranks: beside the case", [path.name for path in case.folder.parent.iterdir()],
                              ["case"])
        inside, outside = (cases[elsewhere].folder for elsewhere in (False, True))
        self.expect_equal(f"{ranks} ranks: other files in the case that was run from elsewhere",
                          sorted(set(files(inside)) ^ set(files(outside))), [])
        dumps = sorted(path.name for path in (inside / "dumps").glob("places.*.dump"))
        self.expect_true(f"{ranks} ranks: the script's dumps are there", len(dumps) > 5)
        self.expect_equal(f"{ranks} ranks: dumps that differ",
                          [name for name in dumps if (inside / "dumps" / name).read_bytes()
                                                != (outside / "dumps" / name).read_bytes()], [])

    def test_from_elsewhere(self):
        shutil.rmtree(self.work, ignore_errors=True)
        for ranks in (1, 2):
            self.check(ranks)


if __name__ == "__main__":
    unittest.main()
