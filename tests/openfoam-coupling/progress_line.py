# SPDX-License-Identifier: BSD-3-Clause
"""Share done and time left in the solver's log: few digits, and never less than nothing left, also where the last step
reaches beyond the end."""

import re
import sys

from cohesion_tests.coupling.cases import Expectations, append, column


def main(build, work):
    expect = Expectations()
    case = column(work, "case", build)
    # OpenFOAM ends half a step beside the end at most: three steps of 1e-4.
    append(case, "system/controlDict", "endTime 2.6e-4; writeInterval 1e-4;")
    case.mesh()
    log = case.solve()
    found = re.findall(r"^Time = \S+ +\((\S+) %, (\S+) s elapsed, about (\S+) s left\)$", log, re.M)
    expect.equal("shares done [%]", [words[0] for words in found], ["38.46", "76.92", "100.00"])
    for words in found:
        expect.true(f"times {words[1]} and {words[2]}: one decimal, none negative",
                    all(re.fullmatch(r"\d+\.\d", word) for word in words[1:]))
    expect.equal("as programs read it", case.progress(), (1.0, 0.0))
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:3])
