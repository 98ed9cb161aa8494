# SPDX-License-Identifier: BSD-3-Clause
"""Runs hard particles with square wells through LAMMPS (in.hard_square_well), and reads events back:
what the tests of pair_style hard/squarewell share."""
import math
from collections import namedtuple
from pathlib import Path

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.thermo import thermo_columns

# As the style records it; time in steps from the start of step 1.
Recorded = namedtuple("Recorded", "step fraction kind i j")
KINDS = ("collision", "approach", "escape", "capture")


def density(mass, radius):
    """LAMMPS reads spheres in two dimensions too."""
    return mass / (4 * math.pi / 3 * radius**3)


def atom(x, v, radius=0.5, mass=1.0, kind=1, spin=(0.0, 0.0, 0.0)):
    return {"type": kind, "diameter": 2 * radius, "density": density(mass, radius), "x": x, "v": v,
            "omega": spin}


def counts(table):
    """Events so far by kind, from compute hard/events."""
    return {kind: table[f"c_events[{n}]"] for n, kind in enumerate(KINDS, 1)}


def script(folder, pair, style="", dimension=3, more=(), group="all", before=()):
    disc = " disc" if dimension == 2 else ""
    lines = [*before, f"pair_style hard/squarewell {style}", *(f"pair_coeff {line}" for line in pair),
             f"fix move {group} nve/sphere{disc}", *more]
    if dimension == 2:
        lines.append("fix flat all enforce2d")
    (Path(folder) / "interaction.txt").write_text("\n".join(lines) + "\n")


def start(folder, pair, dt, steps, style="", dimension=3, boundary="p p p", skin=0.5, every=None,
          more=(), group="all", before=(), restart=False, keep=0, **options):
    """Exit code and output of a run of what is in data.spheres."""
    script(folder, pair, style, dimension, more, group, before)
    return engine.start("in.hard_square_well", folder, dt=float(dt), steps=steps,
                        every=every or steps, dimension=dimension, boundary=boundary,
                        skin=float(skin), start="restart" if restart else "data", keep=keep,
                        **options)


def run(folder, pair, dt, steps, **options):
    """Snapshots (m, n, 13): id, x, v, spin, image; thermo columns; output."""
    code, output = start(folder, pair, dt, steps, **options)
    if code != 0:
        raise RuntimeError(f"LAMMPS ended with code {code}:\n{output[-3000:]}")
    return numpy.array(engine.dumps(folder, "path.txt")), thermo_columns(output), output


def recorded(folder, name="events.txt"):
    events = []
    for line in (Path(folder) / name).read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            step, fraction, kind, i, j = line.split()
            events.append(Recorded(int(step), float(fraction), kind, int(i), int(j)))
    return events


def times(events, dt):
    """[s] since the start; step n ends at n dt."""
    return numpy.array([(event.step - 1 + event.fraction) * dt for event in events])
