# SPDX-License-Identifier: BSD-3-Clause
"""Entries of constant/couplingProperties that nothing reads stop the solver before the particles' script runs, with
the nearest known one; entries of the user's own, for macros, do not."""

import re
import sys

from bad_input import edit
from coupled_case import COUPLING, SOURCE, CaseError, Expectations, append, column

DOCUMENTED = SOURCE / "docs/openfoam-coupling/cohesiveBedFoam.md"

# name: (what makes the case bad, parts of the message)
REFUSED = {
    "letters of another case": (
        lambda c: append(c, COUPLING, "dragfactor 2; smoothingwidth 0.01; minVoidfraction 0.4;"),
        ["unknown entry 'dragfactor' (the nearest known one is 'dragFactor'), 'smoothingwidth' (the nearest known one"
         " is 'smoothingWidth'), 'minVoidfraction' (the nearest known one is 'minVoidFraction')",
         "Known are demEngine,", "couplingProperties"]),
    "misspelt entry that is required": (
        lambda c: edit(c, COUPLING, "drag  ", "darg  "),
        ["unknown entry 'darg' (the nearest known one is 'drag')"]),
    "word of another program": (
        lambda c: append(c, COUPLING, "couplingInterval 10;"),
        ["unknown entry 'couplingInterval'"]),
    "dictionary of no engine": (
        lambda c: append(c, COUPLING, "lamppsCoeffs { script \"particles.lmp\"; }"),
        ["unknown entry 'lamppsCoeffs' (the nearest known one is 'lammpsCoeffs')"]),
    "entry of the engine": (
        lambda c: append(c, COUPLING, "lammpsCoeffs { logfile \"log\"; }"),
        ["unknown entry 'logfile' (the nearest known one is 'log')", "Known are script, log, variables, library",
         "couplingProperties.lammpsCoeffs"]),
    "entry of the other engine": (
        lambda c: append(c, COUPLING, "liggghtsCoeffs { variable { dt 1e-5; } }"),
        ["unknown entry 'variable' (the nearest known one is 'variables')", "couplingProperties.liggghtsCoeffs"]),
    "misspelt entry of an included file": (
        lambda c: ((c.folder / "constant/mine").write_text("width 0.06; dragfactor 2;\n"),
                   append(c, COUPLING, '#include "mine"')),
        ["unknown entry 'dragfactor' (the nearest known one is 'dragFactor')"]),
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


def allows(expect, case, name, entries):
    case.mesh()
    append(case, "system/controlDict", "endTime 1e-4;")
    (case.folder / "constant/mine").write_text("width 0.06; fluid air; from 3; step 1e-5;\n")
    append(case, COUPLING, entries)
    try:
        case.solve()
        expect.true(f"{name}: runs", True)
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
    if all("Known are" in logs[name] for name in ("word of another program", "entry of the engine")):
        known_words(expect, logs["word of another program"])
    for number, (name, entries) in enumerate(ALLOWED.items()):
        allows(expect, column(work, f"allowed-{number}", build), name, entries)
    on_ranks(expect, column(work, "ranks", build))
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:3])
