# SPDX-License-Identifier: BSD-3-Clause
"""Entries of constant/couplingProperties that are nearly known ones stop the solver before the particles' script runs,
with the nearest known one; of others that nothing reads a warning gives the names; entries for macros are silent."""

import re
import sys

from cohesion_studies.foam_case import CaseError
from cohesion_tests import SOURCE
from cohesion_tests.coupling.cases import COUPLING, Expectations, append, column

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
         "couplingProperties.lammpsCoeffs"]),
    "entry of the other engine": (
        lambda c: append(c, COUPLING, "liggghtsCoeffs { variable { dt 1e-5; } }"),
        ["unknown entry 'variable' (the nearest known one is 'variables')", "couplingProperties.liggghtsCoeffs"]),
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


def known_words(expect, log):
    """The list in the message and the page's are the same."""
    said = re.search(r"Known are ([^\n]*)\n", log)[1].split(", ")
    expect.equal("entries on the page", sorted(words_of("## constant/couplingProperties\n\n")), sorted(said))


def refuses(expect, case, name, spoil, parts):
    case.mesh()
    spoil(case)
    try:
        case.solve()
        expect.true(f"{name}: stops", False)
    except CaseError:
        pass
    log = case.log("cohesiveBedFoam").read_text()
    for part in parts:
        expect.true(f"{name}: says \"{part}\"", part in " ".join(log.split()))
    expect.true(f"{name}: before the script runs", not (case.folder / "log.lammps").exists())
    return log


def allows(expect, case, name, entries, warning=()):
    """Runs, with one warning of these parts or without one."""
    case.mesh()
    append(case, "system/controlDict", "endTime 1e-4;")
    (case.folder / "constant/mine").write_text("width 0.06; fluid air; from 3; step 1e-5;\n")
    append(case, COUPLING, entries)
    try:
        log = case.solve()
        expect.equal(f"{name}: warnings", log.count("unknown entry"), 1 if warning else 0)
        for part in warning:
            expect.true(f"{name}: says \"{part}\"", part in " ".join(log.split()))
    except CaseError as error:
        print(error)
        expect.true(f"{name}: runs", False)


def on_ranks(expect, case):
    case.mesh()
    append(case, COUPLING, "dragfactor 2;")
    try:
        case.solve(ranks=2)
        expect.true("two ranks: stop", False)
    except CaseError:
        expect.true("two ranks: stop", "unknown entry 'dragfactor'" in case.log("cohesiveBedFoam").read_text())


def main(build, work):
    expect = Expectations()
    logs = {name: refuses(expect, column(work, f"refused-{number}", build), name, spoil, parts)
            for number, (name, (spoil, parts)) in enumerate(REFUSED.items())}
    if all("Known are" in logs[name] for name in ("letters of another case", "entry of the engine")):
        known_words(expect, logs["letters of another case"])
    for number, (name, entries) in enumerate(ALLOWED.items()):
        allows(expect, column(work, f"allowed-{number}", build), name, entries)
    for number, (name, (entries, parts)) in enumerate(WARNED.items()):
        allows(expect, column(work, f"warned-{number}", build), name, entries, parts)
    on_ranks(expect, column(work, "ranks", build))
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:3])
