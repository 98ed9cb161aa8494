# SPDX-License-Identifier: BSD-3-Clause
"""Several processes without -parallel are refused at once, with one message, before the case is changed; one
that is started by mpirun runs."""

import subprocess
import sys

from cohesion_tests.coupling.cases import Expectations, append, column


def start(case, processes):
    return subprocess.run(["mpirun", "--oversubscribe", "-np", str(processes), "cohesiveBedFoam"],
                          cwd=case.folder, env=case.env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)


def files(case):
    return {path: path.stat().st_mtime_ns for path in case.folder.rglob("*")}


def main(build, work):
    expect = Expectations()
    case = column(work, "case", build)
    append(case, "system/controlDict", "endTime 0.001;")
    case.mesh()
    before = files(case)
    found = start(case, 2)
    said = " ".join(found.stdout.split())
    expect.true("two processes: fail", found.returncode != 0)
    for text in ("2 processes were started, without the option -parallel",
                 "Run decomposePar and 'mpirun -np 2 cohesiveBedFoam -parallel'"):
        expect.equal(f"times that they say \"{text}\"", said.count(text), 1)
    expect.true("and are not killed by a signal", "exited on signal" not in said)
    expect.equal("steps", found.stdout.count("\nTime = "), 0)
    expect.equal("files that were made or changed", sorted(map(str, files(case).items() ^ before.items())), [])

    found = start(case, 1)
    expect.equal("one process: status", found.returncode, 0)
    expect.equal("steps", found.stdout.count("\nTime = "), 10)
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:3])
