# SPDX-License-Identifier: BSD-3-Clause
"""Several processes without -parallel are refused at once, with one message, before the case is changed; one
that is started by mpirun runs."""

import subprocess
import unittest

from cohesion_tests.coupling.cases import append
from cohesion_tests.coupling.test_case import CoupledTestCase


def start(case, processes):
    return subprocess.run(["mpirun", "--oversubscribe", "-np", str(processes), "cohesiveBedFoam"],
                          cwd=case.folder, env=case.env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)


def files(case):
    return {path: path.stat().st_mtime_ns for path in case.folder.rglob("*")}


class SeveralProcesses(CoupledTestCase):
    def test_refused_without_parallel(self):
        case = self.column("case")
        append(case, "system/controlDict", "endTime 0.001;")
        case.mesh()
        before = files(case)
        found = start(case, 2)
        said = " ".join(found.stdout.split())
        self.expect_true("two processes: fail", found.returncode != 0)
        for text in ("2 processes were started, without the option -parallel",
                     "Run decomposePar and 'mpirun -np 2 cohesiveBedFoam -parallel'"):
            self.expect_equal(f"times that they say \"{text}\"", said.count(text), 1)
        self.expect_true("and are not killed by a signal", "exited on signal" not in said)
        self.expect_equal("steps", found.stdout.count("\nTime = "), 0)
        self.expect_equal("files that were made or changed", sorted(map(str, files(case).items() ^ before.items())), [])

        found = start(case, 1)
        self.expect_equal("one process: status", found.returncode, 0)
        self.expect_equal("one process: steps", found.stdout.count("\nTime = "), 10)


if __name__ == "__main__":
    unittest.main()
