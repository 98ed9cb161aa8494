# SPDX-License-Identifier: BSD-3-Clause
"""Entries of constant/couplingProperties that are nearly known ones stop the solver before the particles' script runs,
with the nearest known one; of others that nothing reads a warning gives the names; entries for macros are silent."""

import re
import unittest

from cohesion_tests import SOURCE
from cohesion_tests.coupling.cases import COUPLING, append
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.refusals import assert_says

DOCUMENTED = SOURCE / "docs/openfoam-coupling/cohesiveBedFoam.md"

# name: (what makes the case bad, parts of the message)
REFUSED = {
    "letters of another case": (
        lambda c: append(c, COUPLING, "dragfactor 2; smoothingwidth 0.01; minVoidfraction 0.4;"),
        ["unknown entry 'dragfactor' (the nearest known one is 'dragFactor'), 'smoothingwidth' (the nearest known one"
         " is 'smoothingWidth'), 'minVoidfraction' (the nearest known one is 'minVoidFraction')",
         "Known are demEngine,", "couplingProperties"]),
    "dictionary of no engine": (
        lambda c: append(c, COUPLING, "lamppsCoeffs { script \"particles.lmp\"; }"),
        ["unknown entry 'lamppsCoeffs' (the nearest known one is 'lammpsCoeffs')"]),
    "entry of the engine": (
        lambda c: append(c, COUPLING, "lammpsCoeffs { scripts \"log\"; }"),
        ["unknown entry 'scripts' (the nearest known one is 'script')", "Known are script, log, variables, library",
         "couplingProperties/lammpsCoeffs"]),
    "entry of the other engine": (
        lambda c: append(c, COUPLING, "liggghtsCoeffs { variable { dt 1e-5; } }"),
        ["unknown entry 'variable' (the nearest known one is 'variables')", "couplingProperties/liggghtsCoeffs"]),
    "misspelt entry of an included file": (
        lambda c: ((c.folder / "constant/mine").write_text("width 0.06; dragfactor 2;\n"),
                   append(c, COUPLING, '#include "mine"')),
        ["unknown entry 'dragfactor' (the nearest known one is 'dragFactor')"]),
}

# name: (entries, parts of the warning)
WARNED = {
    "word of another program": ("couplingInterval 10;", ["unknown entry 'couplingInterval' (", "Known are demEngine,"]),
    "entry of another program's engine": ("lammpsCoeffs { logfile \"log\"; }", ["unknown entry 'logfile' ("]),
    # As foamDictionary -set leaves them: one letter less is as near a short known word as they are.
    "own entries after macros and what is included are put in their places": (
        "step 1e-5; from 3; bed { width 0.06; }", ["'step' (", "'from' (", "'bed' ("]),
}

ALLOWED = {
    "own entries that a $ takes up": (
        'step 1e-5; bed { width 0.06; factor 2; } forceOf A; form $forceOf;\n'
        'lammpsCoeffs { where "$FOAM_CASE/particles.lmp"; script ${where}; variables { dt $step; width $:bed.width; } }'
        '\ndragFactor $:bed.factor;'),
    "own entries of an included file": '#include "mine"\nlammpsCoeffs { variables { dt $step; } }',
    "all that is known": (
        'form A; dragFactor 1; response held; slip cell; smoothingWidth 0.02; minVoidFraction 0.2;\n'
        'drag ergunWenYu; dragExponent 3.7; particleGravity same;\nliggghtsCoeffs { library "none"; }'),
    "a pattern for known words": '"(lammps|liggghts)Coeffs" { variables { width 0.06; } }',
    "directives": (
        'theForm A;\n#ifeq $theForm A\nslip cell;\n#else\nslip interpolated;\n#endif\n#remove theForm\n'
        '#includeIfPresent "mine"'),
}


def words_of(table):
    """Names in the first column of the table that follows a line of the page."""
    rows = DOCUMENTED.read_text().split(table)[1].split("\n\n")[0]
    return {name for row in rows.splitlines()[2:] for name in re.findall(r"`(\w+)`", row.split("|")[1])}


class UnknownEntries(CoupledTestCase):
    def allows(self, case, name, entries, warning=()):
        """Runs, with one warning of these parts or without one."""
        case.mesh()
        append(case, "system/controlDict", "endTime 1e-4;")
        (case.folder / "constant/mine").write_text("width 0.06; fluid air; from 3; step 1e-5;\n")
        append(case, COUPLING, entries)
        with self.subTest(name):
            log = case.solve()
            self.expect_equal(f"{name}: warnings", log.count("unknown entry"), 1 if warning else 0)
            assert_says(self, log, *warning)

    def test_refused(self):
        logs = {}
        for number, (name, (spoil, parts)) in enumerate(REFUSED.items()):
            case = self.column(f"refused-{number}")
            case.mesh()
            spoil(case)
            logs[name] = self.refused(name, case, *parts)
            self.expect_true(f"{name}: before the script runs", not (case.folder / "log.lammps").exists())
        # The list in the message and the page's are the same.
        said = re.search(r"Known are ([^\n]*)\n", logs["letters of another case"])[1].split(", ")
        self.expect_equal("entries on the page", sorted(words_of("## constant/couplingProperties\n\n")), sorted(said))

    def test_allowed(self):
        for number, (name, entries) in enumerate(ALLOWED.items()):
            self.allows(self.column(f"allowed-{number}"), name, entries)

    def test_warned(self):
        for number, (name, (entries, parts)) in enumerate(WARNED.items()):
            self.allows(self.column(f"warned-{number}"), name, entries, parts)

    def test_two_ranks(self):
        case = self.column("ranks")
        case.mesh()
        append(case, COUPLING, "dragfactor 2;")
        self.refused("two ranks", case, "unknown entry 'dragfactor'", ranks=2)


if __name__ == "__main__":
    unittest.main()
