# SPDX-License-Identifier: BSD-3-Clause
"""Enters what a benchmark measures into a CSV file of docs/verification (option --csv)."""
import csv

OPTION = ("--csv", {"metavar": "FILE", "help": "enter the results into this table"})


def enter(file, row, **measured):
    """Sets the columns `measured` of the row whose other columns are those of `row`, or empty; adds it at the end if the
    file has none. Without a file, nothing."""
    if not file:
        return
    with open(file, newline="") as lines:
        names, *rows = csv.reader(lines)
    unknown = (row.keys() | measured.keys()) - set(names)
    if unknown:
        raise ValueError(f"{file} has no column {sorted(unknown)}")
    wanted = [row.get(name, "") for name in names]
    kept = [n for n, name in enumerate(names) if name not in measured]
    found = next((one for one in rows if all(one[n] == wanted[n] for n in kept)), None)
    if found is None:
        rows.append(found := wanted)
    for name, value in measured.items():
        found[names.index(name)] = value
    with open(file, "w", newline="") as lines:
        csv.writer(lines, lineterminator="\n").writerows([names, *rows])


def energy(engine, law, gas, contact, division, collisions):
    """Row of contact_energies.csv: what an energy balance misses in a gas (solid fraction, A, speed) of contacts
    (restitution, friction)."""
    (fraction, constant, speed), (restitution, friction) = gas, contact
    elastic = restitution == 1 and friction == 0 and law != "jkr"
    kind = "drift of the energy balance" if elastic else "energy balance over the loss"
    return {"quantity": f"{kind} after {collisions:g} collisions", "engine": engine, "scheme": "exact", "law": law,
            "solid fraction": f"{fraction:g}", "A [J]": f"{constant:g}", "speed [m/s]": f"{speed:g}",
            "restitution": f"{restitution:g}", "friction": f"{friction:g}", "step": f"t_c/{division:g}"}
