# SPDX-License-Identifier: BSD-3-Clause
"""Enters what a benchmark measures into a CSV file of docs/verification (option --csv), and what a test measures into
the file of that name in the folder COHESION_CSV."""
import csv
import fcntl
import math
import os
import re
from contextlib import contextmanager
from pathlib import Path

from cohesion_tests.theory.slow_ramp import DIVISIONS

OPTION = ("--csv", {"metavar": "FILE", "help": "enter the results into this table"})


def add_to(parser):
    """OPTION, to a parser of argparse."""
    parser.add_argument(OPTION[0], **OPTION[1])


def require_published(words, **published):
    """Ends the program where --csv would enter results of options that no column of the table has."""
    for name, value in published.items():
        if words.csv and getattr(words, name) != value:
            text = " ".join(map(str, value)) if isinstance(value, list) else value
            raise SystemExit(f"--csv: with --{name} {text}")


def of_test(table):
    """File of a table in the folder of the variable COHESION_CSV; none without."""
    folder = os.environ.get("COHESION_CSV")
    return Path(folder) / f"{table}.csv" if folder else None


@contextmanager
def locked(folder):
    """Against other processes that enter into files of the folder."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        yield
    finally:
        os.close(descriptor)


def enter(file, row, key=None, **measured):
    """Sets the columns `measured` of the row whose other columns, or those of `key`, are those of `row`, or empty; adds it
    at the end if the file has none. Without a file, nothing."""
    if file:
        file = Path(file).resolve()
        with locked(file.parent):
            enter_alone(file, row, key, measured)


def enter_alone(file, row, key, measured):
    with open(file, newline="") as lines:
        names, *rows = csv.reader(lines)
    unknown = (row.keys() | measured.keys()) - set(names)
    if unknown:
        raise ValueError(f"{file} has no column {sorted(unknown)}")
    wanted = [row.get(name, "") for name in names]
    kept = [n for n, name in enumerate(names) if (name in key if key else name not in measured)]
    found = next((one for one in rows if all(one[n] == wanted[n] for n in kept)), None)
    if found is None:
        rows.append(found := wanted)
    for name, value in measured.items():
        found[names.index(name)] = value
    new = file.with_name(file.name + ".new")
    with open(new, "w", newline="") as lines:
        csv.writer(lines, lineterminator="\n").writerows([names, *rows])
    os.replace(new, file)


def rows(file):
    """Dictionaries of a CSV file."""
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def enter_quantities(file, table, case, values):
    """Into a file of the columns table, case, quantity, value: {quantity: value} of a case."""
    for quantity, value in values.items():
        enter(file, {"table": table, "case": case, "quantity": quantity}, value=str(value))


def enter_pull_off(file, engine, restitution, loads):
    """Into contacts.csv: the range of the loads at separation over F_ad, if there are any."""
    if loads:
        enter(file, {"measurement": "pull-off", "case": f"{engine}, restitution {restitution:g}",
                     "step": f"t_c/{DIVISIONS[0]} to t_c/{DIVISIONS[-1]}", "quantity": "load at separation over F_ad"},
              value=f"{min(loads):.3f} to {max(loads):.3f}")


def power(value, digits=1):
    """With digits behind the point, and the exponent without zeros: 1.4e6."""
    return re.sub(r"e\+?(-?)0*(?=\d)", r"e\1", f"{value:.{digits}e}")


def figures(value, digits=2):
    """With so many significant digits: 2800, 0.0040, 2.2e6."""
    rounded = float(f"{value:.{digits}g}")
    if not 1e-3 <= abs(rounded) < 1e4:
        return power(value, digits - 1)
    return f"{rounded:.{max(0, digits - 1 - math.floor(math.log10(abs(rounded))))}f}"


def grouped(number):
    """Thousands apart, from 10,000 on."""
    return f"{number:,.0f}" if number >= 9999.5 else f"{number:.0f}"


def energy(engine, law, gas, contact, division, collisions):
    """Row of contact_energies.csv: what an energy balance misses in a gas (solid fraction, A, speed) of contacts
    (restitution, friction)."""
    (fraction, constant, speed), (restitution, friction) = gas, contact
    elastic = restitution == 1 and friction == 0 and law != "jkr"
    kind = "drift of the energy balance" if elastic else "energy balance over the loss"
    return {"quantity": f"{kind} after {collisions:g} collisions", "engine": engine, "scheme": "exact", "law": law,
            "solid fraction": f"{fraction:g}", "A [J]": f"{constant:g}", "speed [m/s]": f"{speed:g}",
            "restitution": f"{restitution:g}", "friction": f"{friction:g}", "step": f"t_c/{division:g}"}
