# SPDX-License-Identifier: BSD-3-Clause
"""A patch whose void fraction the case fixes, while the cells at it hold particles: said once, where gas flows through
all of it."""

import re
import unittest

from cohesion_tests.coupling.cases import COUPLING, append, edit
from cohesion_tests.coupling.test_case import CoupledTestCase

DIAMETER, CELL, SPEED = 16e-3, 20e-3, 0.5  # m, m, m/s
SOLID = 3.141592653589793 / 6 * (DIAMETER / CELL) ** 3
SAID = "particles are at patches where the case fixes another void fraction"
OPEN = f"superficialVelocity (0 0 {SPEED});"
FIXED = "{ type fixedValue; value uniform 1; }"

THIRD = """vertices
(
    (0 0 0) (20 0 0) (60 0 0) (0 60 0) (20 60 0) (60 60 0)
    (0 0 200) (20 0 200) (60 0 200) (0 60 200) (20 60 200) (60 60 200)
);
blocks
(
    hex (0 1 4 3 6 7 10 9) (1 3 10) simpleGrading (1 1 1)
    hex (1 2 5 4 7 8 11 10) (2 3 10) simpleGrading (1 1 1)
);
boundary
(
    jet     { type patch; faces ((0 3 4 1)); }
    bottom  { type patch; faces ((1 4 5 2)); }
    top     { type patch; faces ((6 7 10 9) (7 8 11 10)); }
    sides   { type wall; faces ((0 1 7 6) (1 2 8 7) (2 5 11 8) (5 4 10 11) (4 3 9 10) (3 0 6 9)); }
);
"""


def make(column, name, blown=OPEN, inlet=FIXED, row=0, steps=3, mesh=True):
    """A sphere held in the middle of each cell of a row of the column."""
    case = column(name)
    (case.folder / "places").write_text("".join(
        f"create_atoms 1 single {(i + 0.5) * CELL} {(j + 0.5) * CELL} {(row + 0.5) * CELL}\n"
        for i in range(3) for j in range(3)))
    append(case, COUPLING, f'lammpsCoeffs {{ script "$FOAM_CASE/few.lmp"; variables {{ places places; period f;'
                           f' diameter {DIAMETER}; }} }}')
    append(case, "system/controlDict", f"endTime {steps * 1e-4}; writeInterval {steps * 1e-4};")
    edit(case, "0.orig/U", "superficialVelocity (0 0 0);", blown)
    edit(case, "0.orig/voidFraction", "bottom  { type zeroGradient; }", f"bottom  {inlet}")
    if mesh:
        case.mesh()
    return case


class InletVoidFraction(CoupledTestCase):
    def test_quiet(self):
        for number, (what, words) in enumerate({
                "zero gradient": {"inlet": "{ type zeroGradient; }"},
                "jets": {"blown": OPEN + " share 0.5;"},
                "no flow": {"blown": "superficialVelocity (0 0 0);"},
                "no particles at it": {"row": 3},
                "the void fraction of the cells": {"inlet": f"{{ type fixedValue; value uniform {1 - SOLID}; }}"},
        }.items()):
            log = make(self.column, f"quiet-{number}", **words).solve()
            self.expect_equal(f"{what}: warnings", log.count(SAID), 0)

    def loud(self, ranks):
        what = f"particles at it, {ranks} ranks"
        log = make(self.column, f"loud-{ranks}").solve(ranks=ranks)
        self.expect_equal(f"{what}: warnings", log.count(SAID), 1)
        found = re.search(rf"{SAID} .*, in the mean: (\S+) \((\S+)\)\n", log)
        self.expect_true(f"{what}: says where and by how much", bool(found))
        if found:
            self.expect_equal(f"{what}: patch", found[1], "bottom")
            # Six digits are printed.
            self.expect_near(f"{what}: difference", float(found[2]), SOLID, 1e-6)
        for part in ("type zeroGradient", "superficialVelocity"):
            self.expect_true(f"{what}: says {part}", part in log.split(SAID)[-1].split("Time =")[0])

    def part_of_the_bottom(self, beside, warnings):
        """A third of the bottom is a patch of its own and blows; `beside`, the velocity of the gas in the rest
        [m/s]."""
        name = f"part-{warnings}"
        case = make(self.column, name, blown=f"superficialVelocity (0 0 {beside});", inlet="{ type zeroGradient; }",
                    mesh=False)
        dictionary = case.folder / "system/blockMeshDict"
        dictionary.write_text(dictionary.read_text().split("vertices")[0] + THIRD)
        for field, words in (("U", f"type superficialVelocity; {OPEN}"), ("p",
                                                                          "type fixedFluxPressure; value uniform 0;"),
                             ("voidFraction", FIXED.strip("{}"))):
            edit(case, f"0.orig/{field}", "bottom  {", f"jet {{ {words} }}\n    bottom  {{")
        case.mesh()
        log = case.solve()
        self.expect_equal(f"{beside} m/s beside a third that blows {SPEED} m/s: warnings", log.count(SAID), warnings)

    def test_arriving(self):
        """From the second row they come into the first at 1e-3 s."""
        case = make(self.column, "arriving", row=1, steps=15)
        script = case.folder / "few.lmp"
        script.write_text(script.read_text() + "fix down all move linear 0 0 -10\n")
        log = case.solve()
        self.expect_equal("arriving: warnings", log.count(SAID), 1)
        times = [float(time) for time in re.findall(r"^Time = (\S+)", log.split(SAID)[0], re.M)]
        # They are there at the end of the step to 1e-3 s or one later, by round-off; the next step sees them.
        self.expect_near("arriving: time of the warning [s]", times[-1], 1.15e-3, 0.6e-4)

    def test_loud(self):
        for ranks in (1, 2):
            self.loud(ranks)

    def test_part_of_the_bottom(self):
        self.part_of_the_bottom(beside=0, warnings=0)
        self.part_of_the_bottom(beside=SPEED, warnings=1)


if __name__ == "__main__":
    unittest.main()
