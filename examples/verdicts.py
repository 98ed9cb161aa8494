#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes one page for each source of the examples from verdicts.csv: the number of claims by verdict, and the claims that
differ. `--check` writes nothing and fails if a page is not current."""
import argparse
import csv
import re
import sys
from collections import Counter
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[1]
TABLE = SOURCE / "examples/verdicts.csv"
COLUMNS = ["source", "place", "claim", "quote", "run", "verdict", "why", "where"]
VERDICTS = ("agrees", "differs", "cannot tell", "not run")
WORDS = 400  # of a page
CLAIM, QUOTE = 15, 25  # words

#: Source: page, title, reference, conclusion.
SOURCES = {
    "Weber 2004": (
        "docs/verification/source_weber.md", "Claims of M. Weber's thesis",
        "M. Weber, *Simulation of Cohesive Particle Flows in Granular and Gas-Solid Systems*, PhD thesis, University of\n"
        "Colorado, 2004",
        "The examples reproduce the regimes of sheared agglomerates, the equal escape velocities of both laws, and the\n"
        "overshoot that Hamaker attraction causes. Square wells cause no overshoot here. Laws of equal escape velocity\n"
        "give different beds with *exact* contacts: beds at rest depend on the pull-off force."),
    "Hoomans et al. 1996": (
        "docs/verification/source_hoomans.md", "Claims of Hoomans et al.",
        "Hoomans, Kuipers, Briels, van Swaaij, Chem. Eng. Sci. 51 (1996) 99",
        "The examples reproduce the poured bed, the minimum fluidisation velocity, and slugs with dissipation.\n"
        "Without dissipation slugs depend on the start of the bed. The height of the ideal bed fluctuates here, and one of\n"
        "ten seeds exceeds the error of the energy.\n"
        "A bed with a weak jet has cracks, and the slugging bed has twice the collisions."),
    "van der Hoef et al. 2006": (
        "docs/verification/source_van_der_hoef.md", "Claims of van der Hoef et al.",
        "van der Hoef, Ye, van Sint Annaland, Andrews, Sundaresan, Kuipers, Adv. Chem. Eng. 31 (2006) 65",
        "The examples reproduce the drag of arrays and clusters and the pressure of hard-sphere fluids. The pressure of\n"
        "inelastic spheres deviates by up to 7 %. Two-fluid beds of Geldart A powder expand more than in the source."),
}


def read(file=TABLE):
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def faults(row):
    """Why a row of the table is not valid."""
    found = [f"no {name}" for name in COLUMNS if not row.get(name)]
    if row["source"] not in SOURCES:
        found.append(f"unknown source: {row['source']}")
    if row["verdict"] not in VERDICTS:
        found.append(f"unknown verdict: {row['verdict']}")
    found += [f"{name}: more than {limit} words" for name, limit in (("claim", CLAIM), ("quote", QUOTE))
              if len(row[name].split()) > limit]
    if not (SOURCE / row["where"] / "README.md").exists():
        found.append(f"no page in {row['where']}")
    return found


def words(text):
    """Number of words, without the marks of tables."""
    return len(re.findall(r"[^\s|]*\w[^\s|]*", text))


def link(where):
    return f"[{Path(where).name}](../../{where}/README.md)"


def differing(rows):
    """A table with a line for each claim that differs."""
    lines = ["| place | claim | result | example |", "|---|---|---|---|"]
    lines += [f"| {row['place']} | {row['claim']} | {row['why']} | {link(row['where'])} |" for row in rows
              if row["verdict"] == "differs"]
    return "\n".join(line.replace("*", r"\*") for line in lines) + "\n"


def page(source, rows):
    _, title, reference, conclusion = SOURCES[source]
    rows = [row for row in rows if row["source"] == source]
    counts = Counter(row["verdict"] for row in rows)
    return f"""# {title}

{conclusion}

{reference}.

| {' | '.join(VERDICTS)} | all |
|{'---|' * (len(VERDICTS) + 1)}
| {' | '.join(str(counts[verdict]) for verdict in VERDICTS)} | {len(rows)} |

[verdicts.csv](../../examples/verdicts.csv) lists every claim; `examples/verdicts.py` writes this page.

## Differs

{differing(rows)}"""


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--check", action="store_true", help="only report pages that are not current")
    check, rows, stale = options.parse_args().check, read(), []
    for source, (name, *_) in SOURCES.items():
        text, file = page(source, rows), SOURCE / name
        if check and (not file.exists() or file.read_text() != text):
            stale.append(name)
        elif not check:
            file.write_text(text)
            print(f"{name}: {words(text)} words")
    if stale:
        sys.exit(f"not current, run examples/verdicts.py: {', '.join(stale)}")


if __name__ == "__main__":
    main()
